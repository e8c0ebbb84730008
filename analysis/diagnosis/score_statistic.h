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
    /// Orthonormal basis of the columns of P g, the whitened change minus the part that the
    /// calibrated parameters imitate; without columns where the calibrated parameters imitate g
    /// completely or g is not larger than its error.
    Eigen::MatrixXd basis;
    Eigen::VectorXd estimate;   ///< estimated amplitude of the effect for each column of g [1]
    double standard_error = 0;  ///< standard error of the first of these amplitudes [1]
    /// Test statistic [1]; chi2 with `basis.cols()` degrees of freedom if nothing is missing.
    double statistic = 0;
    /// Reduction of chi2 that a refit with the effect is predicted to bring [1].
    double predicted_reduction = 0;
    /// v = g' P g of `ScoreTest`, for the first column of the whitened change g [1].
    double length = 0;
    /// v_c of `ScoreTest`, v minus the errors of the change, for the first column of g [1]; a true
    /// amplitude A gives the statistic the noncentrality A^2 v_c^2/v.
    double information = 0;
    /// Share of the squared length g'g that the calibrated parameters imitate [1].
    double share_imitated = 0;
    bool one_sided = false;  ///< whether the amplitude cannot be negative

    /// Whether the readings carry information on the effect's amplitude.
    bool seen() const { return basis.cols() > 0; }
    /// p value of this test alone: probability of a statistic at least as large where nothing is
    /// missing and the errors are exactly known [1]; 1 where seen() is false.
    double p() const;
    /// Value of `statistic` at which the p value p() equals `p`.
    double critical(double p) const;
    /// Value of `statistic` that each random draw of errors gives if nothing is missing, one entry
    /// for each draw. `residuals`: residuals that the test was made on.
    Eigen::VectorXd drawn(const WeightedResiduals& residuals, const NullDraws& draws) const;
    /// Power of the test [1]: probability that p() falls below `limit` where the true amplitude is
    /// `amplitude` [1].
    double power(double amplitude, double limit) const;
    /// Amplitude of the effect [1] at which p() falls below `limit` with the probability `wanted`;
    /// infinite where the readings carry no information.
    double detectable(double wanted, double limit) const;
};

/// Score test whether the residuals of a fit contain the change of the readings, `signature`, that
/// one effect or one suspect measurement makes. `is_switch`: the effect is on or off.
ScoreTest score_test(const WeightedResiduals& residuals, const Signature& signature,
                     bool is_switch);

/// Score tests of several effects or suspect measurements on the same residuals, with a correction
/// of their p values for the number of tests, from random draws of errors.
class FamilyOfTests {
  public:
    /// @param residuals residuals of the fit that all tests were made on
    FamilyOfTests(const std::vector<ScoreTest>& tests, const WeightedResiduals& residuals,
                  const NullDraws& draws);

    /// p value corrected for the number of tests [1]: probability, where nothing is missing, that
    /// at least one test has a p value of at most `smallest`.
    double p(double smallest) const;
    /// Limit of the p values of the single tests [1]: if nothing is missing, at least one of the
    /// tests has a p value below this limit with the given probability. The inverse of p().
    double limit(double probability) const;

  private:
    std::vector<ScoreTest> tests_;  ///< tests with information on their amplitude
    /// Statistics of the tests in the random draws of errors, draws x tests.
    Eigen::MatrixXd drawn_;
};

}  // namespace pendular
