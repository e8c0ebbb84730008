#pragma once

#include <cstddef>
#include <vector>

#include "analysis/design/next_measurement.h"
#include "workflow/study_diagnosis.h"

namespace pendular {

/// Next measurement to make for a study, with the possible measurements that were compared.
struct NextMeasurement {
    const Study& study;
    /// Models between which the next measurement should decide. If there is only one, the
    /// measurement should make its parameters more precise.
    std::vector<Rival> rivals;
    /// Measurements that the instrument can make (section [rig] of study.toml) and whose results
    /// can be predicted.
    std::vector<Point> points;
    /// For each point, how well readings at this point would tell the rival models apart; the best
    /// point is first (`separating_plans`). Empty where there is only one model.
    std::vector<Plan> plans;
    /// For each point, the standard errors that the parameters of the only model would have after
    /// readings at this point; the largest gain in precision is first. Empty where there are
    /// several rival models.
    std::vector<Sharpening> sharpenings;
    /// Readings to make in order to tell the rival models apart. Has no steps if no readings can
    /// tell them apart, or if there is only one model.
    Series series = {};
    /// Largest numbers of readings that the instrument allows: at one point (`most_repeats`), and
    /// in total (`most_readings`).
    int most_repeats = 1, most_readings = 1;
    /// Number of measurements that the instrument can make but whose results cannot be predicted,
    /// since no earlier simulation run is near their conditions. `points` does not contain them.
    std::size_t unsupported = 0;
};

/// Plan to show to the user: the best plan or, if no readings tell the rival models apart, the plan
/// with the largest expected chi2 between the predictions of the rival models
/// (`Plan::noncentrality`). `next.plans` must not be empty.
const Plan& shown_plan(const NextMeasurement& next);

/// Plan for measuring at `next.points[point]`. `next.plans` must contain a plan for this point.
const Plan& plan_at(const NextMeasurement& next, std::size_t point);

/// Mass of the beads in the cell at a condition [kg]: their volume times the density of the study's
/// grains. The volume `c.bead_volume` must be known.
double mass_of(const Condition& c, const Study& study);

/// Standard errors of the values that a model predicts at a point: shear stress [Pa] and solid
/// fraction [1] or, for a direct measurement, one value [its unit]. They include the errors of the
/// fitted parameters and of the simulation.
Eigen::VectorXd error_of(const Forecast& forecast);

/// Chooses the next measurement of a study among those that the instrument can make: the one that
/// best tells apart the models that fit according to the diagnosis or, if only one fits, the one
/// that determines its parameters most precisely. The instrument is described in section [rig] of
/// study.toml; without this section, the range of the readings is used. The diagnosis and the study
/// must outlive the result.
/// @throws InputError where none of the instrument's conditions is near an earlier simulation run,
///         and where [rig] lists a direct measurement of an effect that does not apply to the study
NextMeasurement next_measurement(const ResolvedStudy& study, const StudyDiagnosis& diagnosis);

}  // namespace pendular
