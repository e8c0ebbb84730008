#pragma once

#include <vector>

#include "analysis/diagnosis/explanation.h"

namespace pendular {

/// Refits models of a space to readings and says whether they stand. All tests are from the same
/// draws of errors. Any number of threads may ask at once.
class Explanations {
  public:
    /// The arguments must outlive it.
    Explanations(const ModelSpace& space, const Evidence& evidence,
                 const DiagnosisOptions& options);

    /// The model with these candidates, and perhaps a suspect's error besides, fitted from these
    /// starts of its parameters.
    Explanation refit(const EffectSet& chosen, std::optional<std::size_t> suspect,
                      const Eigen::VectorXd& start) const;
    /// Tests a refitted model and says whether it stands.
    void judge(Explanation& explanation) const;

    /// Parameters at the end of their range take nothing over: they cannot move.
    WeightedResiduals residuals_of(const Explanation& explanation) const;
    double lack_of_fit_p(const WeightedResiduals& residuals) const;
    /// Score tests of each suspect measurement except the given one.
    std::vector<ScoreTest> suspect_tests(const WeightedResiduals& residuals,
                                         std::optional<std::size_t> but = {}) const;
    /// A candidate on top of a refitted model.
    Addition addition(const Explanation& explanation, std::size_t candidate) const;

    const NullDraws& draws() const { return draws_; }
    double half_significance() const { return options_.significance / 2; }

    /// Errors of what each candidate changes, per amplitude: they hold for all models alike.
    std::vector<ModelSpace::ChangeErrors> errors;

  private:
    std::vector<ScoreTest> further_tests(const WeightedResiduals& residuals,
                                         const Explanation& explanation) const;

    const ModelSpace& space_;
    const Evidence& evidence_;
    const DiagnosisOptions& options_;
    NullDraws draws_;
};

}  // namespace pendular
