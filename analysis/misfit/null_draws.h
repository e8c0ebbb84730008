#pragma once

#include <Eigen/Core>
#include <cmath>
#include <cstdint>
#include <vector>

#include "analysis/misfit/weighted_residuals.h"

namespace pendular {

/// Errors that several readings share. Each source of error, such as one filling of the cell,
/// causes one common error. Its variance is estimated by an analysis of variance from the mean
/// squares between and within sources:
///     variance = max(0, between - within)/steps      steps: steps of constant set points per
///     source
struct SharedErrors {
    /// Change of each measured value [its unit] if the error of a source is 1: a row for each
    /// measured value, a column for each source of error. A measured value is one observable of one
    /// reading, or one direct measurement of an effect's parameter.
    Eigen::MatrixXd loadings;
    /// Variance of the error of each source [1]. The sources contribute variance x loadings
    /// loadings' to the covariance of the measured values.
    double variance = 0;
    /// Mean squares of the analysis of variance [1]: of the relative deviations between sources of
    /// error, such as fillings of the cell (`between`), and between the steps of constant set
    /// points that one source affects (`within`).
    double between = 0, within = 0;
    /// Degrees of freedom of the mean square `between`; infinite if `variance` is known exactly.
    double freedom_between = INFINITY;
    /// Degrees of freedom of the mean square `within`.
    double freedom_within = INFINITY;
    /// Effective number of steps of constant set points that each source of error, such as a
    /// filling of the cell, affects.
    double steps = 1;
};

/// Uncertainty of the standard errors of the measured values, if the standard errors are estimated
/// from few replicates (readings at the same condition). A measured value is one observable of one
/// reading, or one direct measurement. The error of a measured value is the sum of an unshared
/// error and of errors that several measured values share. Unshared errors are of one kind if their
/// sizes follow from one estimate of the scatter.
struct ErrorKnowledge {
    /// Kind of the unshared error of each measured value, as an index into `freedom`. The sizes of
    /// all errors of one kind follow from one estimate of the scatter between replicates.
    std::vector<std::size_t> kind;
    /// For each kind of unshared error, degrees of freedom of the estimated scatter from which the
    /// size of the errors follows; infinite if the size is known exactly.
    std::vector<double> freedom;
    std::vector<SharedErrors> shared;  ///< errors that several readings share
    /// Number of readings. The measured values 2 k and 2 k + 1 are the shear stress and the solid
    /// fraction of reading k (k = 0, 1, ...).
    Eigen::Index readings = 0;
    /// Degrees of freedom of the estimated correlation between the errors of the shear stress and
    /// of the solid fraction of a reading; infinite if the correlation is known.
    double correlation_freedom = INFINITY;
    /// Uncertainty of the dependence of the errors' sizes on the normal stress: list of vectors v
    /// with an entry for each measured value. For each v, a random draw multiplies the error of
    /// measured value k by exp(z v_k), with one standard normal number z for all measured values.
    std::vector<Eigen::VectorXd> log_sizes;

    /// Returns the `ErrorKnowledge` of n measured values whose errors have exactly known sizes and
    /// are not shared.
    static ErrorKnowledge known(Eigen::Index n);
};

/// Random draws of the errors that readings and predictions would have if the fitted model lacked
/// nothing (null hypothesis). The draws include the uncertainty of the sizes of the errors
/// (`ErrorKnowledge`). In each draw,
/// - unshared errors of one kind are z sqrt(nu/chi2_nu), with normal numbers z of the estimated
///   covariance, the degrees of freedom nu of the estimate and a random number chi2_nu of the chi2
///   distribution;
/// - errors that readings share have the variance max(0, between nu_b/chi2_nu_b - within
///   nu_w/chi2_nu_w)/steps, with the mean squares of `SharedErrors` and their degrees of freedom
///   nu_b and nu_w;
/// - the correlation between the errors of the two observables of a reading deviates from its
///   estimate by tanh(z/sqrt(nu - 2)), with a standard normal number z and the degrees of freedom
///   nu of the estimate, at least 4 (after Fisher);
/// - errors of the prediction are normal with the prediction's covariance.
/// Source: generalised pivotal quantities of variance components, Burdick, Borror and Montgomery
/// (2005), Design and Analysis of Gauge R&R Studies, appendix B.
class NullDraws {
  public:
    /// Draws `count` sets of random errors of the measured values and of their predictions.
    /// @param measured measured values with the covariance of their errors
    /// @param knowledge uncertainty of the sizes of the errors
    /// @param seed seed of the random numbers
    NullDraws(const Measured& measured, const ErrorKnowledge& knowledge, std::uint64_t seed,
              Eigen::Index count);

    /// Returns the number of draws: sets of random errors of all measured values.
    Eigen::Index count() const { return errors_.cols(); }
    /// Returns the components [1] of the drawn errors along the columns of `basis`: a row for each
    /// column of `basis`, a column for each draw. Errors of measurement and prediction are whitened
    /// like `residuals` (multiplied by the inverse of the Cholesky factor of the covariance).
    Eigen::MatrixXd along(const WeightedResiduals& residuals, const Eigen::MatrixXd& basis) const {
        return along(residuals, basis, count());
    }
    /// Returns the components [1] of the first `draws` sets of drawn errors, whitened like
    /// `residuals`, along the columns of `basis`: a row for each column of `basis`, a column for
    /// each draw.
    Eigen::MatrixXd along(const WeightedResiduals& residuals, const Eigen::MatrixXd& basis,
                          Eigen::Index draws) const;
    /// Returns the sums of the random errors of measurement and prediction [1], whitened like
    /// `residuals` (multiplied by the inverse of the Cholesky factor of the covariance): a row for
    /// each measured value, a column for each draw.
    Eigen::MatrixXd whitened(const WeightedResiduals& residuals) const;

    /// Returns the p value [1] of a test statistic with the value `observed`: (1 + number of
    /// entries of `drawn` that are at least `observed`)/(1 + number of all entries of `drawn`).
    /// @param drawn value of the statistic in each random draw of errors
    static double p(double observed, const Eigen::VectorXd& drawn);

  private:
    /// Random errors of the measured values: a row for each measured value [its unit], a column for
    /// each draw.
    Eigen::MatrixXd errors_;
    /// Standard normal numbers from which the errors of the predictions follow: a row for each
    /// measured value, a column for each draw.
    Eigen::MatrixXd predictions_;
};

}  // namespace pendular
