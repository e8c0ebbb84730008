#include "sim/lab/lab_plan.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

#include "data/input_error.h"
#include "sim/catalogue/instrument.h"
#include "sim/lab/liquid_volume.h"
#include "sim/runs/run_request.h"
#include "sim/runs/seeds.h"

namespace pendular {
namespace {

/// Number of grains of a run over that of the fidelity, so that the samples of the laboratory
/// differ in size from the samples of a calibration.
constexpr double size_ratio = 1.5;
/// Size of pilot runs over that of the fidelity, and their strain. Pilots may be small and short,
/// since bridge volumes are needed only to 3 %.
constexpr double pilot_share_of_beads = 0.5, pilot_strain = 1;
/// Checks that all values are positive and differ from each other by at least 5 %, which is more
/// than replicates differ.
/// @throws InputError where they do not
void demand_distinct(const std::vector<double>& values, const std::string& what) {
    for (std::size_t i = 0; i < values.size(); ++i) {
        if (!(values[i] > 0) || !std::isfinite(values[i])) {
            throw InputError(fmt::format("{} {:g}: it must be above 0", what, values[i]));
        }
        for (std::size_t k = 0; k < i; ++k) {
            if (std::abs(values[i] / values[k] - 1) < 0.05) {
                throw InputError(fmt::format(
                    "{} {:g} and {:g} are too close: values that differ by less than 5 % count as "
                    "equal; leave one out, or raise --replicates to measure it more often",
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
    if (!(plan.instrument.drift >= 0 && plan.instrument.drift <= largest_noise)) {
        throw InputError(fmt::format("--drift {:g} is not between 0 and {:g}",
                                     plan.instrument.drift, largest_noise));
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
        for (const PlannedRecording& recording : recordings_of(plan)) {
            for (const Condition& asked : recording.conditions) {
                const EffectiveCondition condition = imposed_condition(plan, asked);
                const double volume = first_bridge_volume(condition.liquid_content);
                check_run(run_at(plan, condition, volume));
                if (!condition.dry()) check_run(pilot_at(plan, condition, volume));
            }
        }
    } catch (const std::invalid_argument& error) {
        throw InputError(error.what());
    }
}

/// Whether an effect of type ChangeCondition leaves the runs of a plan unchanged, such as a
/// negative contact angle, which is limited to 0. The effect is tried at two normal stresses [Pa]
/// and at three times [s], since its change may begin or end with time. Returns false for an effect
/// that is always on, which may have its present value.
bool changes_nothing(const LabPlan& plan, const ActiveEffect& active) {
    if (!active.effect->of_condition() || active.effect->given_by_liquid) {
        return false;
    }
    const auto same_run = [&](const Condition& asked) {
        const auto run = [&](const std::vector<ActiveEffect>& effects) {
            const EffectiveCondition condition = changed_condition(asked, effects, plan.liquid);
            return run_description(run_at(plan, condition, 1e-3));
        };
        return !touches(*active.effect, asked) || run({active}) == run({});
    };
    for (const double content : contents_of(plan)) {
        for (const double stress : {500.0, 2000.0}) {
            for (const double time : {0.0, 10.0, 3600.0}) {
                if (!same_run({.normal_stress = stress, .liquid_content = content, .time = time}))
                    return false;
            }
        }
    }
    return true;
}

/// Checks the effects of a plan.
/// @throws InputError for an effect that is not simulated or that changes no recording
void check_effects(const LabPlan& plan) {
    for (const ActiveEffect& active : plan.effects) {
        const std::string what = to_string(active);
        if (const std::string why = why_not_in_lab(*active.effect); !why.empty()) {
            throw InputError(what + " " + why);
        }
        if (active.effect->touches == Touches::wet && plan.liquid_contents.empty()) {
            throw InputError(fmt::format(
                "{} acts on wet grains only, and there are no wet recordings; leave it out, or "
                "record wet grains too",
                what));
        }
        if (changes_nothing(plan, active)) {
            throw InputError(fmt::format("{} changes nothing here; give another value", what));
        }
    }
}

}  // namespace

std::string why_not_in_lab(const Effect& effect) {
    if (effect.of_instrument() || effect.of_grains() || effect.of_condition()) return "";
    return "cannot be hidden in a virtual laboratory: it changes how readings are predicted, not "
           "how "
           "the grains flow";
}

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

std::vector<double> contents_of(const LabPlan& plan) {
    std::vector<double> contents = {0};
    contents.insert(contents.end(), plan.liquid_contents.begin(), plan.liquid_contents.end());
    return contents;
}

std::vector<PlannedRecording> recordings_of(const LabPlan& plan) {
    std::vector<PlannedRecording> recordings;
    const auto width = std::to_string(plan.replicates).size();
    double now = 0;  // recordings follow one another
    for (const double content : contents_of(plan)) {
        for (int replicate = 1; replicate <= plan.replicates; ++replicate) {
            const std::string kind = content > 0 ? fmt::format("wet_{:g}", content) : "dry";
            PlannedRecording recording{
                .file = fmt::format("{}_{:0{}}.csv", kind, replicate, width),
                .liquid_content = content,
                .replicate = replicate,
                .seed = seed_of_run(plan.seed, recordings.size(), SeedDomain::instrument),
                .conditions = conditions_of(plan, content)};
            now += time_steps(recording.conditions, plan.grains, plan.instrument, now);
            recordings.push_back(std::move(recording));
        }
    }
    return recordings;
}

namespace {

/// Returns the true state at the requested condition; see `truth_at_set_points`.
/// @throws InputError where no true state is shown as the requested condition
CellState truth_of(const LabPlan& plan, const Condition& asked, const FlowPoint& flow,
                   const InstrumentMap& map) {
    try {
        return truth_at_set_points(asked, flow, map, plan.cell, plan.grains);
    } catch (const std::domain_error& error) {
        throw InputError(
            fmt::format("at a normal stress of {:g} Pa: {}", asked.normal_stress, error.what()));
    }
}

InstrumentMap map_of(const LabPlan& plan, const Condition& asked) {
    return InstrumentMap(touching(plan.effects, asked));
}

}  // namespace

EffectiveCondition imposed_condition(const LabPlan& plan, const Condition& asked) {
    constexpr FlowPoint typical{.stress_ratio = 0.3, .solid_fraction = 0.6};
    Condition condition = asked;
    if (const InstrumentMap map = map_of(plan, asked); !map.empty()) {
        condition = true_condition(asked, truth_of(plan, asked, typical, map), map);
    }
    return changed_condition(std::move(condition), plan.effects, plan.liquid);
}

std::function<CellState(double)> shown_over_time(const LabPlan& plan, const Condition& asked,
                                                 const FlowPoint& flow) {
    InstrumentMap map = map_of(plan, asked);
    CellState truth = truth_of(plan, asked, flow, map);
    return [map = std::move(map), truth](double time) {
        CellState now = truth;
        now.time = time;
        return map.show(now);
    };
}

namespace {

/// Returns the effects on grains of a condition, with values in the units of its runs.
std::vector<EffectValues> run_effects(const LabPlan& plan, const EffectiveCondition& condition) {
    std::vector<EffectValues> effects;
    for (const EffectValues& values : condition.grain_effects) {
        effects.push_back(in_run_units(values, condition.normal_stress, plan.grains));
    }
    return effects;
}

}  // namespace

dem::RunParameters run_at(const LabPlan& plan, const EffectiveCondition& condition,
                          double bridge_volume) {
    dem::RunParameters run{
        .friction = plan.friction + condition.friction_difference,
        .inertial_number = condition.inertial_number,
        .stiffness_number = plan.fidelity.stiffness_number,
        .poisson_ratio = plan.grains.poisson_ratio,
        .wetting = {},
        .grains = static_cast<int>(std::lround(size_ratio * plan.fidelity.grains)),
        .strain = plan.fidelity.strain,
        .effects = run_effects(plan, condition)};
    if (!condition.dry()) {
        const Liquid liquid = condition.liquid.value_or(plan.liquid);
        run.wetting = dem::Wetting{
            .reduced_pressure = reduced_pressure(condition.normal_stress, plan.grains, liquid),
            .bridge_volume = bridge_volume};
    }
    return run;
}

dem::RunParameters pilot_at(const LabPlan& plan, const EffectiveCondition& condition,
                            double bridge_volume) {
    dem::RunParameters run = run_at(plan, condition, bridge_volume);
    run.grains = static_cast<int>(std::lround(pilot_share_of_beads * plan.fidelity.grains));
    run.strain = pilot_strain;
    return run;
}

void check_plan(const LabPlan& plan) {
    if (plan.dry_normal_stresses.empty() || plan.inertial_numbers.empty()) {
        throw InputError("there is nothing to measure: give normal stresses and inertial numbers");
    }
    demand_distinct(plan.dry_normal_stresses, "dry normal stress");
    demand_distinct(plan.wet_normal_stresses, "wet normal stress");
    demand_distinct(plan.liquid_contents, "liquid content");
    demand_distinct(plan.inertial_numbers, "inertial number");
    check_cell(plan);
    check_instrument(plan);
    check_effects(plan);
    check_runs(plan);
}

}  // namespace pendular
