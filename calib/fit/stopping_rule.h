#pragma once

#include <string>
#include <vector>

#include "calib/fit/fit.h"

namespace pendular {

/// Largest relative increase [1] of a standard error by the noise of the simulation runs that is
/// accepted without more runs. With the value 0.2, a standard error is at most 1.2 times the
/// standard error with an unlimited number of runs.
constexpr double largest_enlargement = 0.2;

/// Largest relative increase (enlargement) of a standard error in a fit by the noise of the
/// simulation runs, with the name of the parameter. The standard errors of all fitted parameters
/// and of all predicted readings are compared.
struct Enlargement {
    /// Relative increase of the standard error by the noise of the simulation runs [1]: ratio of
    /// the standard error with the noise to the standard error without the noise, minus 1.
    double size = 0;
    /// Name of the parameter whose standard error is enlarged most. The name is empty if the
    /// standard error of a predicted reading is enlarged most.
    std::string parameter = {};

    /// Returns the factor [1] by which the variance from the noise of the simulation runs exceeds
    /// the variance that would enlarge a standard error by the relative amount `largest` [1]:
    ///     excess = ((1 + size)^2 - 1)/((1 + largest)^2 - 1).
    /// The factor is at most 1 if `size` is at most `largest`.
    double excess(double largest = largest_enlargement) const;
};

/// Returns the most enlarged standard error and its enlargement (relative increase by the noise of
/// the simulation runs) as text for messages, such as "the error of friction by 35 %".
std::string text_of(const Enlargement& enlargement);

/// Returns the relative increase (enlargement) of a standard error by the noise of the simulation
/// runs [1]: sqrt(1 + noise/rest) - 1, but at most 100.
/// @param noise variance that the noise of the runs causes
/// @param rest variance of all other errors, in the unit of `noise`
double enlargement(double noise, double rest);

/// Finds the standard error of a fit that the noise of the simulation runs enlarges most. The
/// function compares the standard errors of the parameters and, for each measured value, the
/// standard error of the difference between measured and predicted value.
/// @param parameters parameters of the fitted model, in the order of Fit::parameters
Enlargement enlargement_by_runs(const Fit& fit, const Measured& measured,
                                const std::vector<Parameter>& parameters);

}  // namespace pendular
