#include "sim/lab/lab_checks.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <string>

#include "data/input_error.h"
#include "data/recordings/recording.h"
#include "sim/lab/lab_plan.h"
#include "sim/runs/run_request.h"

namespace pendular {
namespace {

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
    // Shear bands are 5 to 10 diameters wide (`few_beads`): in fewer layers, all is wall.
    constexpr double fewest_layers = 5, loose = 0.6;
    const AnnularCell& cell = plan.cell;
    const double diameter = plan.grains.diameter;
    if (!(plan.cell.bead_volume > 0)) {
        throw InputError("the bead mass must be above 0");
    }
    if (!(cell.inner_radius >= 0 && cell.outer_radius > cell.inner_radius)) {
        throw InputError(
            fmt::format("an outer radius of {:g} mm is not above the inner radius of {:g} mm",
                        1e3 * cell.outer_radius, 1e3 * cell.inner_radius));
    }
    if (const double width = cell.outer_radius - cell.inner_radius;
        width < fewest_layers * diameter) {
        throw InputError(fmt::format(
            "the annulus is {:.3g} mm wide, less than {:g} diameters of beads of {:.3g} mm; use "
            "smaller beads or a wider cell",
            1e3 * width, fewest_layers, 1e3 * diameter));
    }
    if (height(loose, plan.cell) < fewest_layers * plan.grains.diameter) {
        throw InputError(
            fmt::format("a bead mass of {:g} g fills the cell to {:.2g} mm, less than {:g} bead "
                        "diameters; use more beads",
                        1e3 * plan.cell.bead_volume * plan.grains.density,
                        1e3 * height(loose, plan.cell), fewest_layers));
    }
}

/// @throws InputError where a value of the instrument is outside of its range; `option` names it
void demand_between(const char* option, double value, double lower, double upper) {
    if (!(value >= lower && value <= upper)) {
        throw InputError(
            fmt::format("{} {:g} is not between {:g} and {:g}", option, value, lower, upper));
    }
}

void check_noise(const Instrument& instrument) {
    // Chosen: beyond these, readings tell nothing, and the number is probably a percentage.
    constexpr double largest_noise = 10, largest_error = 0.5, longest_correlation = 10;
    demand_between("--noise", instrument.noise, 0, largest_noise);
    demand_between("--drift", instrument.drift, 0, largest_noise);
    demand_between("--torque-scatter", instrument.torque_error, 0, largest_error);
    demand_between("--solid-fraction-scatter", instrument.solid_fraction_error, 0, largest_error);
    demand_between("--force-scatter", instrument.force_noise, 0, largest_error);
    demand_between("--scatter-within-steps", instrument.share_within, 0, 1);
    demand_between("--torque-drift", instrument.torque_drift.value_or(0), 0, largest_error);
    demand_between("--gap-drift", instrument.gap_drift.value_or(0), 0, largest_error);
    demand_between("--force-drift", instrument.force_drift.value_or(0), 0, largest_error);
    for (const double strain : {instrument.torque_correlation, instrument.gap_correlation,
                                instrument.force_correlation}) {
        demand_between("--correlation-strain", strain, 0, longest_correlation);
    }
}

void check_instrument(const LabPlan& plan) {
    // Shorter steps than 20 rows are no steps to `import`, which also needs a strain of 1 after the
    // transient.
    constexpr int fewest_rows = shortest_step, most_rows = 100'000, most_replicates = 99;
    constexpr double least_strain = 2, most_strain = 1000;
    check_noise(plan.instrument);
    demand_between("--step-strain", plan.instrument.step_strain, least_strain, most_strain);
    if (plan.instrument.rows < fewest_rows || plan.instrument.rows > most_rows) {
        throw InputError(fmt::format("--rows {} is not between {} and {}", plan.instrument.rows,
                                     fewest_rows, most_rows));
    }
    for (const LabSeries& series : series_of(plan)) {
        if (series.replicates < 1 || series.replicates > most_replicates) {
            throw InputError(fmt::format("--replicates {} is not between 1 and {}",
                                         series.replicates, most_replicates));
        }
    }
}

/// Checks the runs of one step.
/// @throws InputError, std::invalid_argument where they cannot be simulated
void check_runs_of(const LabPlan& plan, const Condition& asked) {
    const EffectiveCondition condition = imposed_condition(plan, asked);
    const double volume = first_bridge_volume(condition.liquid_content);
    check_run(run_at(plan, condition, volume));
    if (!condition.dry()) check_run(pilot_at(plan, condition, volume));
}

void check_runs(const LabPlan& plan) {
    for (const PlannedRecording& recording : recordings_of(plan)) {
        for (std::size_t k = 0; k < recording.conditions.size(); ++k) {
            const Condition& asked = recording.conditions[k];
            try {
                check_runs_of(plan, asked);
            } catch (const std::invalid_argument& error) {
                const double speed = recording.angular_velocities[k];
                if (speed == 0) throw InputError(error.what());
                throw InputError(
                    fmt::format("at {:.4g} rpm and {:g} Pa: {}; use another speed or normal stress",
                                speed * 30 / std::numbers::pi, asked.normal_stress, error.what()));
            }
        }
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
        const auto contents = contents_of(plan);
        if (active.effect->touches == Touches::wet && *std::ranges::max_element(contents) == 0) {
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

void check_plan(const LabPlan& plan) {
    const bool speeds = !plan.angular_velocities.empty();
    if (plan.series.empty() &&
        (plan.dry_normal_stresses.empty() || (plan.inertial_numbers.empty() && !speeds))) {
        throw InputError("there is nothing to measure: give normal stresses and inertial numbers");
    }
    demand_distinct(plan.dry_normal_stresses, "dry normal stress");
    demand_distinct(plan.wet_normal_stresses, "wet normal stress");
    demand_distinct(plan.liquid_contents, "liquid content");
    demand_distinct(plan.inertial_numbers, "inertial number");
    demand_distinct(plan.angular_velocities, "angular velocity [rad/s]");
    check_cell(plan);
    check_instrument(plan);
    check_effects(plan);
    check_runs(plan);
}

}  // namespace pendular
