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
    Options options("simulate [options]",
                    "Shears a random sample of dry monosized beads at constant normal stress until "
                    "it is steady, and\n"
                    "prints time averages with standard errors. Numbers are raw: at the stiffness "
                    "number simulated.",
                    "  pendular simulate --friction 0.09 --inertial-number 0.003\n"
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
    std::int64_t seed = 1;
    options.add("seed", &seed, "seed of the random initial state (default 1)");
    const auto common = options.parse(arguments);
    if (!common) {
        return done;
    }
    const auto& f = common->fidelity;
    run.seed = checked_seed(seed);
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
