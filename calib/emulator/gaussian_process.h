#pragma once

#include <Eigen/Cholesky>
#include <Eigen/Core>
#include <vector>

#include "calib/emulator/kernel.h"

namespace pendular {

/// Observed values, with noise, of m quantities at n places. The quantities are functions of the
/// coordinates of a state of steady shear (`Coordinates`).
struct Observations {
    /// Places of the n observations, as coordinates of states of steady shear.
    std::vector<Coordinates> at;
    /// Observed values of the m quantities. The matrix has a row for each of the n places and a
    /// column for each quantity.
    Eigen::MatrixXd values;
    /// Covariance matrices (m x m) of the noise of the m observed values, one matrix for each
    /// place.
    std::vector<Eigen::MatrixXd> noise;

    /// Returns the observations of a single quantity, whose column in `values` has the index
    /// `quantity`.
    Observations only(Eigen::Index quantity) const;
};

/// Gaussian process of m random functions, each with its own kernel (prior covariance). The
/// functions are observed with noise at some places. At one place, the noise of different functions
/// is correlated. Values and derivatives at further places have the posterior
///     mean = k' (K + N)^-1 y,  covariance = k(*, *) - k' (K + N)^-1 k,
/// with the observed values y, the covariance N of the noise, and three prior covariances: K of the
/// observed values, k of the observed values with the predicted values, and k(*, *) of the
/// predicted values.
/// Source: Rasmussen and Williams, Gaussian Processes for Machine Learning (2006), eq. 2.23, 2.24;
/// derivatives: section 9.4.
class GaussianProcess {
  public:
    /// Trains the Gaussian process on the observations `known`. At each place, the noise of the
    /// functions k and l has the covariance
    ///     sqrt(n_k n_l) `known.noise`(k, l) + (s_k^2 if k = l, else 0),
    /// with the noise factor n_k and the between-run scatter s_k in the hyperparameters of kernel
    /// k.
    /// @param kernels kernel of each function, in the order of the columns of `known.values`
    /// @throws std::logic_error if the covariance of the observations is not positive definite
    GaussianProcess(std::vector<Kernel> kernels, const Observations& known);

    /// Value or derivative that is to be predicted. `quantity` is the index of the function, and
    /// `functional` states the place and the derivative.
    struct Requested {
        Eigen::Index quantity = 0;
        Functional functional;
    };
    /// Returns the posterior mean of each requested value or derivative, in the order of
    /// `requested`.
    Eigen::VectorXd mean(const std::vector<Requested>& requested) const;
    /// Requested values and derivatives of a Gaussian process, with the intermediate results from
    /// which the posterior covariances of the values and derivatives follow.
    struct Solved {
        /// Values and derivatives of the functions to predict.
        std::vector<Requested> requested;
        /// Terms of the prior covariances that depend only on the place of a requested value or
        /// derivative, for each entry of `requested`.
        std::vector<Kernel::Prepared> places;
        /// Matrix L^-1 k. L is the Cholesky factor of K + N, the prior covariance of the
        /// observations plus the covariance of the noise. k is the prior covariance of the
        /// observations (rows) with the requested values and derivatives (columns).
        Eigen::MatrixXd half;
    };
    /// Computes the intermediate results from which the posterior covariances of the requested
    /// values and derivatives follow.
    Solved solve(std::vector<Requested> requested) const;
    /// Returns the posterior covariance matrix of the requested values and derivatives. The matrix
    /// has a row and a column for each requested value or derivative, in the order of `requested`.
    Eigen::MatrixXd covariance_of(const Solved& requested) const;
    /// Returns the posterior covariance matrix of the requested values and derivatives. The matrix
    /// has a row and a column for each requested value or derivative, in the order of `requested`.
    Eigen::MatrixXd covariance(const std::vector<Requested>& requested) const {
        return covariance_of(solve(requested));
    }
    /// Returns the posterior covariance of the requested values and derivatives `a` (rows) with the
    /// requested values and derivatives `b` (columns).
    Eigen::MatrixXd covariance_between(const Solved& a, const Solved& b) const;

  private:
    /// Returns the prior covariance of the observations (rows) with the requested values and
    /// derivatives (columns). Rows: the first function at all observed places, then all places
    /// for the second function, and so on.
    Eigen::MatrixXd with_known(const std::vector<Requested>& requested) const;

    /// Returns the prior covariance of the requested value or derivative i of `a` with the
    /// requested value or derivative j of `b`.
    double prior_covariance(const Solved& a, std::size_t i, const Solved& b, std::size_t j) const;

    Kernel::Prepared prepared(const Requested& requested) const {
        return kernels_[static_cast<std::size_t>(requested.quantity)].prepare(requested.functional);
    }

    std::vector<Kernel> kernels_;
    /// Places of the observations, with the terms of the prior covariances that depend on one place
    /// alone. The outer list has an entry for each function, the inner list an entry for each
    /// place.
    std::vector<std::vector<Kernel::Prepared>> known_;
    /// Cholesky factor of the covariance of all observations, which is the prior covariance plus
    /// the covariance of the noise. Rows: the first function at all observed places, then all
    /// places for the second function, and so on.
    Eigen::LLT<Eigen::MatrixXd> factor_;
    /// For each function, the places of the observations with the weights C^-1 y, stored in a form
    /// in which `mean` sums over the places fast. C is the covariance of all observations (prior
    /// covariance plus covariance of the noise), and y contains the observed values.
    std::vector<Kernel::Known> sums_over_;
    /// For each function, the posterior means of the coefficients of the polynomials that the
    /// function contains (`Kernel`).
    std::vector<Eigen::VectorXd> coefficients_;
};

}  // namespace pendular
