#pragma once

#include <string>
#include <vector>

#include "calib/fit/fit.h"

namespace pendular {

/// Largest `Enlargement` [1] that is accepted without more runs. Chosen: a standard error that is
/// estimated with twelve degrees of freedom is no better known (1/sqrt(24)).
constexpr double largest_enlargement = 0.2;

/// Largest relative increase (enlargement) of a standard error by the noise of the simulation runs,
/// among all fitted parameters and all predicted readings.
struct Enlargement {
    /// Ratio of the standard error with the noise to that without, minus 1 [1].
    double size = 0;
    std::string parameter = {};  ///< empty for a predicted reading

    /// Returns the variance from the noise over that which would enlarge a standard error by
    /// `largest` [1],
    ///     excess = ((1 + size)^2 - 1)/((1 + largest)^2 - 1).
    /// It is at most 1 if `size` is at most `largest`.
    double excess(double largest = largest_enlargement) const;
};

/// Returns an enlargement as text, such as "the error of friction by 35 %".
std::string text_of(const Enlargement& enlargement);

/// Returns the enlargement sqrt(1 + noise/rest) - 1 [1] of a standard error, but at most 100.
/// @param noise variance that the noise of the runs causes
/// @param rest variance of all other errors, in the unit of `noise`
double enlargement(double noise, double rest);

/// Returns the largest enlargement of a fit: of the standard errors of the parameters and, for each
/// measured value, of the difference between measured and predicted value.
/// @param parameters in the order of Fit::parameters
Enlargement enlargement_by_runs(const Fit& fit, const Measured& measured,
                                const std::vector<Parameter>& parameters);

}  // namespace pendular
