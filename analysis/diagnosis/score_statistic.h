#pragma once

#include <Eigen/Core>
#include <vector>

#include "analysis/diagnosis/signature.h"
#include "analysis/misfit/null_draws.h"
#include "analysis/misfit/weighted_residuals.h"

namespace pendular {

/// Score test of one effect that a model lacks: a test, without a refit, whether the residuals r of
/// the model contain the change g of the readings that the effect causes. r and g are in units of
/// the readings' errors (whitened). With the projection P, which removes what the calibrated
/// parameters can imitate (`WeightedResiduals`),
///     U = g' P r,   v = g' P g,
///     b = -tr(P Cov(e_f, e_g)),   v_c = v - tr(P Cov(e_g)),
/// the estimated amplitude is (U - b)/v_c, and the predicted reduction of chi2 is (U - b)^2/v. The
/// terms b and v_c correct for the errors e_f of the prediction and e_g of the change. For a switch
/// (amplitude 1 if on, 0 if off), the predicted reduction of chi2 is 2 (U - b) - v_c.
/// Sources: score tests (Rao 1948; modification indices, Soerbom 1989; power, Saris, Satorra and
/// van der Veld 2009), with errors in the derivatives.
struct ScoreTest {
    /// Orthonormal basis of the columns of P g, with a row for each measured value. P g is the
    /// change g of the readings by the effect, in units of the readings' errors (whitened), without
    /// the part that the calibrated parameters imitate. The basis has no column if the parameters
    /// imitate the change completely, or if the change is not larger than its error.
    Eigen::MatrixXd basis;
    /// Estimated amplitude [1] (`Signature`) of the effect or of the error of measurement, with an
    /// entry for each parameter of the effect or each kind of error.
    Eigen::VectorXd estimate;
    double standard_error = 0;  ///< standard error of the first entry of `estimate` [1]
    /// Statistic of the score test [1]. If the model lacks nothing, the statistic has a chi2
    /// distribution with `basis.cols()` degrees of freedom. If the amplitude cannot be negative
    /// (`one_sided`), the statistic is 0 for a negative estimate.
    double statistic = 0;
    /// Reduction of chi2 [1] that is predicted for a refit of the model with the effect.
    double predicted_reduction = 0;
    /// Squared length [1] of the change of the readings by the effect, in units of the readings'
    /// errors (whitened), without the part that the calibrated parameters imitate. For an effect
    /// with several parameters, the squared length of the change by the first parameter.
    double length = 0;
    /// Squared length v of the change of the readings (`length`) [1], minus the part that comes
    /// from the error of the emulator (which interpolates simulations). An effect of the true
    /// amplitude A gives the statistic the noncentrality A^2 v_c^2/v, with v_c = `information`.
    double information = 0;
    /// Share [1] of the squared length of the change of the readings by the effect, in units of the
    /// readings' errors (whitened), that the calibrated parameters imitate.
    double share_imitated = 0;
    /// Whether the amplitude of the effect cannot be negative.
    bool one_sided = false;

    /// Whether the readings carry information on the amplitude of the effect: the calibrated
    /// parameters do not imitate the change of the readings completely, and the change exceeds its
    /// error.
    bool seen() const { return basis.cols() > 0; }
    /// Returns the p value [1] of the score test, not corrected for the number of tests:
    /// probability of a statistic at least as large as `statistic` if the model lacks nothing and
    /// the errors are exactly known. 1 if seen() is false.
    double p() const;
    /// Returns the critical value of `statistic` [1]: the value at which the p value of the score
    /// test, not corrected for the number of tests, equals `p` [1].
    double critical(double p) const;
    /// Returns the statistic of the score test [1] for each random draw of errors, computed from
    /// the drawn errors in place of the residuals.
    /// @param residuals residuals to which the score test was applied
    Eigen::VectorXd drawn(const WeightedResiduals& residuals, const NullDraws& draws) const;
    /// Returns the power of the score test [1]: probability that the p value of the test falls
    /// below `limit` [1] if the effect has the true amplitude `amplitude` [1].
    double power(double amplitude, double limit) const;
    /// Returns the true amplitude of the effect [1] at which the p value of the score test falls
    /// below `limit` [1] with the probability `wanted` [1]. Infinite if the readings carry no
    /// information on the amplitude.
    double detectable(double wanted, double limit) const;
};

/// Tests, without a refit, whether the residuals of a fit contain the change of the readings by one
/// effect, or by an error of one suspect measurement (part of the measurement that may be wrong).
/// @param signature change of the readings per unit of amplitude, with the errors of the change
/// @param is_switch whether the effect is a switch (on or off, without a parameter)
ScoreTest score_test(const WeightedResiduals& residuals, const Signature& signature,
                     bool is_switch);

/// Score tests (tests without a refit) of several effects or suspect measurements (parts of the
/// measurement that may be wrong) on the residuals of one fit. The p values are corrected for the
/// number of tests by means of random draws of errors.
class FamilyOfTests {
  public:
    /// Computes the statistics of all score tests of one fit for random draws of errors, and so the
    /// distribution of the statistics if the fitted model is right.
    /// @param tests score tests of one fit
    /// @param residuals residuals of the fit to which the score tests belong
    /// @param draws random draws of errors
    FamilyOfTests(const std::vector<ScoreTest>& tests, const WeightedResiduals& residuals,
                  const NullDraws& draws);

    /// Returns the p value corrected for the number of tests [1]: probability, if the model lacks
    /// nothing, that at least one of the score tests has an uncorrected p value of at most
    /// `smallest`.
    double p(double smallest) const;
    /// Returns the limit [1] for the uncorrected p values of the score tests. If the model lacks
    /// nothing, at least one of the tests has a p value below the limit with the probability
    /// `probability`. The function is the inverse of p().
    double limit(double probability) const;

  private:
    /// Score tests for which the readings carry information on the amplitude; all others are left
    /// out.
    std::vector<ScoreTest> tests_;
    /// Statistics of the score tests in the random draws of errors: a row for each draw, a column
    /// for each test.
    Eigen::MatrixXd drawn_;
};

}  // namespace pendular
