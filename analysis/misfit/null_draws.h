#pragma once

#include <Eigen/Core>
#include <cmath>
#include <cstdint>
#include <vector>

#include "analysis/misfit/weighted_residuals.h"

namespace pendular {

/// Errors that several readings share, such as the error of a filling of the cell, which is the
/// source of one error in all its readings. An entry is one observable of one reading. The variance
/// of a source is estimated from mean squares of an analysis of variance,
///     variance = max(0, between - within)/steps.
struct SharedErrors {
    Eigen::MatrixXd loadings;  ///< error of each entry by a source of variance 1, entries x sources
    double variance = 0;       ///< variance of each source in the covariance of the readings
    double between = 0, within = 0;     ///< mean squares between sources and between steps
    double freedom_between = INFINITY;  ///< degrees of freedom; infinite: the variance is known
    double freedom_within = INFINITY;   ///< degrees of freedom of `within`
    double steps = 1;                   ///< effective number of steps of each source
};

/// Uncertainty of the errors of readings, since few replicates determine them. The part of an
/// entry's error that no other entry shares belongs to a kind; its size is estimated once for each
/// kind.
struct ErrorKnowledge {
    std::vector<std::size_t> kind;  ///< kind of each entry
    /// Degrees of freedom with which the size of each kind was estimated; infinite: it is known.
    std::vector<double> freedom;
    std::vector<SharedErrors> shared;
    Eigen::Index readings = 0;  ///< number of readings; reading k has the entries 2k and 2k + 1
    /// Degrees of freedom with which the correlation between the two observables of a reading was
    /// estimated; infinite: it is known.
    double correlation_freedom = INFINITY;
    /// Uncertainty of the dependence of errors on normal stress: a draw multiplies the errors of
    /// the entries by exp(z v), for each vector v of this list and one standard normal z.
    std::vector<Eigen::VectorXd> log_sizes;

    /// Knowledge of n entries whose errors are exactly known.
    static ErrorKnowledge known(Eigen::Index n);
};

/// Random draws of the errors that readings and predictions would have if the model were complete
/// (null hypothesis), including the uncertainty of the errors' sizes. One set of draws serves all
/// tests of a diagnosis, so that its error rate holds for all tests together. In each draw,
/// - errors of each kind are z sqrt(nu/chi2_nu): z is normal with the estimated covariance, and nu
///   are the degrees of freedom of that estimate;
/// - errors that readings share have the variance
///   max(0, between nu_b/chi2_nu_b - within nu_w/chi2_nu_w)/steps;
/// - the correlation between the two observables of a reading deviates from its estimate by
///   tanh(z/sqrt(nu - 2)), z standard normal, after Fisher;
/// - errors of the prediction are normal with the prediction's covariance.
/// Source: generalised pivotal quantities of variance components, Burdick, Borror and Montgomery
/// (2005), Design and Analysis of Gauge R&R Studies, appendix B.
class NullDraws {
  public:
    /// Draws `count` sets of errors.
    NullDraws(const Measured& measured, const ErrorKnowledge& knowledge, std::uint64_t seed,
              Eigen::Index count);

    /// Number of draws.
    Eigen::Index count() const { return errors_.cols(); }
    /// B' times the drawn errors, whitened as these residuals, one column for each draw. B is
    /// `basis`.
    Eigen::MatrixXd along(const WeightedResiduals& residuals, const Eigen::MatrixXd& basis) const;
    /// Drawn errors, whitened as these residuals, entries x draws.
    Eigen::MatrixXd whitened(const WeightedResiduals& residuals) const;

    /// p value of a statistic [1], from its values `drawn` in the draws:
    /// (1 + number of draws with a statistic of at least `observed`) / (1 + number of draws).
    static double p(double observed, const Eigen::VectorXd& drawn);

  private:
    Eigen::MatrixXd errors_;       ///< errors of the measurement in its units, entries x draws
    Eigen::MatrixXd predictions_;  ///< standard normal numbers for errors of the predictions
};

}  // namespace pendular
