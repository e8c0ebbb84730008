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
    /// Variance of each source, as included in the covariance of the readings.
    double variance = 0;
    /// Mean squares between sources and, within a source, between steps.
    double between = 0, within = 0;
    /// Degrees of freedom of `between`; infinite: `variance` is known.
    double freedom_between = INFINITY;
    double freedom_within = INFINITY;  ///< degrees of freedom of `within`
    double steps = 1;                  ///< effective number of steps of each source
};

/// How uncertain the sizes of the readings' errors are, since few replicates determine them. An
/// entry is one observable of one reading, or a direct measurement. The part of an entry's error
/// that no other entry shares belongs to a kind; its size is estimated once for each kind.
struct ErrorKnowledge {
    std::vector<std::size_t> kind;  ///< kind of each entry's own error, as index into `freedom`
    /// Degrees of freedom with which the size of each kind of error was estimated; infinite: the
    /// size is known.
    std::vector<double> freedom;
    std::vector<SharedErrors> shared;  ///< errors that several readings share
    Eigen::Index readings = 0;  ///< number of readings; reading k has the entries 2k and 2k + 1
    /// Degrees of freedom with which the correlation between the two observables of a reading was
    /// estimated; infinite: it is known.
    double correlation_freedom = INFINITY;
    /// Uncertainty of the dependence of errors on normal stress: a draw multiplies the errors of
    /// the entries by exp(z v), for each vector v of this list and one standard normal z.
    std::vector<Eigen::VectorXd> log_sizes;

    /// Returns the knowledge on n entries whose errors have exactly known sizes and are not shared.
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
    /// Draws `count` sets of errors of the measured entries and of their predictions, from random
    /// numbers with this seed.
    NullDraws(const Measured& measured, const ErrorKnowledge& knowledge, std::uint64_t seed,
              Eigen::Index count);

    /// Number of draws (sets of errors).
    Eigen::Index count() const { return errors_.cols(); }
    /// Components B' e of the drawn errors e along a basis, one column for each draw; e is whitened
    /// as these residuals, with drawn errors of measurement and prediction [1]. B is `basis`.
    Eigen::MatrixXd along(const WeightedResiduals& residuals, const Eigen::MatrixXd& basis) const {
        return along(residuals, basis, count());
    }
    /// Components along a basis of the first `draws` drawn errors only.
    Eigen::MatrixXd along(const WeightedResiduals& residuals, const Eigen::MatrixXd& basis,
                          Eigen::Index draws) const;
    /// Drawn errors of measurement and prediction, whitened as these residuals are (divided by the
    /// Cholesky factor of the covariance) [1], entries x draws.
    Eigen::MatrixXd whitened(const WeightedResiduals& residuals) const;

    /// p value [1] of a statistic with the value `observed`, from its values `drawn` in random
    /// draws: (1 + number of draws with a statistic of at least `observed`) / (1 + number of
    /// draws).
    static double p(double observed, const Eigen::VectorXd& drawn);

  private:
    /// Drawn errors of the measured values in their units, entries x draws.
    Eigen::MatrixXd errors_;
    /// Standard normal numbers, entries x draws, for errors of the predictions.
    Eigen::MatrixXd predictions_;
};

}  // namespace pendular
