#include "workflow/next.h"

#include <algorithm>

#include "workflow/rivals.h"

namespace pendular {
namespace {

double last_time(const std::vector<Reading>& readings) {
    double last = 0;
    for (const Reading& reading : readings)
        last = std::max(last, reading.condition.time);
    return last;
}

}  // namespace

NextMeasurement next_measurement(const ResolvedStudy& resolved, const StudyDiagnosis& d) {
    const Study& study = resolved;
    const Rig rig = study.rig.value_or(rig_of(d.readings));
    const std::vector<Point> points = points_of(rig, resolved, last_time(d.readings));
    NextMeasurement next{.study = study,
                         .rivals = rivals_of(d),
                         .points = points,
                         .plans = {},
                         .sharpenings = {},
                         .most_repeats = rig.repeats,
                         .most_readings = rig.readings};
    const double friction = next.rivals.front().fit.parameters(0);
    next.unsupported = std::erase_if(next.points, [&](const Point& point) {
        return !point.direct && !d.models->why_unsupported(friction, point.condition).empty();
    });
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
