// Which steps a virtual laboratory measures, in which order and when.
#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <random>
#include <string>

#include "sim/lab/lab_plan.h"
#include "sim/runs/seeds.h"

namespace pendular {
namespace {

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

}  // namespace pendular
