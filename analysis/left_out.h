#pragma once

#include <array>
#include <cstddef>
#include <memory>
#include <optional>

#include "calib/fit/calibration.h"
#include "calib/model/predictor.h"

namespace pendular {

/// Cross-validation errors of a study's model: each fitted condition is predicted by the model
/// fitted to the other conditions.
struct LeftOut {
    /// RMS errors of (shear stress, solid fraction) over all readings [%]:
    /// 100 sqrt(mean((predicted/measured - 1)^2)).
    std::array<double, 2> rms_percent{};
    std::size_t conditions = 0;  ///< number of fitted conditions, each left out of one refit
    /// Number of conditions without which the other readings do not determine all fitted
    /// parameters. The refit without such a condition starts from the model's starting values,
    /// which undetermined parameters keep.
    std::size_t undetermined = 0;
};

/// Returns the cross-validation errors of a finished calibration. Each fitted condition, with all
/// its replicates, is predicted by the model refitted to the other conditions; refits start from
/// the optimum and need no new runs. Readings that the calibration did not fit are predicted at its
/// fitted parameters, so that every fit of a study is judged on the same readings. Empty if fewer
/// than two conditions are fitted, or if constant cohesions were fitted to wet readings beforehand
/// (base = "mohr-coulomb").
std::optional<LeftOut> left_out_errors(const std::shared_ptr<const Predictor>& model,
                                       const Calibration& calibration);

}  // namespace pendular
