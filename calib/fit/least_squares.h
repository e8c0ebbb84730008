#pragma once

#include <Eigen/Cholesky>
#include <Eigen/Core>
#include <optional>
#include <string>

#include "calib/fit/measured.h"
#include "calib/model/model.h"

// Search for the least chi2 with constant weights, on which fits, refits and profiles rest: Ceres
// comes near the minimum, and Gauss-Newton steps locate it where chi2 is too flat for Ceres.

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

/// Whitening of residuals and derivatives: multiplication by the inverse Cholesky factor of a
/// covariance.
class Whitening {
  public:
    /// @throws std::logic_error if `covariance` is not positive definite
    explicit Whitening(const Eigen::MatrixXd& covariance);
    template <typename Matrix>
    Eigen::MatrixXd apply(const Matrix& matrix) const {
        return llt_.matrixL().solve(Eigen::MatrixXd(matrix));
    }
    /// Sigma^-1 times a matrix.
    Eigen::MatrixXd solve(const Eigen::MatrixXd& matrix) const { return llt_.solve(matrix); }

  private:
    Eigen::LLT<Eigen::MatrixXd> llt_;
};

/// Returns the range of the parameters within both their bounds and the model's supported range.
ParameterBounds allowed(const Model& model);

/// Derivatives scaled to columns of length 1, so that they do not depend on the parameters' units.
struct Scaled {
    Eigen::MatrixXd jacobian;
    Eigen::VectorXd length;  ///< length of each column before scaling; 1 for a column of zeros

    explicit Scaled(Eigen::MatrixXd whitened);
};

/// Least chi2 that a search found.
struct Minimum {
    Eigen::VectorXd parameters;
    double chi2 = 0;
    bool usable = false;  ///< whether the model can be evaluated there
    bool converged = false;
    std::string message;
};

/// Settings of a search for a minimum.
struct Search {
    /// Initial trust-region radius of Ceres, in units of the columns' lengths of the derivatives.
    double radius = 1e4;
    bool bounded = false;  ///< whether Ceres receives the bounds from the start
};

/// Minimises chi2 with Ceres within the range, with the parameter `held` constant if given.
Minimum minimise(const Model& model, const Measured& measured, const Whitening& whitening,
                 const ParameterBounds& range, const Eigen::VectorXd& start,
                 const FitEffort& effort, const Search& search = {},
                 std::optional<Eigen::Index> held = {});

/// Refines a minimum that Ceres found, near which chi2 is too flat to locate its minimum: takes
/// Gauss-Newton steps as long as they become shorter.
/// @param settled `FitEffort::settled`
void polish(const Model& model, const Measured& measured, const Whitening& whitening,
            const ParameterBounds& range, double settled, Minimum& minimum);

/// Gauss-Newton step of the scaled parameters from `at` that leaves no range: parameters at an end
/// of their range from which the step would lead outside are held, and the others take the step
/// that is best without them.
Eigen::VectorXd step_within(const Scaled& scaled, const Eigen::VectorXd& residuals,
                            const ParameterBounds& range, const Eigen::VectorXd& at);

}  // namespace pendular
