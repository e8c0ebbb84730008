#pragma once

#include <cstddef>
#include <vector>

#include "analysis/design/next_measurement.h"
#include "workflow/study_diagnosis.h"

namespace pendular {

/// Next measurement to make for a study, with the possible measurements that were compared. Several
/// rival models are to be told apart (`plans`, `series`); the parameters of a single model are to
/// become more precise (`sharpenings`).
struct NextMeasurement {
    Study study;
    /// Models between which the next measurement should decide, or the only model.
    std::vector<FittedModel> rivals;
    /// Possible measurements that the instrument (table [rig] of study.toml) can make and whose
    /// results can be predicted. If there are none, `plans` and `sharpenings` are empty.
    std::vector<Point> points;
    /// Plans of readings, one for each of `points`, the one that tells the rivals apart best first
    /// (`separating_plans`). Empty if there is only one model.
    std::vector<Plan> plans;
    /// Standard errors of the only model's parameters after `most_repeats` measurements, for each
    /// of `points`, the largest gain in precision for its cost first. Empty if there are rivals.
    std::vector<Sharpening> sharpenings;
    /// Readings to make in order to tell the rivals apart; empty: none can, or only one model.
    Series series = {};
    int most_repeats = 1, most_readings = 1;  ///< largest number of readings at one point, in total
    /// Number of possible measurements that are not in `points` since no earlier simulation run is
    /// near their conditions.
    std::size_t unsupported = 0;
};

/// Whether `next_measurement` can plan a measurement: some point that the instrument can measure is
/// near earlier simulation runs. True too for a rig that `next_measurement` refuses.
bool can_plan(const ResolvedStudy& study, const StudyDiagnosis& diagnosis);

/// Returns the plan to show to the user: the best plan or, if no readings tell the rivals apart,
/// the plan with the largest `Plan::noncentrality`. `next.plans` must not be empty.
const Plan& shown_plan(const NextMeasurement& next);

/// Returns the plan of readings at `next.points[point]`, which must be in `next.plans`.
const Plan& plan_at(const NextMeasurement& next, std::size_t point);

/// Returns the mass of the beads in the cell [kg]. The volume `c.bead_volume` must be known.
double mass_of(const Condition& c, const Study& study);

/// Returns the standard errors of the values that a model predicts at a point: shear stress [Pa]
/// and solid fraction [1] of a reading, or the parameter of a direct measurement [its unit]. They
/// include the errors of the fitted parameters and of the simulation.
Eigen::VectorXd error_of(const Forecast& forecast);

/// Chooses the next measurement of a study: the one that best tells apart the rival models that the
/// diagnosis leaves (`rivals_of`), or the one that determines the parameters of a single model most
/// precisely. Without the table [rig] of study.toml, the measurements lie in the range of the
/// readings. The diagnosis must outlive the result.
/// @throws InputError if [rig] lists a direct measurement of an effect that does not apply to the
///         study
NextMeasurement next_measurement(const ResolvedStudy& study, const StudyDiagnosis& diagnosis);

}  // namespace pendular
