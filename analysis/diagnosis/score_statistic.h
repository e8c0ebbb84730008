#pragma once

#include <Eigen/Core>
#include <vector>

#include "analysis/diagnosis/signature.h"
#include "analysis/misfit/null_draws.h"
#include "analysis/misfit/weighted_residuals.h"

namespace pendular {

/// Score test of whether a change that a model does not make is in its residuals. In whitened units
/// with the calibrated parameters projected out, g' P r = U and g' P g = v; b and v_c take out what
/// the model's own errors e_f, e_g add to them on average:
///     b = -tr(P Cov(e_f, e_g)),  v_c = v - tr(P Cov(e_g)),
///     estimate = (U - b)/v_c,  predicted reduction of chi2 = (U - b)^2/v.
/// A switch has the amplitude 1 or none: its drop is 2 (U - b) - v_c.
/// Sources: score tests (Rao 1948; modification indices, Soerbom 1989; power, Saris, Satorra and
/// van der Veld 2009), with errors in the derivatives.
struct ScoreTest {
    Eigen::MatrixXd basis;      ///< orthonormal, of the columns of P g; none where nothing is left
    Eigen::VectorXd estimate;   ///< estimated amplitudes
    double standard_error = 0;  ///< standard error of the first amplitude
    double statistic = 0;       ///< chi2 of as many degrees of freedom as the basis has columns
    double predicted_reduction = 0;  ///< predicted reduction of chi2
    double length = 0;               ///< v
    double information =
        0;  ///< v_c: an amplitude A makes the statistic's noncentrality A^2 v_c^2/v
    double share_imitated = 0;  ///< share of g'g that the calibrated parameters imitate
    bool one_sided = false;

    /// Whether the readings carry information on the amplitude.
    bool seen() const { return basis.cols() > 0; }
    /// Probability of as large a statistic where nothing is missing, of this test alone, errors
    /// known.
    double p() const;
    /// Statistic at which p() is this.
    double critical(double p) const;
    /// Statistic in each draw of errors.
    Eigen::VectorXd drawn(const WeightedResiduals& residuals, const NullDraws& draws) const;
    /// Probability that a true amplitude leads to a p below a limit.
    double power(double amplitude, double limit) const;
    /// Amplitude at which that is `wanted`.
    double detectable(double wanted, double limit) const;
};

/// Score test of a change with its errors, both in the units of the readings.
ScoreTest score_test(const WeightedResiduals& residuals, const Signature& signature,
                     bool is_switch);

/// Family of score tests, with probabilities for the smallest p among them.
class FamilyOfTests {
  public:
    /// `residuals`: those that were tested.
    FamilyOfTests(const std::vector<ScoreTest>& tests, const WeightedResiduals& residuals,
                  const NullDraws& draws);

    /// Probability that any of the tests has a p as small as this where nothing is missing.
    double p(double smallest) const;
    /// The p that any of them falls below with this probability where nothing is missing.
    double limit(double probability) const;

  private:
    std::vector<ScoreTest> tests_;  ///< tests with information on their amplitude
    Eigen::MatrixXd drawn_;         ///< draws x tests
};

}  // namespace pendular
