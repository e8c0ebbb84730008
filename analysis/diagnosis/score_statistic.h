#pragma once

#include <Eigen/Core>
#include <vector>

#include "analysis/diagnosis/signature.h"
#include "analysis/misfit/null_draws.h"
#include "analysis/misfit/weighted_residuals.h"

namespace pendular {

/// Score test of one effect that a model lacks: a test, without a refit, whether the residuals r of
/// the model contain the change g of the readings that the effect makes. r and g are whitened; the
/// projection P (`WeightedResiduals`) removes what the calibrated parameters imitate. With
///     U = g' P r,   v = g' P g,
///     b = -tr(P Cov(e_f, e_g)),   v_c = v - tr(P Cov(e_g)),
/// the estimate of the amplitude is (U - b)/v_c, and the predicted reduction of chi2 is (U -
/// b)^2/v. b and v_c correct for the model's own errors: e_f of the prediction and e_g of the
/// change. A switch has amplitude 1 (on) or 0 (off); its predicted reduction of chi2 is 2 (U - b) -
/// v_c.
/// Sources: score tests (Rao 1948; modification indices, Soerbom 1989; power, Saris, Satorra and
/// van der Veld 2009), with errors in the derivatives.
struct ScoreTest {
    /// Orthonormal basis of the columns of P g: the change g of the readings by the effect, in
    /// units of their errors (whitened), from which P removes the part that the calibrated
    /// parameters imitate. It has no column if the parameters imitate the change completely, or if
    /// the change is not larger than its error.
    Eigen::MatrixXd basis;
    /// Estimated amplitude of the effect or error of measurement (`Signature`) [1], an entry for
    /// each column of the change g of the readings.
    Eigen::VectorXd estimate;
    double standard_error = 0;  ///< standard error of the first entry of `estimate` [1]
    /// Statistic of the score test [1]. If the model lacks nothing, it has a chi2 distribution with
    /// `basis.cols()` degrees of freedom.
    double statistic = 0;
    /// Predicted reduction of chi2 [1] when the model is refitted with the effect.
    double predicted_reduction = 0;
    /// Squared length [1] of the change of the readings by the effect, in units of their errors
    /// (whitened), without the part that the calibrated parameters imitate. For a change with
    /// several columns, that of the first.
    double length = 0;
    /// Squared length v (`length`) less the part that comes from the emulator's error of the change
    /// [1]. An effect of the true amplitude A gives the statistic the noncentrality A^2 v_c^2/v,
    /// with v_c = `information`.
    double information = 0;
    /// Share [1] of the squared length of the change of the readings by the effect, in units of
    /// their errors (whitened), that the calibrated parameters imitate.
    double share_imitated = 0;
    /// Whether the amplitude of the effect cannot be negative.
    bool one_sided = false;

    /// Whether the readings carry information on the amplitude of the effect: the calibrated
    /// parameters do not imitate its change completely, and the change exceeds its error.
    bool seen() const { return basis.cols() > 0; }
    /// p value of this test alone [1]: probability of a statistic at least as large if the model
    /// lacks nothing and the errors are exactly known; 1 if seen() is false.
    double p() const;
    /// Returns the value of the test statistic [1] at which the p value of this test alone equals
    /// `p` [1].
    double critical(double p) const;
    /// Returns the value of `statistic` for each random draw of errors, as if the model lacked
    /// nothing.
    /// @param residuals residuals that were tested
    Eigen::VectorXd drawn(const WeightedResiduals& residuals, const NullDraws& draws) const;
    /// Power of the test [1]: probability that its p value falls below `limit` [1] if the effect
    /// has the true amplitude `amplitude` [1].
    double power(double amplitude, double limit) const;
    /// Returns the amplitude of the effect [1] at which the p value falls below `limit` [1] with
    /// the probability `wanted` [1]; infinite if the readings carry no information on the
    /// amplitude.
    double detectable(double wanted, double limit) const;
};

/// Tests, without a refit, whether the residuals of a fit contain the change of the readings that
/// one effect or one suspect measurement (part of the measurement that may be wrong) makes.
/// @param signature change of the readings, with its errors
/// @param is_switch whether the effect is on or off, without a parameter
ScoreTest score_test(const WeightedResiduals& residuals, const Signature& signature,
                     bool is_switch);

/// Score tests of several effects or suspect measurements (parts of the measurement that may be
/// wrong) on the same residuals. Their p values are corrected for the number of tests by means of
/// random draws of errors.
class FamilyOfTests {
  public:
    /// @param tests score tests of one fit
    /// @param residuals residuals of this fit
    /// @param draws random draws of errors
    FamilyOfTests(const std::vector<ScoreTest>& tests, const WeightedResiduals& residuals,
                  const NullDraws& draws);

    /// p value corrected for the number of tests [1]: probability that at least one test has a p
    /// value of at most `smallest` if the model lacks nothing.
    double p(double smallest) const;
    /// Limit [1] on the p values of the single tests. If the model lacks nothing, at least one of
    /// the tests has a p value below this limit with the probability `probability`. Inverse of p().
    double limit(double probability) const;

  private:
    /// Score tests of the family for which the readings carry information on the amplitude.
    std::vector<ScoreTest> tests_;
    /// Statistics of the tests in the random draws of errors: a row for each draw, a column for
    /// each test.
    Eigen::MatrixXd drawn_;
};

}  // namespace pendular
