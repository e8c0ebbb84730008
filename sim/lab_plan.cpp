#include "sim/lab_plan.h"

#include <fmt/format.h>

#include <cmath>
#include <stdexcept>
#include <string>

#include "data/input_error.h"
#include "sim/liquid_volume.h"

namespace pendular {
namespace {

/// Beads of a run over the fidelity's: a sample of another size than those fitted to it.
constexpr double size_ratio = 1.5;
/// Bridge volumes are wanted within 3 %, so pilots may be small and short.
constexpr double pilot_share_of_beads = 0.5, pilot_strain = 1;
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

}  // namespace

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

}  // namespace pendular
