#pragma once

#include <string>
#include <vector>

#include "calib/fit/fit.h"

namespace pendular {

/// Largest part by which the noise of the simulation runs may enlarge a standard error before more
/// runs are worth their time [1]: a fifth, so that an error is at most 1.2 times the error that an
/// unlimited number of runs would leave.
constexpr double largest_enlargement = 0.2;

/// Largest enlargement of a standard error by the noise of the simulation runs, over all fitted
/// parameters and all predicted readings of a fit.
struct Enlargement {
    /// Standard error with the noise of the runs over the error without it, minus 1 [1].
    double size = 0;
    /// Name of the parameter whose standard error is enlarged; empty where the standard error of a
    /// predicted reading is enlarged.
    std::string parameter = {};

    /// Factor by which the variance from the noise of the runs is too large for an enlargement of
    /// at most `largest` [1]; at most 1 where `size` is no larger.
    ///     excess = ((1 + size)^2 - 1)/((1 + largest)^2 - 1)
    double excess(double largest = largest_enlargement) const;
};

/// Text on an enlargement for messages: "the error of friction by 35 %".
std::string text_of(const Enlargement& enlargement);

/// Enlargement of a standard error from the variance `noise` that the runs cause and the variance
/// `rest` of all other errors [1]: sqrt(1 + noise/rest) - 1, at most 100.
double enlargement(double noise, double rest);

/// Largest enlargement of the standard errors of a fit by the noise of the runs. For a predicted
/// reading, the error of the measurement is included (error of the residual), since noise far below
/// the errors of the readings changes no conclusion from them.
/// @param parameters parameters of the fitted model, in the order of Fit::parameters
Enlargement enlargement_by_runs(const Fit& fit, const Measured& measured,
                                const std::vector<Parameter>& parameters);

}  // namespace pendular
