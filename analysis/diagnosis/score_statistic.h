#pragma once

#include <Eigen/Core>
#include <vector>

#include "analysis/diagnosis/signature.h"
#include "analysis/misfit/null_draws.h"
#include "analysis/misfit/weighted_residuals.h"

namespace pendular {

/// Score test of one effect that a model lacks: whether the effect's change g of the readings is
/// present in the residuals r, tested without a refit. In whitened units, with P the projection
/// that removes what the calibrated parameters imitate, U = g' P r and v = g' P g. The model's own
/// errors, e_f of the prediction and e_g of the change, bias both; b and v_c correct for that:
///     b = -tr(P Cov(e_f, e_g)),  v_c = v - tr(P Cov(e_g)),
///     estimate = (U - b)/v_c,  predicted reduction of chi2 = (U - b)^2/v.
/// A switch is on or off, with amplitude 1 or 0: its predicted reduction is 2 (U - b) - v_c.
/// Sources: score tests (Rao 1948; modification indices, Soerbom 1989; power, Saris, Satorra and
/// van der Veld 2009), with errors in the derivatives.
struct ScoreTest {
    /// Orthonormal basis of the columns of P g; without columns where the calibrated parameters
    /// imitate g completely or g is not larger than its error.
    Eigen::MatrixXd basis;
    Eigen::VectorXd estimate;   ///< estimated amplitude for each column of g [1]
    double standard_error = 0;  ///< standard error of the first amplitude [1]
    double statistic = 0;       ///< chi2 with as many degrees of freedom as the basis has columns
    double predicted_reduction = 0;  ///< reduction of chi2 that a refit is predicted to bring
    double length = 0;               ///< v, for the first column of g
    /// v_c, for the first column of g; a true amplitude A gives the statistic the noncentrality
    /// A^2 v_c^2/v.
    double information = 0;
    double share_imitated = 0;  ///< share of g'g that the calibrated parameters imitate [1]
    bool one_sided = false;     ///< whether the amplitude cannot be negative

    /// Whether the readings carry information on the amplitude.
    bool seen() const { return basis.cols() > 0; }
    /// p value of this test alone: probability of a statistic at least as large where nothing is
    /// missing and the errors are exactly known [1]; 1 where seen() is false.
    double p() const;
    /// Statistic at which p() equals `p`.
    double critical(double p) const;
    /// Statistic that each random draw of errors gives where nothing is missing.
    Eigen::VectorXd drawn(const WeightedResiduals& residuals, const NullDraws& draws) const;
    /// Probability that p() falls below `limit` where the true amplitude is `amplitude` [1].
    double power(double amplitude, double limit) const;
    /// Amplitude at which the power is `wanted`, for p() below `limit`; infinite where the readings
    /// carry no information.
    double detectable(double wanted, double limit) const;
};

/// Score test of the change of the readings by one effect or one suspect measurement; the change
/// and its errors are in the units of the readings.
ScoreTest score_test(const WeightedResiduals& residuals, const Signature& signature,
                     bool is_switch);

/// Several score tests of the same residuals, with a correction of p values for their number.
class FamilyOfTests {
  public:
    /// @param residuals residuals that all tests were made on
    FamilyOfTests(const std::vector<ScoreTest>& tests, const WeightedResiduals& residuals,
                  const NullDraws& draws);

    /// Probability [1], where nothing is missing, that at least one test has a p value of at most
    /// `smallest`.
    double p(double smallest) const;
    /// p value that, where nothing is missing, at least one test falls below with this probability:
    /// the inverse of p().
    double limit(double probability) const;

  private:
    std::vector<ScoreTest> tests_;  ///< tests with information on their amplitude
    Eigen::MatrixXd drawn_;         ///< statistics in the random draws, draws x tests
};

}  // namespace pendular
