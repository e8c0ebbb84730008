#include "workflow/next.h"

#include <algorithm>

#include "data/input_error.h"
#include "workflow/rivals.h"

namespace pendular {
namespace {

double last_time(const std::vector<Reading>& readings) {
    double last = 0;
    for (const Reading& reading : readings)
        last = std::max(last, reading.condition.time);
    return last;
}

/// Points that the instrument can measure, near earlier simulation runs or not.
std::vector<Point> all_points(const ResolvedStudy& study, const Rig& rig, const StudyDiagnosis& d) {
    return points_of(rig, study, last_time(d.readings));
}

bool is_supported(const Point& point, double friction, const StudyDiagnosis& d) {
    return point.direct || d.models->why_unsupported(friction, point.condition).empty();
}

}  // namespace

bool can_plan(const ResolvedStudy& study, const StudyDiagnosis& d) {
    const Rig rig = study.study().rig.value_or(rig_of(d.readings));
    const double friction = rivals_of(d).front().fit.parameters(0);
    try {
        return std::ranges::any_of(all_points(study, rig, d), [&](const Point& point) {
            return is_supported(point, friction, d);
        });
    } catch (const InputError&) {
        return true;  // `next_measurement` says what is wrong with the rig
    }
}

NextMeasurement next_measurement(const ResolvedStudy& resolved, const StudyDiagnosis& d) {
    const Study& study = resolved;
    const Rig rig = study.rig.value_or(rig_of(d.readings));
    NextMeasurement next{.study = study,
                         .rivals = rivals_of(d),
                         .points = all_points(resolved, rig, d),
                         .plans = {},
                         .sharpenings = {},
                         .most_repeats = rig.repeats,
                         .most_readings = rig.readings};
    const double friction = next.rivals.front().fit.parameters(0);
    next.unsupported = std::erase_if(
        next.points, [&](const Point& point) { return !is_supported(point, friction, d); });
    if (next.points.empty()) return next;
    const Eigen::Vector2d errors = relative_errors(d.readings);
    if (next.rivals.size() > 1) {
        next.plans = separating_plans(next.rivals, next.points, errors, rig.repeats);
        next.series = next_series(next.plans, next.rivals, next.points, errors, rig);
    } else {
        next.sharpenings = sharpening_plans(next.rivals.front(), next.points, errors, rig.repeats);
    }
    return next;
}

const Plan& shown_plan(const NextMeasurement& next) {
    return next.series.steps.empty()
               ? *std::ranges::max_element(next.plans, {}, &Plan::noncentrality)
               : next.plans.front();
}

const Plan& plan_at(const NextMeasurement& next, std::size_t point) {
    return *std::ranges::find(next.plans, point, &Plan::point);
}

double mass_of(const Condition& c, const Study& study) {
    return *c.bead_volume * study.grains.density;
}

Eigen::VectorXd error_of(const Forecast& forecast) {
    return (forecast.from_parameters + forecast.from_simulation).diagonal().cwiseSqrt();
}

}  // namespace pendular
