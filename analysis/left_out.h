#pragma once

#include <array>
#include <cstddef>
#include <memory>
#include <optional>

#include "calib/fit/calibration.h"
#include "calib/model/predictor.h"

namespace pendular {

/// Cross-validation errors of a study's model: each fitted condition in turn is left out of the
/// fit, and its readings are predicted.
struct LeftOut {
    /// Relative RMS errors [%] of shear stress and solid fraction over all readings:
    /// 100 sqrt(mean((predicted/measured - 1)^2)).
    std::array<double, 2> rms_percent{};
    std::size_t conditions = 0;  ///< number of refits
    /// Number of refits that did not determine all parameters or did not converge. Each was
    /// repeated from the starting values, which undetermined parameters then keep.
    std::size_t undetermined = 0;
};

/// Returns the cross-validation errors of a finished calibration. Refits need no new simulation
/// runs. Readings that the calibration did not fit are predicted at its parameters. Empty if fewer
/// than two conditions were fitted, or if constant cohesions were fitted to the wet readings
/// beforehand (base = "mohr-coulomb" in study.toml): no wet reading would then truly be left out.
std::optional<LeftOut> left_out_errors(const std::shared_ptr<const Predictor>& model,
                                       const Calibration& calibration);

}  // namespace pendular
