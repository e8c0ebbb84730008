#pragma once

#include <array>
#include <cstddef>
#include <memory>
#include <optional>

#include "calib/fit/calibration.h"
#include "calib/model/predictor.h"

namespace pendular {

/// Cross-validation errors of a study's model. Cross-validation predicts the readings of each
/// fitted condition by the model fitted to the other conditions.
struct LeftOut {
    /// Relative RMS errors [%] of the predicted shear stress (first) and solid fraction (second)
    /// for all readings:
    ///     100 sqrt(mean((predicted/measured - 1)^2)).
    std::array<double, 2> rms_percent{};
    /// Number of fitted conditions, each of which was left out of one refit.
    std::size_t conditions = 0;
    /// Number of fitted conditions for which the refit to the other conditions does not determine
    /// all parameters or does not converge. Such a refit is repeated from the model's starting
    /// values, so that undetermined parameters keep these values.
    std::size_t undetermined = 0;
};

/// Returns the cross-validation errors of a finished calibration. The model refitted to the other
/// conditions predicts the readings of each fitted condition, with all replicates (readings at the
/// same condition). Refits need no new simulation runs. Readings that the calibration did not fit
/// are predicted at the fitted parameters. The result is empty if fewer than two conditions are
/// fitted, or if constant cohesions were fitted to the wet readings beforehand (base =
/// "mohr-coulomb" in study.toml).
std::optional<LeftOut> left_out_errors(const std::shared_ptr<const Predictor>& model,
                                       const Calibration& calibration);

}  // namespace pendular
