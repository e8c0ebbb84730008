#pragma once

#include <Eigen/Core>
#include <vector>

#include "calib/emulator/kernel.h"
#include "data/quantities/decompositions.h"

namespace pendular {

/// Observed values, with noise, of m quantities at n places, as functions of `Coordinates`.
struct Observations {
    std::vector<Coordinates> at;
    Eigen::MatrixXd values;              ///< n x m
    std::vector<Eigen::MatrixXd> noise;  ///< m x m covariance at each place

    /// Returns the observations of the quantity in the column `quantity` of `values` alone.
    Observations only(Eigen::Index quantity) const;
};

/// Gaussian process of m random functions, each with its own kernel, observed with noise at some
/// places. At one place, the noise of different functions is correlated. Values and derivatives at
/// further places have the posterior
///     mean = k' (K + N)^-1 y,  covariance = k(*, *) - k' (K + N)^-1 k,
/// with the observed values y, the covariance N of the noise, and three prior covariances: K of the
/// observed values, k of the observed values with the predicted values, and k(*, *) of the
/// predicted values. Observations are ordered by function, then by place.
/// Source: Rasmussen and Williams, Gaussian Processes for Machine Learning (2006), eq. 2.23, 2.24;
/// derivatives: section 9.4.
class GaussianProcess {
  public:
    /// Trains the process. At each place, the noise of the functions k and l has the covariance
    ///     sqrt(n_k n_l) `known.noise`(k, l) + (s_k^2 if k = l, else 0),
    /// with the noise factor n_k and the between-run scatter s_k of the hyperparameters of kernel
    /// k.
    /// @param kernels kernel of each function, in the order of the columns of `known.values`
    /// @throws std::logic_error if the covariance of the observations is not positive definite
    GaussianProcess(std::vector<Kernel> kernels, const Observations& known);

    /// Value or derivative of the function with index `quantity`.
    struct Requested {
        Eigen::Index quantity = 0;
        Functional functional;
    };
    /// Returns the posterior mean of each requested value or derivative.
    Eigen::VectorXd mean(const std::vector<Requested>& requested) const;
    /// Requests with the intermediate results from which their posterior covariances follow.
    struct Solved {
        std::vector<Requested> requested;
        std::vector<Kernel::Prepared> places;
        /// Matrix L^-1 k, with the Cholesky factor L of K + N.
        Eigen::MatrixXd half;
    };
    Solved solve(std::vector<Requested> requested) const;
    /// Returns the posterior covariance matrix of the requested values and derivatives.
    Eigen::MatrixXd covariance_of(const Solved& requested) const;
    Eigen::MatrixXd covariance(const std::vector<Requested>& requested) const {
        return covariance_of(solve(requested));
    }
    /// Returns the posterior covariance of the requests `a` (rows) with the requests `b` (columns).
    Eigen::MatrixXd covariance_between(const Solved& a, const Solved& b) const;

  private:
    /// Returns k: the prior covariance of the observations (rows) with the requests (columns).
    Eigen::MatrixXd with_known(const std::vector<Requested>& requested) const;

    double prior_covariance(const Solved& a, std::size_t i, const Solved& b, std::size_t j) const;

    Kernel::Prepared prepared(const Requested& requested) const {
        return kernels_[static_cast<std::size_t>(requested.quantity)].prepare(requested.functional);
    }

    std::vector<Kernel> kernels_;
    std::vector<std::vector<Kernel::Prepared>> known_;  ///< for each function and place
    Eigen::LLT<Eigen::MatrixXd> factor_;                ///< of K + N
    /// Places of the observations with the weights (K + N)^-1 y, for each function, in a form in
    /// which `mean` sums over the places fast.
    std::vector<Kernel::Known> sums_over_;
    std::vector<Eigen::VectorXd> coefficients_;  ///< of the polynomials, posterior means
};

/// Returns the hyperparameters of the Gaussian process of one quantity that maximise the product of
/// likelihood and prior. Broad log-normal priors keep undetermined hyperparameters finite.
/// @param known observations; only the first column of `known.values` is used
/// @param unit typical size of the quantity, in the unit of the quantity
/// @throws std::invalid_argument if `known` has no observation
Hyperparameters fit_hyperparameters(Domain domain, const Observations& known, double unit);

/// Returns the cost that `fit_hyperparameters` minimises [1]: -ln(likelihood) - ln(prior), up to a
/// constant; infinite if the covariance of the observations is not positive definite.
/// @param gradient receives the derivatives of the cost with respect to the logarithms of the
///        hyperparameters, in the order of `Hyperparameters::names`; may be null
double hyperparameter_cost(Domain domain, const Observations& known, double unit,
                           const Hyperparameters& hyperparameters, double* gradient);

}  // namespace pendular
