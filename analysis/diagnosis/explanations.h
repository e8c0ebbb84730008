#pragma once

#include <vector>

#include "analysis/diagnosis/explanation.h"

namespace pendular {

/// Refits a model with further effects to readings and tests whether the result fits. All tests use
/// the same random draws of errors. Constant functions may be called from several threads at once.
class Explanations {
  public:
    /// `space`, `evidence` and `options` must outlive this object.
    Explanations(const ModelSpace& space, const Evidence& evidence,
                 const DiagnosisOptions& options);

    /// Returns the model with the candidates `chosen`, and with an error of the suspect measurement
    /// if one is given, fitted from the parameter values `start`.
    Explanation refit(const EffectSet& chosen, std::optional<std::size_t> suspect,
                      const Eigen::VectorXd& start) const;
    /// Tests whether a refitted model fits, and sets its p values and `accepted`.
    void judge(Explanation& explanation) const;

    /// Whitened residuals of a refitted model. Derivatives by parameters at a bound are set to
    /// zero, since such a parameter cannot move to imitate a change.
    WeightedResiduals residuals_of(const Explanation& explanation) const;
    /// p value of the lack of fit of the conditions' means [1].
    double lack_of_fit_p(const WeightedResiduals& residuals) const;
    /// Score tests of all suspect measurements except `but`.
    std::vector<ScoreTest> suspect_tests(const WeightedResiduals& residuals,
                                         std::optional<std::size_t> but = {}) const;
    /// Predictions of a refitted model with one further candidate, by amplitude.
    Addition addition(const Explanation& explanation, std::size_t candidate) const;

    /// Random draws of errors that all tests use.
    const NullDraws& draws() const { return draws_; }
    /// Significance of each of the two tests, of lack of fit and of further effects.
    double half_significance() const { return options_.significance / 2; }

    /// Covariances, per amplitude, of the change that each candidate makes, from errors of the
    /// emulator. The caller sets them once; they serve all models.
    std::vector<ModelSpace::ChangeErrors> errors;

  private:
    /// Score tests of all candidates and suspects that the refitted model does not contain.
    std::vector<ScoreTest> further_tests(const WeightedResiduals& residuals,
                                         const Explanation& explanation) const;

    const ModelSpace& space_;
    const Evidence& evidence_;
    const DiagnosisOptions& options_;
    NullDraws draws_;
};

}  // namespace pendular
