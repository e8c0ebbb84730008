#include "sim/lab/lab_plan.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <random>
#include <stdexcept>
#include <string>

#include "data/input_error.h"
#include "sim/catalogue/instrument.h"
#include "sim/dem/bridge_law.h"
#include "sim/runs/run_request.h"
#include "sim/runs/run_settings.h"

namespace pendular {
namespace {

/// Number of grains of a run over that of the fidelity, so that the samples of the laboratory
/// differ in size from the samples of a calibration.
constexpr double size_ratio = 1.5;
/// Size of pilot runs over that of the fidelity, and their strain. Pilots may be small and short,
/// since bridge volumes are needed only to 3 %.
constexpr double pilot_share_of_beads = 0.5, pilot_strain = 1;
/// Largest simulated stiffness number. Stiffer grains differ by 4/kappa = 0.013 % in solid
/// fraction, less than a tenth of the instrument's 0.2 %; a run costs sqrt(kappa).
constexpr double stiffest = 3e4;

std::vector<LabSetPoint> set_points_of(const LabPlan& plan, bool wet) {
    std::vector<LabSetPoint> steps;
    for (const double stress : wet ? plan.wet_normal_stresses : plan.dry_normal_stresses) {
        for (const double speed : plan.angular_velocities) {
            steps.push_back({.normal_stress = stress, .angular_velocity = speed});
        }
        if (!plan.angular_velocities.empty()) continue;
        for (const double number : plan.inertial_numbers) {
            steps.push_back({.normal_stress = stress, .inertial_number = number});
        }
    }
    return steps;
}

/// Shuffles by Fisher and Yates, which std::shuffle leaves to the library.
void shuffle(std::vector<LabSetPoint>& steps, std::uint64_t seed) {
    std::mt19937_64 random(seed);
    for (std::size_t left = steps.size(); left > 1; --left) {
        std::swap(steps[left - 1], steps[random() % left]);
    }
}

/// Returns the steps from the lowest normal stress to the highest and back; the highest is measured
/// once.
std::vector<LabSetPoint> up_and_down(std::vector<LabSetPoint> steps) {
    const double highest =
        std::ranges::max_element(steps, {}, &LabSetPoint::normal_stress)->normal_stress;
    std::vector<LabSetPoint> back;
    std::ranges::copy_if(steps, std::back_inserter(back),
                         [&](const LabSetPoint& step) { return step.normal_stress < highest; });
    std::ranges::stable_sort(back, std::greater{}, &LabSetPoint::normal_stress);
    steps.insert(steps.end(), back.begin(), back.end());
    return steps;
}

std::vector<LabSetPoint> in_order(std::vector<LabSetPoint> steps, StepOrder order,
                                  std::uint64_t seed) {
    if (steps.empty() || order == StepOrder::as_listed) return steps;
    if (order == StepOrder::random) {
        shuffle(steps, seed);
    } else if (order == StepOrder::decreasing) {
        std::ranges::stable_sort(steps, std::greater{}, &LabSetPoint::normal_stress);
    } else {
        std::ranges::stable_sort(steps, {}, &LabSetPoint::normal_stress);
    }
    return order == StepOrder::up_and_down ? up_and_down(std::move(steps)) : steps;
}

void add_steps(const LabPlan& plan, const std::vector<LabSetPoint>& steps,
               PlannedRecording& recording) {
    constexpr FlowPoint typical{.stress_ratio = 0.3, .solid_fraction = 0.6};
    for (const LabSetPoint& step : steps) {
        Condition condition{.normal_stress = step.normal_stress,
                            .inertial_number = step.inertial_number,
                            .liquid_content = recording.liquid_content,
                            .height = {}};
        if (step.angular_velocity > 0) {
            condition.inertial_number =
                inertial_number_at_speed(plan, condition, step.angular_velocity, typical);
        }
        recording.conditions.push_back(condition);
        recording.angular_velocities.push_back(step.angular_velocity);
    }
}

}  // namespace

std::string why_not_in_lab(const Effect& effect) {
    if (effect.of_table())
        return "acts on tables of readings, but a virtual laboratory writes recordings: hide an "
               "effect of its instrument";
    if (effect.of_instrument() || effect.of_grains() || effect.of_condition()) return "";
    return "cannot be hidden in a virtual laboratory: it changes how readings are predicted, not "
           "how "
           "the grains flow";
}

std::vector<double> contents_of(const LabPlan& plan) {
    std::vector<double> contents;
    for (const LabSeries& series : series_of(plan)) {
        if (std::ranges::find(contents, series.liquid_content) == contents.end())
            contents.push_back(series.liquid_content);
    }
    return contents;
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

EffectiveCondition imposed_condition(const LabPlan& plan, const Condition& asked,
                                     const FlowPoint& flow) {
    Condition condition = asked;
    if (const InstrumentMap map = map_of(plan, asked); !map.empty()) {
        condition = true_condition(asked, truth_of(plan, asked, flow, map), map);
    }
    return changed_condition(std::move(condition), plan.effects, plan.liquid);
}

double inertial_number_at_speed(const LabPlan& plan, Condition asked, double angular_velocity,
                                const FlowPoint& flow) {
    // The shown height depends on the inertial number only where an effect makes it depend on the
    // speed, and hardly even then.
    constexpr int most_rounds = 20;
    const InstrumentMap map = map_of(plan, asked);
    double shown_height = height(flow.solid_fraction, plan.cell), before = 0;
    for (int round = 0; round < most_rounds && shown_height != before; ++round) {
        before = shown_height;
        asked.inertial_number =
            inertial_number(shear_rate(angular_velocity, shown_height, plan.cell),
                            asked.normal_stress, plan.grains);
        if (map.empty()) break;
        shown_height = map.show(truth_of(plan, asked, flow, map)).height;
    }
    return asked.inertial_number;
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
        .stiffness_number =
            std::min(stiffest, stiffness_number(condition.normal_stress, plan.grains)
                                   .value_or(plan.fidelity.stiffness_number)),
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

std::vector<LabSeries> series_of(const LabPlan& plan) {
    if (!plan.series.empty()) return plan.series;
    std::vector<LabSeries> series = {{0, set_points_of(plan, false), plan.replicates}};
    for (const double content : plan.liquid_contents) {
        series.push_back({content, set_points_of(plan, true), plan.replicates});
    }
    return series;
}

std::vector<PlannedRecording> recordings_of(const LabPlan& plan) {
    std::vector<PlannedRecording> recordings;
    const std::vector<LabSeries> all = series_of(plan);
    std::map<double, int> total, made;
    for (const LabSeries& series : all)
        total[series.liquid_content] += series.replicates;
    for (const LabSeries& series : all) {
        const double content = series.liquid_content;
        const auto width = std::to_string(total[content]).size();
        for (int k = 1; k <= series.replicates; ++k) {
            const int replicate = ++made[content];
            const std::string kind = content > 0 ? fmt::format("wet_{:g}", content) : "dry";
            PlannedRecording recording{
                .file = fmt::format("{}_{:0{}}.csv", kind, replicate, width),
                .liquid_content = content,
                .replicate = replicate,
                .seed = seed_of_run(plan.noise_seed.value_or(plan.seed), recordings.size(),
                                    SeedDomain::instrument)};
            // The order has random numbers of its own, so that it changes none of the noise.
            add_steps(plan, in_order(series.steps, plan.order, recording.seed + 2), recording);
            recordings.push_back(std::move(recording));
        }
    }
    set_times(plan, recordings);
    return recordings;
}

void set_times(const LabPlan& plan, std::vector<PlannedRecording>& recordings) {
    double now = 0;
    for (PlannedRecording& recording : recordings) {
        now += time_steps(recording.conditions, plan.grains, plan.instrument, now);
    }
}

namespace {

/// Relative error of a liquid content that needs no further simulation [1]. Chosen: the pilot runs
/// are short and small, and their coordination numbers are noisy.
constexpr double tolerance = 0.03;

bool off(double found, double wanted) {
    return std::abs(found / wanted - 1) > tolerance;
}

/// Trial: a bridge volume over a^3 with the liquid content [1] that its simulation gave.
struct Trial {
    double volume = 0;
    double content = 0;
};

/// Returns the bridge volume that gives the wanted liquid content at the coordination number of the
/// trial.
double at_same_coordination(const Trial& trial, double wanted) {
    return trial.volume * wanted / trial.content;
}

/// Returns the bridge volume where the secant through two trials, in logarithms, has the wanted
/// liquid content. The slope is limited to 0.8 to 1.25, since noise dominates it where the trials
/// are close.
double secant(const Trial& first, const Trial& second, double wanted) {
    const double slope =
        std::log(second.content / first.content) / std::log(second.volume / first.volume);
    return second.volume * std::pow(wanted / second.content, 1 / std::clamp(slope, 0.8, 1.25));
}

}  // namespace

double first_bridge_volume(double liquid_content) {
    return dem::bridge_volume(liquid_content, dem::typical_coordination);
}

std::vector<double> bridge_volumes(std::span<const double> liquid_contents,
                                   const MeasureLiquidContents& measure) {
    std::vector<std::size_t> which;
    std::vector<double> volumes;
    for (const double content : liquid_contents) {
        which.push_back(which.size());
        volumes.push_back(first_bridge_volume(content));
    }
    const std::vector<double> first_contents = measure(which, volumes);
    std::vector<Trial> first;
    for (const std::size_t k : which) {
        first.push_back({volumes[k], first_contents[k]});
        volumes[k] = at_same_coordination(first[k], liquid_contents[k]);
    }
    std::erase_if(which, [&](std::size_t k) { return !off(first[k].content, liquid_contents[k]); });
    if (which.empty()) {
        return volumes;
    }
    std::vector<double> corrected;
    for (const std::size_t k : which) {
        corrected.push_back(volumes[k]);
    }
    const std::vector<double> second_contents = measure(which, corrected);
    for (std::size_t i = 0; i < which.size(); ++i) {
        const std::size_t k = which[i];
        if (off(second_contents[i], liquid_contents[k])) {
            volumes[k] = secant(first[k], {corrected[i], second_contents[i]}, liquid_contents[k]);
        }
    }
    return volumes;
}

}  // namespace pendular
