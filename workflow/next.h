#pragma once

#include <cstddef>
#include <vector>

#include "analysis/design/next_measurement.h"
#include "workflow/study_diagnosis.h"

namespace pendular {

/// Next measurement of one study, with its reasons.
struct NextMeasurement {
    const Study& study;
    std::vector<Rival> rivals;  ///< models that fit; one: nothing to separate
    std::vector<Point> points;
    std::vector<Plan> plans;  ///< plans that separate rivals, the largest separation first
    std::vector<Sharpening>
        sharpenings;     ///< plans that sharpen the parameters, where one model fits
    Series series = {};  ///< readings to make; empty: none separates the rivals
    int most_repeats = 1,
        most_readings = 1;        ///< largest number of readings at one point, and in all
    std::size_t unsupported = 0;  ///< conditions of the rig that the known runs do not support
};

/// Plan to show: the first, or the one of largest separation where none separates the rivals.
const Plan& shown_plan(const NextMeasurement& next);

/// Plan of a point.
const Plan& plan_at(const NextMeasurement& next, std::size_t point);

/// Mass of the beads at a condition [kg].
double mass_of(const Condition& c, const Study& study);

/// Standard errors of a rival's forecast.
Eigen::VectorXd error_of(const Forecast& forecast);

/// Looks for the measurement on the study's rig, or within what its readings span, that tells the
/// models apart that a diagnosis leaves, or sharpens the parameters of the only one. The diagnosis
/// and the study must live as long as the result.
/// @throws InputError where the known runs support none of the rig's conditions
NextMeasurement next_measurement(const ResolvedStudy& study, const StudyDiagnosis& diagnosis);

}  // namespace pendular
