#pragma once

#include <memory>
#include <vector>

#include "analysis/diagnosis/explanation.h"

namespace pendular {

/// Accuracy and limits of the refits of a diagnosis. A refit ends far within a standard error of
/// the optimum, in seconds; the accuracy of a study's final fit would take minutes.
inline constexpr FitEffort refit_effort{
    .most_steps = 12, .tolerance = 1e-6, .settled = 1e-4, .elsewhere = false};

/// Returns the whitened residuals (in units of their errors) of the readings from a fitted model.
/// Derivatives with respect to parameters at a bound are set to zero, since a parameter at its
/// bound cannot move to imitate a change.
/// @param fit fit of the model; amplitudes of an error of measurement may follow its parameters
WeightedResiduals residuals_of(const Model& model, const Measured& measured, const Fit& fit);

/// Refits a model with further effects to readings and tests whether the refitted model fits. All
/// tests use the same random draws of errors. Constant functions may be called from several threads
/// at once.
class Explanations {
  public:
    /// Draws the random errors of the readings for all tests. The arguments must outlive this
    /// object.
    /// @param space the model and its candidates (possible additions)
    Explanations(const ModelSpace& space, const Evidence& evidence,
                 const DiagnosisOptions& options);
    /// Tests models of another space against the same readings, with the random draws of `other`.
    /// The space and the arguments of `other` must outlive this object.
    /// @param space the model and its candidates
    Explanations(const ModelSpace& space, const Explanations& other);

    /// Fits the model with the effects `chosen` and, if given, with an error of the suspect
    /// measurement `suspect` to the readings. Whether the model fits is not tested.
    /// @param chosen effects to add, as indices into ModelSpace::candidates()
    /// @param suspect part of the measurement that may be wrong, as index into Evidence::suspects
    /// @param start starting values: parameters of the model, then amplitudes of the errors of
    ///        `suspect`
    /// @throws std::domain_error if the readings are impossible at `start`: no true state of the
    ///         cell gives the condition that the instrument shows
    Explanation refit(const EffectSet& chosen, std::optional<std::size_t> suspect,
                      const Eigen::VectorXd& start) const;
    /// Tests whether a refitted model fits the readings, and sets its p values and `accepted`. If
    /// the fit did not converge or the lack of fit is significant, further effects are not tested.
    void judge(Explanation& explanation) const;

    /// Returns the whitened residuals (in units of their errors) of the readings from a refitted
    /// model. Derivatives with respect to parameters at a bound are set to zero, since a parameter
    /// at its bound cannot move to imitate a change.
    WeightedResiduals residuals_of(const Explanation& explanation) const;
    /// p value of the test for lack of fit [1]: probability that errors of readings and predictions
    /// make the mean residuals of the conditions at least as large as observed.
    /// @param roughly whether to use only the first 600 random draws of errors if the residuals are
    ///        far larger than in all of these draws
    double lack_of_fit_p(const WeightedResiduals& residuals, bool roughly = false) const;
    /// Returns the score tests of all suspect measurements (parts of the measurement that may be
    /// wrong) in the order of Evidence::suspects.
    /// @param but index of one suspect measurement to leave out; empty: none
    std::vector<ScoreTest> suspect_tests(const WeightedResiduals& residuals,
                                         std::optional<std::size_t> but = {}) const;
    /// Returns the predictions of a refitted model with one further effect, as a function of the
    /// amplitude of the effect.
    /// @param candidate effect to add, as index into ModelSpace::candidates()
    Addition addition(const Explanation& explanation, std::size_t candidate) const;

    /// Random draws of the errors of readings and predictions that all tests use.
    const NullDraws& draws() const { return *draws_; }
    /// p value [1] below which a single test rejects a model. It is half of
    /// DiagnosisOptions::significance, since each model has two tests, for lack of fit and for
    /// further effects.
    double half_significance() const { return options_.significance / 2; }

    /// For each candidate effect (not in the model), covariances of the errors with which the
    /// emulator predicts how the effect changes the readings at its smallest size of interest
    /// (amplitude 1). The caller sets them once, before the tests of refitted models.
    std::vector<ModelSpace::ChangeErrors> errors;

  private:
    /// Returns the score tests (tests without a refit) of all effects and suspect measurements
    /// (parts of the measurement that may be wrong) that a refitted model does not contain.
    /// @param residuals residuals of the refitted model
    std::vector<ScoreTest> further_tests(const WeightedResiduals& residuals,
                                         const Explanation& explanation) const;

    const ModelSpace& space_;
    const Evidence& evidence_;
    const DiagnosisOptions& options_;
    std::shared_ptr<const NullDraws> draws_;
};

}  // namespace pendular
