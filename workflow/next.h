#pragma once

#include <cstddef>
#include <vector>

#include "analysis/design/next_measurement.h"
#include "workflow/study_diagnosis.h"

namespace pendular {

/// Next measurement to make for a study, with the plans that were considered.
struct NextMeasurement {
    const Study& study;
    std::vector<Rival> rivals;  ///< models that fit the readings; one: nothing to separate
    std::vector<Point> points;  ///< points at which the rig can measure and predictions exist
    /// Plan for each point to separate the rivals, in the order of `separating_plans`; empty where
    /// only one model fits.
    std::vector<Plan> plans;
    /// Expected precision of the parameters after readings at each point, the largest gain first;
    /// empty where several models fit.
    std::vector<Sharpening> sharpenings;
    /// Readings to make; without steps where no readings separate the rivals or only one model
    /// fits.
    Series series = {};
    /// Largest number of readings at one point, and in total.
    int most_repeats = 1, most_readings = 1;
    /// Number of the rig's points at which the known runs support no prediction.
    std::size_t unsupported = 0;
};

/// Plan to show to the user: the first plan or, where no readings separate the rivals, the plan
/// with the largest noncentrality. There must be a plan.
const Plan& shown_plan(const NextMeasurement& next);

/// Plan for the point with this index.
const Plan& plan_at(const NextMeasurement& next, std::size_t point);

/// Mass of the beads in the cell at a condition [kg]; `c.bead_volume` must be known.
double mass_of(const Condition& c, const Study& study);

/// Standard errors of the values of a forecast [their units], from parameters and simulation.
Eigen::VectorXd error_of(const Forecast& forecast);

/// Finds the measurement, among those that the study's rig can make, that best discriminates
/// between the models which the diagnosis found to fit; where only one model fits, the measurement
/// that determines its parameters most precisely. Without [rig] in the study, the range of its
/// readings is used. The diagnosis and the study must outlive the result.
/// @throws InputError where the known runs support a prediction at none of the rig's conditions, or
///         where [rig] lists a direct measurement of an effect that does not apply to the study
NextMeasurement next_measurement(const ResolvedStudy& study, const StudyDiagnosis& diagnosis);

}  // namespace pendular
