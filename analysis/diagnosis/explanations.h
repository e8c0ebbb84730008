#pragma once

#include <vector>

#include "analysis/diagnosis/explanation.h"

namespace pendular {

/// Refits models of a space to readings and tests whether they fit. All tests use the same draws of
/// errors. Any number of threads may call it at once.
class Explanations {
  public:
    /// The arguments must outlive it.
    Explanations(const ModelSpace& space, const Evidence& evidence,
                 const DiagnosisOptions& options);

    /// The model with these candidates, and perhaps a suspect's error besides, fitted from these
    /// starts of its parameters.
    Explanation refit(const EffectSet& chosen, std::optional<std::size_t> suspect,
                      const Eigen::VectorXd& start) const;
    /// Tests whether a refitted model fits.
    void judge(Explanation& explanation) const;

    /// Residuals of a refitted model. Parameters at a bound imitate nothing: they cannot move.
    WeightedResiduals residuals_of(const Explanation& explanation) const;
    double lack_of_fit_p(const WeightedResiduals& residuals) const;
    /// Score tests of each suspect measurement except the given one.
    std::vector<ScoreTest> suspect_tests(const WeightedResiduals& residuals,
                                         std::optional<std::size_t> but = {}) const;
    /// Addition of a candidate to a refitted model.
    Addition addition(const Explanation& explanation, std::size_t candidate) const;

    const NullDraws& draws() const { return draws_; }
    double half_significance() const { return options_.significance / 2; }

    /// Errors of the change by each candidate, per amplitude; the same for all models.
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
