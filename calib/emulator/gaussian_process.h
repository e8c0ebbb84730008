#pragma once

#include <Eigen/Cholesky>
#include <Eigen/Core>
#include <vector>

#include "calib/emulator/kernel.h"

namespace pendular {

/// Noisy values of m quantities at n places.
struct Observations {
    std::vector<Coordinates> at;         ///< n places
    Eigen::MatrixXd values;              ///< n x m
    std::vector<Eigen::MatrixXd> noise;  ///< m x m covariance of the noise at each place

    /// Observations of one of the quantities alone, by its column in `values`.
    Observations only(Eigen::Index quantity) const;
};

/// Gaussian process of m random functions, each with its own kernel, observed at some places with
/// noise that is correlated between the functions at one place. The joint posterior of values and
/// derivatives is
///     mean = k' (K + N)^-1 y,  covariance = k(*, *) - k' (K + N)^-1 k
/// Source: Rasmussen and Williams, Gaussian Processes for Machine Learning (2006), eq. 2.23, 2.24;
/// derivatives: section 9.4.
class GaussianProcess {
  public:
    /// Conditions the process on the observations `known`. The noise at each place is multiplied by
    /// the noise factors of the kernels' hyperparameters and increased by their between-run
    /// scatter.
    /// @throws std::logic_error where the covariance of the observations is not positive definite
    GaussianProcess(std::vector<Kernel> kernels, const Observations& known);

    /// Value or derivative to predict of one quantity, given by its index.
    struct Requested {
        Eigen::Index quantity = 0;
        Functional functional;
    };
    /// Posterior mean of each requested value or derivative.
    Eigen::VectorXd mean(const std::vector<Requested>& requested) const;
    /// Posterior covariance of the requested values and derivatives, one row and column for each.
    Eigen::MatrixXd covariance(const std::vector<Requested>& requested) const;

  private:
    /// Prior covariance of the observations (rows, quantity by quantity) with the requested values.
    Eigen::MatrixXd with_known(const std::vector<Requested>& requested) const;

    Kernel::Prepared prepared(const Requested& requested) const {
        return kernels_[static_cast<std::size_t>(requested.quantity)].prepare(requested.functional);
    }

    std::vector<Kernel> kernels_;
    std::vector<std::vector<Kernel::Prepared>> known_;  ///< observed places, for each quantity
    Eigen::LLT<Eigen::MatrixXd> factor_;    ///< Cholesky factor of K + N, quantity by quantity
    std::vector<Kernel::Known> sums_over_;  ///< observed places with weights (K + N)^-1 y
    /// Posterior mean coefficients of the polynomial of each quantity.
    std::vector<Eigen::VectorXd> coefficients_;
};

}  // namespace pendular
