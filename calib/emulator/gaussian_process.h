#pragma once

#include <Eigen/Cholesky>
#include <Eigen/Core>
#include <vector>

#include "calib/emulator/kernel.h"

namespace pendular {

/// Observed values, with noise, of m quantities at n places. The quantities are functions of the
/// coordinates of a state of steady shear.
struct Observations {
    /// Places of the n observations, as coordinates of states of steady shear.
    std::vector<Coordinates> at;
    /// Observed values of the m quantities: a row for each of the n places, a column for each
    /// quantity.
    Eigen::MatrixXd values;
    /// Covariance (m x m) of the noise of the m observed values at each place.
    std::vector<Eigen::MatrixXd> noise;

    /// Returns the observations of one quantity alone, given by its column in `values`.
    Observations only(Eigen::Index quantity) const;
};

/// Gaussian process of m random functions, each with its own kernel (prior covariance). The
/// functions are observed at some places with noise, which is correlated between the functions at
/// one place. The joint posterior of values and derivatives at other places is
///     mean = k' (K + N)^-1 y,  covariance = k(*, *) - k' (K + N)^-1 k,
/// with the observed values y, their prior covariance K, the covariance N of their noise, the prior
/// covariance k of the observations with the predicted values, and the prior covariance k(*, *) of
/// the predicted values.
/// Source: Rasmussen and Williams, Gaussian Processes for Machine Learning (2006), eq. 2.23, 2.24;
/// derivatives: section 9.4.
class GaussianProcess {
  public:
    /// Trains the process on the observations `known`. The covariance of the noise at each place is
    /// multiplied by the noise factors of the kernels' hyperparameters; then the squares of the
    /// between-run scatters are added to the variances.
    /// @param kernels kernel of each function, in the order of the columns of `known.values`
    /// @throws std::logic_error if the covariance of the observations is not positive definite
    GaussianProcess(std::vector<Kernel> kernels, const Observations& known);

    /// A value or derivative to predict, of the function with the index `quantity`.
    struct Requested {
        Eigen::Index quantity = 0;
        Functional functional;
    };
    /// Posterior mean of each requested value or derivative, in the order of `requested`.
    Eigen::VectorXd mean(const std::vector<Requested>& requested) const;
    /// Requested values and derivatives of a Gaussian process, with the intermediate results from
    /// which their covariances follow.
    struct Solved {
        /// Values and derivatives of the functions that are predicted.
        std::vector<Requested> requested;
        /// For each requested value or derivative, the terms of its prior covariances that depend
        /// on its place alone.
        std::vector<Kernel::Prepared> places;
        /// Matrix L^-1 k, with the Cholesky factor L of K + N (prior covariance of the observations
        /// plus their noise) and the prior covariance k of the observations (rows) with the
        /// requested values (columns).
        Eigen::MatrixXd half;
    };
    /// Computes the intermediate results from which the covariances of requested values and
    /// derivatives follow.
    Solved solve(std::vector<Requested> requested) const;
    /// Posterior covariance of the requested values and derivatives, a row and a column for each of
    /// them, in the order of `requested`.
    Eigen::MatrixXd covariance_of(const Solved& requested) const;
    /// Posterior covariance of the requested values and derivatives, a row and a column for each of
    /// them, in the order of `requested`.
    Eigen::MatrixXd covariance(const std::vector<Requested>& requested) const {
        return covariance_of(solve(requested));
    }
    /// Posterior covariance of the requested values and derivatives `a` (rows) with the requested
    /// values and derivatives `b` (columns).
    Eigen::MatrixXd covariance_between(const Solved& a, const Solved& b) const;

  private:
    /// Prior covariance of the observations (rows: all places for the first function, then all for
    /// the next) with the requested values and derivatives (columns).
    Eigen::MatrixXd with_known(const std::vector<Requested>& requested) const;

    /// Prior covariance of the requested value i of `a` with the requested value j of `b`.
    double prior_covariance(const Solved& a, std::size_t i, const Solved& b, std::size_t j) const;

    Kernel::Prepared prepared(const Requested& requested) const {
        return kernels_[static_cast<std::size_t>(requested.quantity)].prepare(requested.functional);
    }

    std::vector<Kernel> kernels_;
    /// For each function, the places of its observations, with the terms that prior covariances
    /// need.
    std::vector<std::vector<Kernel::Prepared>> known_;
    /// Cholesky factor of the covariance of all observations: prior covariance plus noise; all
    /// places for the first function, then all for the next.
    Eigen::LLT<Eigen::MatrixXd> factor_;
    /// For each function, its places in `known_` with the weights C^-1 y, stored so that `mean` can
    /// sum over them fast. C: covariance of all observations (prior covariance plus noise); y:
    /// observed values.
    std::vector<Kernel::Known> sums_over_;
    /// Posterior mean of the coefficients of the polynomial of each function.
    std::vector<Eigen::VectorXd> coefficients_;
};

}  // namespace pendular
