#pragma once

#include <string>
#include <vector>

#include "calib/fit/fit.h"

namespace pendular {

/// Largest relative increase [1] of a standard error by the noise of the simulation runs that is
/// accepted without more runs. A standard error is then at most 1.2 times that with an unlimited
/// number of runs.
constexpr double largest_enlargement = 0.2;

/// The standard error of a fit that the noise of the simulation runs increases most, among those of
/// all fitted parameters and all predicted readings, and its relative increase (enlargement).
struct Enlargement {
    /// Enlargement [1]: ratio of the standard error with the noise of the simulation runs to the
    /// standard error without this noise, minus 1.
    double size = 0;
    /// Name of the parameter whose standard error is enlarged most; empty: it is the standard error
    /// of a predicted reading.
    std::string parameter = {};

    /// Factor by which the variance from the noise of the simulation runs exceeds the variance that
    /// would enlarge a standard error by the relative amount `largest` [1]:
    ///     excess = ((1 + size)^2 - 1)/((1 + largest)^2 - 1),
    /// at most 1 if `size` is at most `largest`.
    double excess(double largest = largest_enlargement) const;
};

/// Text for messages that names the most enlarged standard error and its enlargement, as in "the
/// error of friction by 35 %".
std::string text_of(const Enlargement& enlargement);

/// Relative increase (enlargement) of a standard error by the noise of the simulation runs [1]:
/// sqrt(1 + noise/rest) - 1, at most 100.
/// @param noise variance that the noise of the runs causes
/// @param rest variance of all other errors, in the unit of `noise`
double enlargement(double noise, double rest);

/// Finds which standard error of a fit the noise of the simulation runs increases most, and by how
/// much. The standard error of a predicted reading includes the error of the measurement, since
/// noise far below the errors of the readings changes no conclusion.
/// @param parameters parameters of the fitted model, in the order of Fit::parameters
Enlargement enlargement_by_runs(const Fit& fit, const Measured& measured,
                                const std::vector<Parameter>& parameters);

}  // namespace pendular
