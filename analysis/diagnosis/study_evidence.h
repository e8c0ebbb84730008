#pragma once

#include <vector>

#include "analysis/diagnosis/diagnosis.h"
#include "analysis/misfit/checks.h"
#include "data/reading.h"

namespace pendular {

/// Returns the input of a diagnosis: the readings, with errors estimated from replicates, then the
/// direct measurements, with errors stated in study.toml.
///
/// Suspect measurements are the readings of each condition, those of each file, and the direct
/// measurements of each parameter. If the files follow one another in time, the readings of each
/// file but the first together with all later ones are also suspect, since an instrument may change
/// between two recordings. An error of readings multiplies all their shear stresses by one factor
/// and all their solid fractions by another.
Evidence evidence_of(const std::vector<Reading>& readings, const ReplicateScatter& scatter,
                     const std::vector<DirectMeasurement>& direct = {});

/// Returns the covariates along which residuals are tested for trends: normal stress, inertial
/// number, liquid content, height, and time or run order, if the readings differ in it by more than
/// 10 %. Values are in the order of the measured values.
///
/// No covariate has the errors of the reading itself: the residual of the solid fraction V/(A H)
/// would depend on the measured height H, and on the inertial number at H, in a right model too.
/// The height and the shear rate are therefore those at the predicted solid fraction, and readings
/// at one condition have one normal stress, inertial number and height, their mean.
/// @param predicted shear stress [Pa] and solid fraction [1] of each reading in turn; further
///        entries are ignored
/// @param direct number of direct measurements, which have the value NaN
std::vector<Covariate> covariates_of(const std::vector<Reading>& readings,
                                     const Eigen::VectorXd& predicted, std::size_t direct = 0);

/// Returns the observable and the condition of each measured value: shear stress and solid fraction
/// of each reading in turn, then the direct measurements.
EntryKinds entries_of(const std::vector<Reading>& readings,
                      const std::vector<Parameter>& parameters, std::size_t direct = 0);

/// Returns a text such as "300 Pa, I = 0.003, liquid content 0.03".
std::string condition_text(const Condition& condition);

}  // namespace pendular
