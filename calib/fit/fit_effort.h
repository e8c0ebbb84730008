#pragma once

namespace pendular {

/// Accuracy and limits of the search for the minimum of chi2. With the default values, fits
/// reproduce certified regression results to ten digits, far more than readings need.
struct FitEffort {
    int most_steps = 1000;  ///< of one search
    /// Relative change of chi2 in one step [1] at or below which a search ends.
    double tolerance = 1e-14;
    /// A fit has converged when the length of the last step, in standard errors of the parameters,
    /// is at most this number [1] times sqrt(chi2).
    double settled = 1e-10;
    /// Whether to repeat the search from the start with other settings of the solver if the search
    /// leaves a parameter undetermined. If false, the solver also spends less effort on each step
    /// at the bounds of the parameters.
    bool elsewhere = true;
};

}  // namespace pendular
