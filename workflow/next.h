#pragma once

#include <cstddef>
#include <vector>

#include "analysis/design/next_measurement.h"
#include "workflow/study_diagnosis.h"

namespace pendular {

/// Next measurement to make for a study, with the plans that were considered.
struct NextMeasurement {
    const Study& study;
    std::vector<Rival> rivals;  ///< models between which to decide; one: nothing to tell apart
    std::vector<Point> points;  ///< possible measurements of the rig that can be predicted
    /// Plan for each point to tell the rival models apart, best first, as `separating_plans` sorts
    /// them; empty where there is one rival only.
    std::vector<Plan> plans;
    /// Expected standard errors of the only rival's parameters after readings at each point, the
    /// largest gain first; empty where there are several rivals.
    std::vector<Sharpening> sharpenings;
    /// Readings to make to tell the rivals apart; without steps where no readings do so or where
    /// there is one rival only.
    Series series = {};
    /// Largest number of readings that the rig allows at one point, and in total.
    int most_repeats = 1, most_readings = 1;
    /// Number of the rig's possible measurements that are left out of `points`, since no run of
    /// atlas and store is near their conditions.
    std::size_t unsupported = 0;
};

/// Plan to show to the user: the first plan or, where no readings tell the rivals apart, the plan
/// with the largest noncentrality. `next.plans` must not be empty.
const Plan& shown_plan(const NextMeasurement& next);

/// Plan for the point with this index into `next.points`; `next.plans` must contain one.
const Plan& plan_at(const NextMeasurement& next, std::size_t point);

/// Mass of the beads in the cell at a condition [kg], from the density of the study's grains;
/// `c.bead_volume` must be known.
double mass_of(const Condition& c, const Study& study);

/// Standard errors of the values of a forecast [their units], from errors of the fitted parameters
/// and of the simulation.
Eigen::VectorXd error_of(const Forecast& forecast);

/// Finds the measurement, among those that the study's rig can make, that best discriminates
/// between the models which the diagnosis found to fit; where only one model fits, the measurement
/// that determines its parameters most precisely. Without [rig] in the study, the range of its
/// readings is used. The diagnosis and the study must outlive the result.
/// @throws InputError where the runs of atlas and store allow a prediction at none of the rig's
///         conditions, or where [rig] lists a direct measurement of an effect that does not apply
///         to the study
NextMeasurement next_measurement(const ResolvedStudy& study, const StudyDiagnosis& diagnosis);

}  // namespace pendular
