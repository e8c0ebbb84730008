#pragma once

#include <vector>

#include "analysis/diagnosis/diagnosis.h"
#include "analysis/misfit/checks.h"
#include "data/reading.h"

namespace pendular {

/// Returns the input of a diagnosis (search for effects that a model lacks): the readings of a
/// study, followed by the study's direct measurements of effects' parameters. Errors of readings
/// are estimated from replicates (readings at the same condition). Errors of direct measurements
/// are stated in study.toml.
///
/// The suspect measurements (parts of the measurement that may be wrong) are the readings of each
/// condition, the readings of each file, and the direct measurements of each parameter. If the
/// files follow one another in time, the readings of each file but the first, taken together with
/// the readings of all later files, are also suspect. An error of suspect readings multiplies all
/// shear stresses of these readings by one factor and all solid fractions by another factor.
/// @param scatter estimates of the scatter between replicates, with the degrees of freedom of the
///        estimates
Evidence evidence_of(const std::vector<Reading>& readings, const ReplicateScatter& scatter,
                     const std::vector<DirectMeasurement>& direct = {});

/// Returns the covariates (quantities) along which the residuals of a fit are tested for trends:
/// normal stress, inertial number, liquid content, height, and time or run order. A covariate is
/// returned only if its values differ by more than 10 % between the readings. The values of a
/// covariate are in the order of the measured values: two for each reading, then one for each
/// direct measurement of an effect's parameter.
///
/// No covariate has the errors of the reading itself: the residual of the solid fraction V/(A H)
/// would depend on the measured height H, and on the inertial number at H, in a right model too.
/// The height and the shear rate are therefore those at the predicted solid fraction, and readings
/// at one condition have one normal stress, inertial number and height, their mean.
/// @param predicted predicted shear stress [Pa] and solid fraction [1] of each reading in turn;
///        entries beyond these are ignored
/// @param direct number of direct measurements, for which the values of all covariates are NaN
std::vector<Covariate> covariates_of(const std::vector<Reading>& readings,
                                     const Eigen::VectorXd& predicted, std::size_t direct = 0);

/// Returns the observable and the condition of each measured value. The measured values are the
/// shear stress and solid fraction of each reading in turn, then the direct measurements of
/// effects' parameters.
/// @param parameters calibrated parameters of the model; the result contains their names
/// @param direct number of direct measurements
EntryKinds entries_of(const std::vector<Reading>& readings,
                      const std::vector<Parameter>& parameters, std::size_t direct = 0);

/// Returns a text for the user that describes a condition, such as "300 Pa, I = 0.003, liquid
/// content 0.03" (normal stress, inertial number I).
std::string condition_text(const Condition& condition);

}  // namespace pendular
