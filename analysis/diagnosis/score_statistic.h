#pragma once

#include <Eigen/Core>
#include <vector>

#include "analysis/diagnosis/signature.h"
#include "analysis/misfit/null_draws.h"
#include "analysis/misfit/weighted_residuals.h"

namespace pendular {

/// Score test of one effect that a model lacks: a test, without a refit, whether the residuals r of
/// the model contain the change g of the readings by the effect (both whitened). With the
/// projection P of `WeightedResiduals`,
///     U = g' P r,   v = g' P g,
///     b = -tr(P Cov(e_f, e_g)),   v_c = v - tr(P Cov(e_g)),
/// the estimated amplitude is (U - b)/v_c, and the predicted reduction of chi2 is (U - b)^2/v. The
/// terms b and v_c correct for the errors e_f of the prediction and e_g of the change. For a switch
/// (amplitude 1 if on, 0 if off), the predicted reduction is 2 (U - b) - v_c.
/// Sources: score tests (Rao 1948; modification indices, Soerbom 1989; power, Saris, Satorra and
/// van der Veld 2009), with errors in the derivatives.
struct ScoreTest {
    /// Orthonormal basis of the columns of P g, with a row for each measured value. No column if
    /// the parameters imitate the change completely, or if the change is not larger than its error.
    Eigen::MatrixXd basis;
    /// Estimated amplitude [1] for each parameter of the effect or each kind of error.
    Eigen::VectorXd estimate;
    double standard_error = 0;  ///< of the first entry of `estimate` [1]
    /// Statistic [1] with a chi2 distribution of `basis.cols()` degrees of freedom if the model
    /// lacks nothing. If `one_sided`, 0 for a negative estimate.
    double statistic = 0;
    double predicted_reduction = 0;  ///< of chi2 by a refit with the effect [1]
    double length = 0;               ///< v, for the first parameter of the effect [1]
    /// v_c [1]. An effect of the amplitude A gives the statistic the noncentrality A^2 v_c^2/v.
    double information = 0;
    double share_imitated = 0;  ///< 1 - v/(g'g), of the change by all parameters [1]
    bool one_sided = false;     ///< whether the amplitude cannot be negative

    /// Whether the readings carry information on the amplitude.
    bool seen() const { return basis.cols() > 0; }
    /// Returns the p value [1], not corrected for the number of tests, as if the errors were
    /// exactly known; 1 if the effect is not seen().
    double p() const;
    /// Returns the value of `statistic` [1] at which p() is `p`.
    double critical(double p) const;
    /// Returns the statistic [1] for each draw of errors in place of the residuals.
    /// @param residuals those to which the score test was applied
    Eigen::VectorXd drawn(const WeightedResiduals& residuals, const NullDraws& draws) const;
    /// Returns the probability [1] that p() is below `limit` if the effect has the amplitude
    /// `amplitude`.
    double power(double amplitude, double limit) const;
    /// Returns the amplitude [1] at which p() is below `limit` with the probability `wanted`;
    /// infinite if the readings carry no information on the amplitude.
    double detectable(double wanted, double limit) const;
};

/// Score statistics of single columns, each the change of the readings by one possible cause.
struct ColumnScores {
    Eigen::MatrixXd directions;  ///< P g/|P g| of each column g; zero if the parameters imitate g
    Eigen::VectorXd lengths;     ///< |P g| [1/unit of the amplitude]; 0 if the parameters imitate g
    Eigen::VectorXd along;       ///< component of the residuals along each direction [1]
    Eigen::VectorXd imitated;    ///< 1 - |P g|^2/|g|^2, by the parameters [1]

    /// Returns the reduction of chi2 [1] by a refit with the column of index `k`.
    double reduction(Eigen::Index k) const { return along(k) * along(k); }
};
/// Share |P g|/|g| [1] of a column g below which what the parameters leave is rounding error.
constexpr double rounding_share = 1e-6;

/// Returns the score statistics of each column of `changes` alone [units of the readings].
/// @param least_left smallest share |P g|/|g| [1] that must remain after the calibrated parameters
///        imitate a column; a smaller remainder counts as rounding error
ColumnScores score_columns(const WeightedResiduals& residuals, const Eigen::MatrixXd& changes,
                           double least_left = rounding_share);

/// Tests whether residuals contain the change of the readings by an effect or by an error of one
/// suspect measurement.
/// @param signature change per unit of amplitude, with its errors
ScoreTest score_test(const WeightedResiduals& residuals, const Signature& signature,
                     bool is_switch);

/// Score tests of several effects or suspect measurements on the residuals of one fit, with p
/// values that random draws of errors correct for the number of tests.
class FamilyOfTests {
  public:
    FamilyOfTests(const std::vector<ScoreTest>& tests, const WeightedResiduals& residuals,
                  const NullDraws& draws);

    /// Returns the p value corrected for the number of tests [1]: probability, if the model lacks
    /// nothing, that at least one of the tests has an uncorrected p value of at most `smallest`.
    double p(double smallest) const;
    /// Returns the limit [1] of uncorrected p values below which at least one falls with the
    /// probability `probability` if the model lacks nothing: the inverse of p().
    double limit(double probability) const;

  private:
    std::vector<ScoreTest> tests_;  ///< those that are seen()
    Eigen::MatrixXd drawn_;         ///< statistics: draws x tests
};

}  // namespace pendular
