#pragma once

#include <cstddef>
#include <vector>

#include "analysis/design/next_measurement.h"
#include "workflow/study_diagnosis.h"

namespace pendular {

/// Next measurement to make for a study, with the possible measurements that were compared.
struct NextMeasurement {
    const Study& study;
    /// Rival models of the study, which the next measurement should tell apart. If there is only
    /// one model, the next measurement should make its parameters more precise.
    std::vector<Rival> rivals;
    /// Possible measurements that the instrument (table [rig] of study.toml) can make and whose
    /// results can be predicted. Without such a measurement, `plans` and `sharpenings` are empty.
    std::vector<Point> points;
    /// Plans of readings, one for each of `points`, sorted by how well the readings would tell the
    /// rival models apart, the best first (`separating_plans`). Empty if there is only one model.
    std::vector<Plan> plans;
    /// Standard errors that the parameters of the only model would have after `most_repeats`
    /// measurements, for each of `points`. Sorted by the gain in precision for the cost of the
    /// measurements, the largest first. Empty if there are several rival models.
    std::vector<Sharpening> sharpenings;
    /// Series of readings to make in order to tell the rival models apart. The series is empty if
    /// no readings can tell the models apart, or if there is only one model.
    Series series = {};
    /// Largest number of readings that the instrument allows at one point (`most_repeats`), and in
    /// total (`most_readings`).
    int most_repeats = 1, most_readings = 1;
    /// Number of possible measurements that the instrument can make but that are not in `points`:
    /// no earlier simulation run is near their conditions, so that their results cannot be
    /// predicted.
    std::size_t unsupported = 0;
};

/// Returns the plan of readings to show to the user: the best plan or, if no readings tell the
/// rival models apart, the plan with the largest expected chi2 between the predictions of the rival
/// models (`Plan::noncentrality`). `next.plans` must not be empty.
const Plan& shown_plan(const NextMeasurement& next);

/// Returns the plan of readings at `next.points[point]`. `next.plans` must contain a plan for that
/// point.
const Plan& plan_at(const NextMeasurement& next, std::size_t point);

/// Returns the mass of the beads in the cell at a condition [kg]: volume of the beads times density
/// of the study's grains. The volume `c.bead_volume` must be known.
double mass_of(const Condition& c, const Study& study);

/// Returns the standard errors of the values that a model predicts at a point (possible
/// measurement). A reading has two values, first the shear stress [Pa] and second the solid
/// fraction [1]. A direct measurement of an effect's parameter has one value [its unit]. The
/// standard errors include the errors of the fitted parameters and of the simulation.
Eigen::VectorXd error_of(const Forecast& forecast);

/// Chooses the next measurement of a study. If the diagnosis leaves several rival models
/// (`rivals_of`), chooses the measurement that best tells the models apart. If only one model is
/// left, chooses the measurement that determines its parameters most precisely. The table [rig] of
/// study.toml states which measurements the instrument can make. Without this table, the
/// measurements lie in the range of the readings. The diagnosis and the study must outlive the
/// result.
/// @throws InputError if [rig] lists a direct measurement of an effect that does not apply to the
///         study
NextMeasurement next_measurement(const ResolvedStudy& study, const StudyDiagnosis& diagnosis);

}  // namespace pendular
