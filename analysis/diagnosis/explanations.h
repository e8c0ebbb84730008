#pragma once

#include <vector>

#include "analysis/diagnosis/explanation.h"

namespace pendular {

/// Effort of a refit, which converges to far less than a standard error in seconds; the tolerance
/// of a study's fit would take minutes.
inline constexpr FitEffort refit_effort{
    .most_steps = 12, .tolerance = 1e-6, .settled = 1e-4, .elsewhere = false};

/// Whitened residuals of the readings from a fitted model. Derivatives by parameters at a bound are
/// set to zero, since such a parameter cannot move to imitate a change. `fit` may have amplitudes
/// of a suspect measurement after the parameters of `model`.
WeightedResiduals residuals_of(const Model& model, const Measured& measured, const Fit& fit);

/// Refits a model with further effects to readings and tests whether the result fits. All tests use
/// the same random draws of errors. Constant functions may be called from several threads at once.
class Explanations {
  public:
    /// Draws the random errors of the readings. `space` (the model and its candidates), `evidence`
    /// and `options` must outlive this object.
    Explanations(const ModelSpace& space, const Evidence& evidence,
                 const DiagnosisOptions& options);

    /// Returns the model with the candidate effects `chosen`, and with an error of the suspect
    /// measurement `suspect` (index into Evidence::suspects) if one is given, fitted to the
    /// readings from the parameter values `start`. Does not test whether it fits.
    Explanation refit(const EffectSet& chosen, std::optional<std::size_t> suspect,
                      const Eigen::VectorXd& start) const;
    /// Tests whether a refitted model fits the readings, and sets its p values and `accepted`.
    /// Further effects are not tested where the fit did not converge or lack of fit is significant.
    void judge(Explanation& explanation) const;

    /// Whitened residuals of the readings from a refitted model. Derivatives by parameters at a
    /// bound are set to zero, since such a parameter cannot move to imitate a change.
    WeightedResiduals residuals_of(const Explanation& explanation) const;
    /// p value of the lack of fit [1]: whether the mean residuals of the conditions are larger than
    /// the errors of readings and predictions explain.
    /// @param roughly whether to use only the first draws where the residuals are far larger than
    ///        in all of these draws
    double lack_of_fit_p(const WeightedResiduals& residuals, bool roughly = false) const;
    /// Score tests of all suspect measurements (parts of the measurement that may be wrong) except
    /// the one with index `but`, in the order of Evidence::suspects.
    std::vector<ScoreTest> suspect_tests(const WeightedResiduals& residuals,
                                         std::optional<std::size_t> but = {}) const;
    /// Predictions of a refitted model with one further candidate effect (index into
    /// ModelSpace::candidates()), as a function of the candidate's amplitude.
    Addition addition(const Explanation& explanation, std::size_t candidate) const;

    /// Random draws of the errors of readings and predictions that all tests use.
    const NullDraws& draws() const { return draws_; }
    /// p value below which each of the two tests of a model, for lack of fit and for further
    /// effects, rejects it: half of DiagnosisOptions::significance.
    double half_significance() const { return options_.significance / 2; }

    /// For each candidate effect, covariances of its change of the readings at amplitude 1, from
    /// errors of the emulator. The caller sets them once; they serve the tests of all refitted
    /// models.
    std::vector<ModelSpace::ChangeErrors> errors;

  private:
    /// Score tests of all candidate effects and suspect measurements that a refitted model does not
    /// contain, on its residuals.
    std::vector<ScoreTest> further_tests(const WeightedResiduals& residuals,
                                         const Explanation& explanation) const;

    const ModelSpace& space_;
    const Evidence& evidence_;
    const DiagnosisOptions& options_;
    NullDraws draws_;
};

}  // namespace pendular
