#pragma once

#include <Eigen/Core>
#include <cmath>
#include <cstdint>
#include <vector>

#include "analysis/misfit/weighted_residuals.h"

namespace pendular {

/// Errors that several readings share: each source, such as one filling of the cell, causes one
/// common error. An analysis of variance estimates its variance from mean squares between and
/// within sources:
///     variance = max(0, between - within)/steps
struct SharedErrors {
    /// Change of each measured value [its unit] by the error 1 of each source: a row for each
    /// measured value, a column for each source.
    Eigen::MatrixXd loadings;
    double variance = 0;                ///< of the error of each source [1]
    double between = 0, within = 0;     ///< mean squares of relative deviations [1]
    double freedom_between = INFINITY;  ///< infinite if `variance` is known exactly
    double freedom_within = INFINITY;
    double steps = 1;  ///< effective number of steps that each source affects
};

/// Uncertainty of the standard errors of the measured values, which few replicates estimate. An
/// error is the sum of an unshared error and of errors that several values share.
struct ErrorKnowledge {
    /// Kind of the unshared error of each measured value, as an index into `freedom`. One estimate
    /// of the scatter gives the sizes of all errors of one kind.
    std::vector<std::size_t> kind;
    std::vector<double> freedom;  ///< of the estimate for each kind; infinite: known
    std::vector<SharedErrors> shared;
    Eigen::Index readings = 0;  ///< measured values 2 k, 2 k + 1 are of reading k
    /// Degrees of freedom of the estimated correlation between the errors of shear stress and solid
    /// fraction of a reading; infinite if it is known.
    double correlation_freedom = INFINITY;
    /// Uncertainty of the dependence of the errors' sizes on the normal stress: for each vector v
    /// of this list, a draw multiplies the error of each measured value k by exp(z v_k), with one
    /// standard normal number z.
    std::vector<Eigen::VectorXd> log_sizes;

    /// Returns the knowledge of n unshared errors of exactly known sizes.
    static ErrorKnowledge known(Eigen::Index n);
};

/// Random draws of the errors that readings and predictions would have if the model lacked nothing
/// (null hypothesis). They include the uncertainty of the sizes of the errors, without which a test
/// on few replicates would reject right models too often. In each draw,
/// - unshared errors of one kind are z sqrt(nu/chi2_nu), with normal numbers z of the estimated
///   covariance, the degrees of freedom nu of the estimate and a chi2-distributed number chi2_nu;
/// - shared errors have the variance max(0, between nu_b/chi2_nu_b - within nu_w/chi2_nu_w)/steps;
/// - the correlation between the errors of the two observables of a reading deviates from its
///   estimate by tanh(z/sqrt(nu - 2)), with a standard normal z and the degrees of freedom nu of
///   the estimate, at least 4 (after Fisher);
/// - errors of the prediction are normal with the prediction's covariance.
///
/// Source: generalised pivotal quantities of variance components, Burdick, Borror and Montgomery
/// (2005), Design and Analysis of Gauge R&R Studies, appendix B.
class NullDraws {
  public:
    NullDraws(const Measured& measured, const ErrorKnowledge& knowledge, std::uint64_t seed,
              Eigen::Index count);

    Eigen::Index count() const { return errors_.cols(); }
    /// Returns the components [1] of the drawn errors, whitened like `residuals`, along the columns
    /// of `basis`: a row for each column of `basis`, a column for each draw.
    Eigen::MatrixXd along(const WeightedResiduals& residuals, const Eigen::MatrixXd& basis) const {
        return along(residuals, basis, count());
    }
    /// Returns the components of the first `draws` draws alone.
    Eigen::MatrixXd along(const WeightedResiduals& residuals, const Eigen::MatrixXd& basis,
                          Eigen::Index draws) const;
    /// Returns the drawn errors of measurement and prediction together [1], whitened like
    /// `residuals`: a row for each measured value, a column for each draw.
    Eigen::MatrixXd whitened(const WeightedResiduals& residuals) const;

    /// Returns the p value [1] of a statistic: (1 + number of entries of `drawn` that are at least
    /// `observed`)/(1 + number of entries).
    static double p(double observed, const Eigen::VectorXd& drawn);

  private:
    Eigen::MatrixXd errors_;  ///< a row for each measured value [its unit], a column for each draw
    Eigen::MatrixXd predictions_;  ///< standard normal numbers, likewise
};

}  // namespace pendular
