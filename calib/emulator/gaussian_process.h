#pragma once

#include <Eigen/Cholesky>
#include <Eigen/Core>
#include <vector>

#include "calib/emulator/kernel.h"

namespace pendular {

/// Noisy values of m quantities at n places.
struct Observations {
    std::vector<Coordinates> at;
    Eigen::MatrixXd values;              ///< n x m
    std::vector<Eigen::MatrixXd> noise;  ///< their m x m covariance at each place

    /// Observations of one quantity alone.
    Observations only(Eigen::Index quantity) const;
};

/// m random functions, each with a kernel of its own, known at some places up to noise that the
/// values at one place share. Their joint posterior, derivatives included, is
///     mean = k' (K + N)^-1 y,  covariance = k(*, *) - k' (K + N)^-1 k
/// Source: Rasmussen and Williams, Gaussian Processes for Machine Learning (2006), eq. 2.23, 2.24;
/// derivatives: section 9.4.
class GaussianProcess {
  public:
    /// The noise at each place is multiplied by the kernels' noise factors and grows by the scatter
    /// between runs that they allow.
    GaussianProcess(std::vector<Kernel> kernels, const Observations& known);

    /// Requested value or derivative of one quantity.
    struct Requested {
        Eigen::Index quantity = 0;
        Functional functional;
    };
    /// @return posterior means, an entry for each request
    Eigen::VectorXd mean(const std::vector<Requested>& requested) const;
    /// @return posterior covariance, a row and column for each request
    Eigen::MatrixXd covariance(const std::vector<Requested>& requested) const;

  private:
    Eigen::MatrixXd with_known(const std::vector<Requested>& requested) const;

    Kernel::Prepared prepared(const Requested& requested) const {
        return kernels_[static_cast<std::size_t>(requested.quantity)].prepare(requested.functional);
    }

    std::vector<Kernel> kernels_;
    std::vector<std::vector<Kernel::Prepared>> known_;  ///< the places, by quantity
    Eigen::LLT<Eigen::MatrixXd> factor_;                ///< of K + N, quantity by quantity
    std::vector<Kernel::Known> sums_over_;              ///< them with (K + N)^-1 y
    std::vector<Eigen::VectorXd> coefficients_;  ///< posterior means of those of the polynomials
};

}  // namespace pendular
