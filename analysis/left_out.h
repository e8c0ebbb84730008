#pragma once

#include <array>
#include <cstddef>
#include <memory>
#include <optional>

#include "calib/fit/calibration.h"
#include "calib/model/predictor.h"

namespace pendular {

/// Cross-validation errors of a study's model. In cross-validation, the model is fitted without the
/// readings at one condition (normal stress, inertial number and liquid content) and predicts these
/// readings. Each fitted condition is left out in turn.
struct LeftOut {
    /// Relative RMS errors [%] of the predicted shear stress (first) and solid fraction (second),
    /// averaged over all readings:
    ///     100 sqrt(mean((predicted/measured - 1)^2)).
    std::array<double, 2> rms_percent{};
    /// Number of conditions whose readings the calibration fitted. Each of these conditions was
    /// left out of one refit.
    std::size_t conditions = 0;
    /// Number of refits without one condition that did not determine all parameters or did not
    /// converge. Each such refit was repeated from the starting values of the model's parameters,
    /// which undetermined parameters then keep.
    std::size_t undetermined = 0;
};

/// Returns the cross-validation errors of a finished calibration. For each fitted condition, the
/// model is refitted without all readings at the condition and predicts these readings. Refits need
/// no new simulation runs. Readings that the calibration did not fit are predicted at the
/// parameters of the calibration. The result is empty if the calibration fitted fewer than two
/// conditions, or if constant cohesions were fitted to the wet readings beforehand (base =
/// "mohr-coulomb" in study.toml).
/// @param model predictor with the parameters of the calibration's model
std::optional<LeftOut> left_out_errors(const std::shared_ptr<const Predictor>& model,
                                       const Calibration& calibration);

}  // namespace pendular
