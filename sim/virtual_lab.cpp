#include "sim/virtual_lab.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include "data/input_error.h"
#include "data/robust.h"
#include "sim/liquid_volume.h"
#include "sim/seeds.h"

namespace pendular {
namespace {

/// Beads of a run over the fidelity's: a sample of another size than those fitted to it.
constexpr double size_ratio = 1.5;
/// Bridge volumes are wanted within 3 %, so pilots may be small and short.
constexpr double pilot_share_of_beads = 0.5, pilot_strain = 1;
constexpr int most_attempts = 4;

/// Condition of every step of one recording, in the order measured.
std::vector<Condition> conditions_of(const LabPlan& plan, double liquid_content) {
    std::vector<Condition> conditions;
    for (const double stress :
         liquid_content > 0 ? plan.wet_normal_stresses : plan.dry_normal_stresses) {
        for (const double inertial_number : plan.inertial_numbers) {
            conditions.push_back({.normal_stress = stress,
                                  .inertial_number = inertial_number,
                                  .liquid_content = liquid_content,
                                  .height = {}});
        }
    }
    return conditions;
}

/// Dry, then each liquid content.
std::vector<double> contents_of(const LabPlan& plan) {
    std::vector<double> contents = {0};
    contents.insert(contents.end(), plan.liquid_contents.begin(), plan.liquid_contents.end());
    return contents;
}

dem::RunParameters run_at(const LabPlan& plan, const Condition& condition, double bridge_volume) {
    dem::RunParameters run{.friction = plan.friction,
                           .inertial_number = condition.inertial_number,
                           .stiffness_number = plan.fidelity.stiffness_number,
                           .poisson_ratio = plan.grains.poisson_ratio,
                           .wetting = {},
                           .beads = static_cast<int>(std::lround(size_ratio * plan.fidelity.beads)),
                           .strain = plan.fidelity.strain};
    if (!condition.dry()) {
        run.wetting = dem::Wetting{
            .reduced_pressure = reduced_pressure(condition.normal_stress, plan.grains, plan.liquid),
            .bridge_volume = bridge_volume};
    }
    return run;
}

dem::RunParameters pilot_at(const LabPlan& plan, const Condition& condition, double bridge_volume) {
    dem::RunParameters run = run_at(plan, condition, bridge_volume);
    run.beads = static_cast<int>(std::lround(pilot_share_of_beads * plan.fidelity.beads));
    run.strain = pilot_strain;
    return run;
}

/// The runs of one laboratory, whose seeds follow one another.
class Runs {
  public:
    Runs(const LabPlan& plan, const Workers& workers) : seed_(plan.seed), workers_(workers) {}

    /// Carries out runs with fresh seeds, and again, with others, those that `complaint` finds
    /// unusable.
    template <typename Complaint>
    std::vector<dem::RunResult> carry_out(std::vector<dem::RunParameters> runs,
                                          const Complaint& complaint) {
        std::vector<dem::RunResult> results(runs.size());
        std::vector<std::size_t> which(runs.size());
        for (std::size_t k = 0; k < which.size(); ++k) {
            which[k] = k;
        }
        for (int attempt = 1; !which.empty(); ++attempt) {
            std::vector<dem::RunParameters> batch;
            for (const std::size_t k : which) {
                runs[k].seed = seed_of_run(seed_, ordered_++, SeedDomain::virtual_lab);
                batch.push_back(runs[k]);
            }
            const auto done = run_all(batch, workers_);
            std::vector<std::size_t> again;
            for (std::size_t i = 0; i < which.size(); ++i) {
                results[which[i]] = done[i];
                if (const std::string why = complaint(done[i]); !why.empty()) {
                    note_or_give_up(done[i].parameters, why, attempt);
                    again.push_back(which[i]);
                }
            }
            which = std::move(again);
        }
        return results;
    }

    const std::vector<std::string>& notes() const { return notes_; }

  private:
    void note_or_give_up(const dem::RunParameters& p, const std::string& why, int attempt) {
        const std::string what = fmt::format(
            "a run at inertial number {:g}{} {}", p.inertial_number,
            p.wetting ? fmt::format(", reduced pressure {:.3g}", p.wetting->reduced_pressure) : "",
            why);
        if (attempt == most_attempts) {
            throw dem::SimulationError(
                fmt::format("{}; {} runs of other seeds were no better; leave the condition out, "
                            "or use a higher "
                            "friction or fidelity",
                            what, attempt - 1));
        }
        notes_.push_back(what + "; it was made again with another seed");
    }

