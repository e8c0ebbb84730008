#pragma once

#include <Eigen/Core>
#include <cmath>
#include <cstdint>
#include <vector>

#include "analysis/misfit/weighted_residuals.h"

namespace pendular {

/// An error that entries of several readings share, such as that of a filling. An entry is one
/// observable of one reading. What is known of the variance of its sources comes from the mean
/// squares of an analysis of variance,
///     variance = max(0, between - within)/steps.
struct SharedErrors {
    Eigen::MatrixXd loadings;  ///< entries x sources: what a source of variance 1 adds to entries
    double variance = 0;       ///< variance of the sources in the covariance of the readings
    double between = 0, within = 0;
    double freedom_between = INFINITY;  ///< infinite: the variance is known
    double freedom_within = INFINITY;
    double steps = 1;
};

/// Uncertainty of the errors of readings. The error of entry k that no other entry shares is of
/// kind `kind[k]`, whose size was estimated with `freedom[kind]` degrees of freedom; infinite where
/// it is known.
struct ErrorKnowledge {
    std::vector<std::size_t> kind;
    std::vector<double> freedom;
    std::vector<SharedErrors> shared;
    /// Entries 2k and 2k + 1 are of one reading for k below this; their correlation was estimated
    /// with `correlation_freedom` degrees of freedom.
    Eigen::Index readings = 0;
    double correlation_freedom = INFINITY;
    /// Uncertainty of the dependence on load: in a draw, errors are multiplied by exp(z column)
    /// with one standard normal z for each column.
    std::vector<Eigen::VectorXd> log_sizes;

    /// Errors of n entries that are known exactly.
    static ErrorKnowledge known(Eigen::Index n);
};

/// Errors of the readings as they come, in the units of the readings. Errors of each kind are
///     z sqrt(nu/chi2_nu),   z normal as believed,
/// those that readings share have variances drawn likewise: max(0, between nu_b/chi2 - within
/// nu_w/chi2)/steps. The correlation between the observables of a reading is off by tanh(z/sqrt(nu
/// - 2)), after Fisher. To them come errors of the prediction, normal as it says. The same draws
/// serve every test of a diagnosis, so that its tests together are wrong as often as is said.
/// Source: generalised pivotal quantities of variance components, Burdick, Borror and Montgomery
/// (2005), Design and Analysis of Gauge R&R Studies, appendix B.
class NullDraws {
  public:
    NullDraws(const Measured& measured, const ErrorKnowledge& knowledge, std::uint64_t seed,
              Eigen::Index count);

    Eigen::Index count() const { return errors_.cols(); }
    /// B' times the errors in the whitened units of these residuals, a column for each draw.
    Eigen::MatrixXd along(const WeightedResiduals& residuals, const Eigen::MatrixXd& basis) const;
    /// Errors in the whitened units of these residuals.
    Eigen::MatrixXd whitened(const WeightedResiduals& residuals) const;

    /// Probability of a statistic at least as large as `observed`, from its values in the draws:
    /// (1 + how many are) / (1 + draws).
    static double p(double observed, const Eigen::VectorXd& drawn);

  private:
    Eigen::MatrixXd errors_;       ///< errors of the measurement, in its units
    Eigen::MatrixXd predictions_;  ///< standard normal numbers for errors of the predictions
};

}  // namespace pendular
