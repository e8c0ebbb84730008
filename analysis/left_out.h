#pragma once

#include <array>
#include <cstddef>
#include <memory>
#include <optional>

#include "calib/fit/calibration.h"
#include "calib/model/predictor.h"

namespace pendular {

/// Error of a model at conditions that were left out of its fit.
struct LeftOut {
    /// RMS errors of shear stress and solid fraction [%]: 100 sqrt(mean((predicted/measured -
    /// 1)^2)).
    std::array<double, 2> rms_percent{};
    std::size_t conditions = 0;  ///< number of conditions left out, one after the other
    /// Number of conditions without which a parameter is not determined; it then keeps its starting
    /// value.
    std::size_t undetermined = 0;
};

/// Leave-one-condition-out error: each condition of the fitted readings, replicates together, is
/// predicted by the finished model fitted to the others, from the optimum and without new runs.
/// Readings that the calibration only predicts count as they are predicted, so that the error of
/// every fit of a study is over the same readings. Empty where less than two conditions are fitted.
std::optional<LeftOut> left_out_errors(const std::shared_ptr<const Predictor>& model,
                                       const Calibration& calibration);

}  // namespace pendular