    std::uint64_t seed_;
    const Workers& workers_;
    std::uint64_t ordered_ = 0;
    std::vector<std::string> notes_;
};

std::string failed_or_crystallised(const dem::RunResult& run) {
    return !run.failure.empty() ? "failed: " + run.failure : run.crystallised ? "crystallised" : "";
}

std::string unusable(const dem::RunResult& run) {
    const std::string why = failed_or_crystallised(run);
    return why.empty() && !run.steady ? "was never steady" : why;
}

/// Recordings without their runs yet.
std::vector<LabRecording> planned_recordings(const LabPlan& plan) {
    std::vector<LabRecording> recordings;
    const auto width = std::to_string(plan.replicates).size();
    for (const double content : contents_of(plan)) {
        for (int replicate = 1; replicate <= plan.replicates; ++replicate) {
            const std::string kind = content > 0 ? fmt::format("wet_{:g}", content) : "dry";
            LabRecording recording{
                .file = fmt::format("{}_{:0{}}.csv", kind, replicate, width),
                .liquid_content = content,
                .replicate = replicate,
                .seed = seed_of_run(plan.seed, recordings.size(), SeedDomain::instrument)};
            for (const Condition& condition : conditions_of(plan, content)) {
                recording.steps.push_back({condition, {}});
            }
            recordings.push_back(std::move(recording));
        }
    }
    return recordings;
}

/// Bridge volume of every wet condition, contents outermost, found by pilots.
std::vector<double> find_bridge_volumes(const LabPlan& plan, Runs& runs, LabResult& result,
                                        const AnnouncePhase& announce) {
    std::vector<Condition> conditions;
    std::vector<double> contents;
    for (const double content : plan.liquid_contents) {
        for (const Condition& condition : conditions_of(plan, content)) {
            conditions.push_back(condition);
            contents.push_back(content);
        }
    }
    if (conditions.empty()) {
        return {};
    }
    return bridge_volumes(contents, [&](std::span<const std::size_t> which,
                                        std::span<const double> volumes) {
        announce(result.pilots == 0 ? "pilot runs for the liquid contents" : "second pilot runs");
        std::vector<dem::RunParameters> pilots;
        for (std::size_t i = 0; i < which.size(); ++i) {
            pilots.push_back(pilot_at(plan, conditions[which[i]], volumes[i]));
        }
        result.pilots += pilots.size();
        std::vector<double> found;
        for (const auto& run : runs.carry_out(pilots, failed_or_crystallised)) {
            found.push_back(run[dem::Observable::liquid_content].value);
        }
        return found;
    });
}

/// Typical standard error of an observable in the laboratory's runs, relative [1]: the median,
/// since the error of one run is itself known from few independent samples only.
double typical_error(const LabResult& result, dem::Observable which) {
    std::vector<double> errors;
    for (const LabRecording& recording : result.recordings) {
        for (const LabStep& step : recording.steps) {
            errors.push_back(step.run[which].standard_error / step.run[which].value);
        }
    }
    return median(errors);
}

/// Runs that scatter more than the whole recording was to.
void note_scatter(LabResult& result) {
    const double noise = result.plan.instrument.noise;
    const double torque = typical_error(result, dem::Observable::stress_ratio);
    const double fraction = typical_error(result, dem::Observable::solid_fraction);
    if (torque > noise * torque_scatter || fraction > noise * solid_fraction_scatter) {
        result.notes.push_back(fmt::format(
            "the simulations alone scatter by {:.2g} % in torque and {:.2g} % in solid fraction, "
            "where --noise {:g} asks for {:g} and {:g} % in all; a higher fidelity scatters less",
            100 * torque, 100 * fraction, noise, 100 * noise * torque_scatter,
            100 * noise * solid_fraction_scatter));
    }
}

void note_merging_bridges(LabResult& result) {
    double largest = 0;
    for (const LabRecording& recording : result.recordings) {
        for (const LabStep& step : recording.steps) {
            const auto& wetting = step.run.parameters.wetting;
            largest = std::max(largest, wetting ? wetting->bridge_volume : 0);
        }
    }
    if (largest > dem::largest_pendular_volume) {
        result.notes.push_back(fmt::format(
            "bridge volumes reach {:.2g} a^3; above {:g} a^3 the bridges between three beads in "
            "contact merge: the model holds for separate bridges",
            largest, dem::largest_pendular_volume));
    }
}

/// Every pair must differ by more than replicates do.
void demand_distinct(const std::vector<double>& values, const std::string& what) {
    for (std::size_t i = 0; i < values.size(); ++i) {
        if (!(values[i] > 0) || !std::isfinite(values[i])) {
            throw InputError(fmt::format("{} {:g}: it must be above 0", what, values[i]));
        }
        for (std::size_t k = 0; k < i; ++k) {
            if (std::abs(values[i] / values[k] - 1) < 0.05) {
                throw InputError(
                    fmt::format("{} {:g} and {:g} are too close: what differs by less than 5 % "
                                "may pass for the same; leave one out, or raise --replicates to "
                                "measure it more often",
                                what, values[k], values[i]));
            }
        }
    }
}

void check_cell(const LabPlan& plan) {
    constexpr double fewest_layers = 5, loose = 0.6;
    if (!(plan.cell.bead_volume > 0)) {
        throw InputError("the bead mass must be above 0");
    }
    if (height(loose, plan.cell) < fewest_layers * plan.grains.diameter) {
        throw InputError(
            fmt::format("a bead mass of {:g} g fills the cell to {:.2g} mm, less than {:g} bead "
                        "diameters; use more beads",
                        1e3 * plan.cell.bead_volume * plan.grains.density,
                        1e3 * height(loose, plan.cell), fewest_layers));
    }
}

void check_instrument(const LabPlan& plan) {
    constexpr double largest_noise = 10;
    constexpr int fewest_rows = 200, most_rows = 100'000, most_replicates = 99;
    if (!(plan.instrument.noise >= 0 && plan.instrument.noise <= largest_noise)) {
        throw InputError(fmt::format("--noise {:g} is not between 0 and {:g}",
                                     plan.instrument.noise, largest_noise));
    }
    if (plan.instrument.rows < fewest_rows || plan.instrument.rows > most_rows) {
        throw InputError(fmt::format("--rows {} is not between {} and {}", plan.instrument.rows,
                                     fewest_rows, most_rows));
    }
    if (plan.replicates < 1 || plan.replicates > most_replicates) {
        throw InputError(fmt::format("--replicates {} is not between 1 and {}", plan.replicates,
                                     most_replicates));
    }
}

void check_runs(const LabPlan& plan) {
    try {
        for (const double content : contents_of(plan)) {
            const double volume = first_bridge_volume(content);
            for (const Condition& condition : conditions_of(plan, content)) {
                check(run_at(plan, condition, volume));
                if (!condition.dry()) check(pilot_at(plan, condition, volume));
            }
        }
    } catch (const std::invalid_argument& error) {
        throw InputError(error.what());
    }
}

std::string names_of_fidelities(double stiffness_number) {
    std::vector<std::string> names;
    for (const Fidelity& f : fidelities()) {
        if (f.stiffness_number == stiffness_number) names.push_back(f.name);
    }
    return fmt::format("{}", fmt::join(names, ", "));
}

std::string study_toml(const LabResult& result) {
    const LabPlan& plan = result.plan;
    const double kappa = plan.fidelity.stiffness_number;
    std::string text = fmt::format(
        "# Recordings of a virtual laboratory: simulated beads as an annular cell would have shown "
        "them.\n\n"
        "[grains]\n"
        "diameter = \"{:.7g} um\"\n"
        "density = \"{:.7g} kg/m^3\"\n"
        "poisson_ratio = {:.7g}\n"
        "# No youngs_modulus: the beads were simulated at stiffness number {:g}, whatever the "
        "normal stress.\n"
        "# Use a fidelity that shares it ({}).\n\n",
        1e6 * plan.grains.diameter, plan.grains.density, plan.grains.poisson_ratio, kappa,
        names_of_fidelities(kappa));
    if (!plan.liquid_contents.empty()) {
        text += fmt::format(
            "[liquid]\n"
            "surface_tension = \"{:.7g} mN/m\"\n"
            "contact_angle = \"{:.7g} deg\"\n\n",
            1e3 * plan.liquid.surface_tension, plan.liquid.contact_angle * 180 / std::numbers::pi);
    }
    text += fmt::format(
        "[cell]\n"
        "inner_radius = \"{:.7g} mm\"\n"
        "outer_radius = \"{:.7g} mm\"\n"
        "bead_mass = \"{:.7g} g\"           # weightless: normal stress is normal force over "
        "area\n",
        1e3 * plan.cell.inner_radius, 1e3 * plan.cell.outer_radius,
        1e3 * plan.cell.bead_volume * plan.grains.density);
    for (const double content : contents_of(plan)) {
        text += content > 0 ? fmt::format(
                                  "\n[[recording]]\nfile = \"wet_{0:g}_*.csv\"\n"
                                  "liquid_content = {0:g}\n",
                                  content)
                            : "\n[[recording]]\nfile = \"dry_*.csv\"\nliquid_content = 0.0\n";
    }
    return text +
           "\n[model]\nbase = \"dem\"\ncalibrate = [\"friction\"]\nfit_to = \"dry\"\n"
           "effects = []\n";
}

/// What a step is to show, with the laboratory's typical errors.
TrueState true_state(const LabStep& step, double ratio_error, double fraction_error) {
    Mean ratio = step.run[dem::Observable::stress_ratio];
    Mean fraction = step.run[dem::Observable::solid_fraction];
    ratio.standard_error = ratio_error * ratio.value;
    fraction.standard_error = fraction_error * fraction.value;
    return {step.condition, ratio, fraction};
}

}  // namespace

void check(const LabPlan& plan) {
    if (plan.dry_normal_stresses.empty() || plan.inertial_numbers.empty()) {
        throw InputError("nothing to measure: name normal stresses and inertial numbers");
    }
    demand_distinct(plan.dry_normal_stresses, "dry normal stress");
    demand_distinct(plan.wet_normal_stresses, "wet normal stress");
    demand_distinct(plan.liquid_contents, "liquid content");
    demand_distinct(plan.inertial_numbers, "inertial number");
    check_cell(plan);
    check_instrument(plan);
    check_runs(plan);
}

LabResult simulate_lab(const LabPlan& plan, const Workers& workers, const AnnouncePhase& announce) {
    check(plan);
    const AnnouncePhase tell = announce ? announce : [](const std::string&) {};
    LabResult result{.plan = plan, .recordings = planned_recordings(plan)};
    Runs runs(plan, workers);
    const std::vector<double> volumes = find_bridge_volumes(plan, runs, result, tell);

    // Each content's conditions have their volumes in a row, the same for every replicate.
    std::vector<dem::RunParameters> wanted;
    std::size_t first_volume = 0;
    for (const LabRecording& recording : result.recordings) {
        const bool wet = recording.liquid_content > 0;
        for (std::size_t k = 0; k < recording.steps.size(); ++k) {
            wanted.push_back(
                run_at(plan, recording.steps[k].condition, wet ? volumes[first_volume + k] : 0));
        }
        if (wet && recording.replicate == plan.replicates) {
            first_volume += recording.steps.size();
        }
    }
    tell("recordings");
    const auto done = runs.carry_out(wanted, unusable);
    auto next = done.begin();
    for (LabRecording& recording : result.recordings) {
        for (LabStep& step : recording.steps) {
            step.run = *next++;
        }
    }
    result.notes = runs.notes();
    note_scatter(result);
    note_merging_bridges(result);
    return result;
}

std::map<std::string, std::string> study_files(const LabResult& result) {
    const double ratio_error = typical_error(result, dem::Observable::stress_ratio);
    const double fraction_error = typical_error(result, dem::Observable::solid_fraction);
    std::map<std::string, std::string> files = {{"study.toml", study_toml(result)}};
    for (const LabRecording& recording : result.recordings) {
        std::vector<TrueState> states;
        for (const LabStep& step : recording.steps) {
            states.push_back(true_state(step, ratio_error, fraction_error));
        }
        files[recording.file] = recording_csv(record(states, result.plan.cell, result.plan.grains,
                                                     result.plan.instrument, recording.seed));
    }
    return files;
}

}  // namespace pendular
