#pragma once

#include <cstddef>
#include <vector>

#include "analysis/design/next_measurement.h"
#include "workflow/study_diagnosis.h"

namespace pendular {

/// Next measurement of one study, with its reasons.
struct NextMeasurement {
    const Study& study;
    std::vector<Rival> rivals;  ///< models that stand; one: nothing to tell apart
    std::vector<Point> points;
    std::vector<Plan> plans;                  ///< of rivals, the most telling first
    std::vector<Sharpening> sharpenings;      ///< where there is one model
    Series series = {};                       ///< to measure; empty: nothing tells them apart
    int most_repeats = 1, most_readings = 1;  ///< at one point, in all
    std::size_t unsupported = 0;  ///< conditions of the rig that the known runs do not support
};

/// The plan to show: the first, or, where nothing tells the rivals apart, the most telling one.
const Plan& shown_plan(const NextMeasurement& next);

/// The plan of a point.
const Plan& plan_at(const NextMeasurement& next, std::size_t point);

/// Mass of the beads at a condition [kg].
double mass_of(const Condition& c, const Study& study);

/// Standard errors of what a rival says.
Eigen::VectorXd error_of(const Forecast& forecast);

/// Looks for the measurement on the study's rig, or within what its readings span, that tells the
/// models apart that a diagnosis leaves, or sharpens the parameters of the only one. The diagnosis
/// and the study must live as long as the result.
/// @throws InputError where the known runs support none of the rig's conditions
NextMeasurement next_measurement(const ResolvedStudy& study, const StudyDiagnosis& diagnosis);

}  // namespace pendular
