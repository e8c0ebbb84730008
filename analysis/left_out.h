#pragma once

#include <array>
#include <cstddef>
#include <memory>
#include <optional>

#include "calib/fit/calibration.h"
#include "calib/model/predictor.h"

namespace pendular {

/// Prediction error of a study's model at conditions that were left out of its fit.
struct LeftOut {
    /// RMS errors of (shear stress, solid fraction) [%]:
    /// 100 sqrt(mean((predicted/measured - 1)^2)).
    std::array<double, 2> rms_percent{};
    std::size_t conditions = 0;  ///< number of conditions, each left out once
    /// Number of conditions without which the other readings do not determine every parameter. An
    /// undetermined parameter keeps its starting value.
    std::size_t undetermined = 0;
};

/// Leave-one-condition-out error of a finished calibration. Each fitted condition, with all its
/// replicates, is predicted by the model refitted to the other conditions; refits start from the
/// optimum and need no new runs. Readings that the calibration only predicts count with that
/// prediction, so that every fit of a study is judged on the same readings. Empty where fewer than
/// two conditions are fitted.
std::optional<LeftOut> left_out_errors(const std::shared_ptr<const Predictor>& model,
                                       const Calibration& calibration);

}  // namespace pendular
