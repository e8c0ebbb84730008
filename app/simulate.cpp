#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "app/command.h"
#include "app/console.h"
#include "app/interrupt.h"
#include "app/options.h"
#include "data/input_error.h"
#include "data/quantity.h"
#include "reports/json.h"
#include "sim/dem/run.h"

namespace pendular::app {
namespace {

void print_result(Console& console, const dem::RunResult& run) {
    const auto& p = run.parameters;
    console.line(
        fmt::format("stress ratio {}, solid fraction {} at friction {:g}, inertial number {:g}, "
                    "stiffness number {:g}",
                    with_error(run[dem::Observable::stress_ratio].value,
                               run[dem::Observable::stress_ratio].standard_error),
                    with_error(run[dem::Observable::solid_fraction].value,
                               run[dem::Observable::solid_fraction].standard_error),
                    p.friction, p.inertial_number, p.stiffness_number));
    if (p.wetting) {
        console.line(fmt::format(
            "reduced pressure {:g}, bridge volume {:g} a^3: liquid content {}, {} of it in bridges "
            "without contact",
            p.wetting->reduced_pressure, p.wetting->bridge_volume,
            with_error(run[dem::Observable::liquid_content].value,
                       run[dem::Observable::liquid_content].standard_error),
            fmt::format("{:.0f} %", 100 * run[dem::Observable::distant_coordination].value /
                                        (run[dem::Observable::distant_coordination].value +
                                         run[dem::Observable::contact_coordination].value))));
        if (p.wetting->bridge_volume > dem::largest_pendular_volume) {
            console.note(fmt::format(
                "a bridge volume of {:g} a^3 is above {:g} a^3, where the bridges between three "
                "beads in contact merge: the model holds for separate bridges",
                p.wetting->bridge_volume, dem::largest_pendular_volume));
        }
    }
    if (run.crystallised) {
        console.note(
            "the sample crystallised: its averages are not those of a random packing; use another "
            "seed, "
            "more beads or a higher friction");
    }
    if (!run.steady) {
        console.note("no steady state was found within the strain simulated; raise --strain");
    }
    for (std::size_t k = 0; k < dem::observable_count; ++k) {
        if (!p.wetting && dem::needs_bridges(static_cast<dem::Observable>(k))) {
            continue;
        }
        const auto& about = quantity(dem::observable_names[k]);
        console.line(fmt::format("  {:<32} {:<22} {}", about.name,
                                 with_error(run.means[k].value, run.means[k].standard_error),
                                 about.meaning));
    }
    console.line(
        fmt::format("{} beads, strain {:.2f} averaged after a transient of {:.2f}, {} steps of "
                    "{:.3g} sqrt(m/(a "
                    "s22)), {:.1f} s, {:.3g} bead-steps/s",
                    p.beads, run.strain_averaged, run.strain_transient, run.steps, run.time_step,
                    run.wall_seconds, run.particle_steps_per_second()));
}

}  // namespace

int simulate(const std::vector<std::string>& arguments) {
    dem::RunParameters run;
    Options options(
        "simulate [options]",
        "Shears a random sample of monosized beads, dry or joined by liquid bridges, at "
        "constant normal\n"
        "stress until it is steady, and prints time averages with standard errors. "
        "Numbers are raw: at the\n"
        "stiffness number simulated.",
        "  pendular simulate --friction 0.09 --inertial-number 0.003\n"
        "  pendular simulate --reduced-pressure 3 --bridge-volume 0.002\n"
        "  pendular simulate --fidelity quick --friction 0.3 --json run.json\n",
        false);
    options.add("friction", &run.friction, "intergranular friction coefficient [1] (default 0.09)");
    options.add("inertial-number", &run.inertial_number,
                "shear rate times sqrt(m/(a s22)) [1] (default: the fidelity's lowest)");
    options.add("stiffness-number", &run.stiffness_number,
                "(E/(1 - nu^2)/s22)^(2/3) [1] (default: the fidelity's)");
    options.add("poisson-ratio", &run.poisson_ratio,
                "Poisson ratio of the beads [1] (default 0.3)");
    options.add("damping", &run.damping,
                "normal viscous damping, fraction of critical [1] (default 0.98)");
    options.add("beads", &run.beads, "number of beads (default: the fidelity's)");
    options.add("strain", &run.strain,
                "averaged strain, after the transient [1] (default: the fidelity's)");
    dem::Wetting wetting{.bridge_volume = 2e-3};
    std::string bridge_force = to_string(Form::derived);
    options.add("reduced-pressure", &wetting.reduced_pressure,
                "P* = a^2 s22/F0 of wet beads [1] (default: dry)");
    options.add("bridge-volume", &wetting.bridge_volume,
                "volume of a liquid bridge over a^3 [1] (default 0.002)");
    options.add("bridge-force", &bridge_force,
                "form of the bridge force: derived (default) or as_printed");
    std::int64_t seed = 1;
    options.add("seed", &seed, "seed of the random initial state (default 1)");
    const auto common = options.parse(arguments);
    if (!common) {
        return done;
    }
    const auto& f = common->fidelity;
    run.seed = checked_seed(seed);
    wetting.bridge_force = form_named(bridge_force);
    if (options.given("reduced-pressure")) {
        run.wetting = wetting;
    } else if (options.given("bridge-volume") || options.given("bridge-force")) {
        throw InputError(
            "--bridge-volume and --bridge-force need --reduced-pressure: without it the beads are "
            "dry");
    }
    run.inertial_number =
        options.given("inertial-number") ? run.inertial_number : f.lowest_inertial_number;
    run.stiffness_number =
        options.given("stiffness-number") ? run.stiffness_number : f.stiffness_number;
    run.beads = options.given("beads") ? run.beads : f.beads;
    run.strain = options.given("strain") ? run.strain : f.strain;

    const InterruptGuard guard;
    Console console(*common);
    dem::RunResult result;
    try {
        result = run_all({run}, {1, guard.token(), [&](const EnsembleProgress& p) {
                                     console.progress("simulating", p);
                                 }})[0];
    } catch (const std::invalid_argument& error) {
        throw InputError(error.what());
    }
    if (!result.failure.empty()) {
        throw dem::SimulationError(result.failure);
    }
    print_result(console, result);
    console.json(to_json(result));
    return done;
}

}  // namespace pendular::app
