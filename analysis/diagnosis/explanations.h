#pragma once

#include <memory>
#include <vector>

#include "analysis/diagnosis/explanation.h"

namespace pendular {

/// Accuracy and limits of the refits (fits with a changed model) of a diagnosis. A refit ends
/// within seconds, at parameters that differ from the best fit by far less than a standard error. A
/// refit with the accuracy of a study's final fit would take minutes.
inline constexpr FitEffort refit_effort{
    .most_steps = 12, .tolerance = 1e-6, .settled = 1e-4, .elsewhere = false};

/// Returns the whitened residuals (in units of their errors) of the readings from a fitted model.
/// Derivatives with respect to parameters at a bound of their range are set to zero, since these
/// parameters cannot change to imitate an effect.
/// @param fit fit of the model; fitted amplitudes of an error of measurement may follow the model's
///        parameters
WeightedResiduals residuals_of(const Model& model, const Measured& measured, const Fit& fit);

/// Refits a study's model with further effects to readings, and tests whether the refitted models
/// fit. All tests use one set of random draws of errors. Several threads may call the constant
/// member functions at once.
class Explanations {
  public:
    /// Draws the random errors of readings and predictions for all tests. The arguments must
    /// outlive this object.
    /// @param space study's model and the candidates (effects that may be added to the model)
    Explanations(const ModelSpace& space, const Evidence& evidence,
                 const DiagnosisOptions& options);
    /// Takes the readings and the random draws of errors from `other`, for tests of the models of
    /// `space`. `space` and the arguments with which `other` was made must outlive this object.
    /// @param space study's model and the candidates (effects that may be added to the model)
    /// @param other tests of other models against the readings
    Explanations(const ModelSpace& space, const Explanations& other);

    /// Fits the study's model with the effects `chosen` and, if given, with an error of the suspect
    /// measurement `suspect`, to the readings. The function does not test whether the refitted
    /// model fits (`judge`).
    /// @param chosen effects to add, as indices into ModelSpace::candidates()
    /// @param suspect part of the measurement that may be wrong, as index into Evidence::suspects
    /// @param start starting values: first the parameters of the model, then the amplitudes of the
    ///        errors of `suspect`
    /// @throws std::domain_error if the readings are impossible with the parameters `start`: no
    ///         true state of the cell gives the conditions that the instrument shows
    Explanation refit(const EffectSet& chosen, std::optional<std::size_t> suspect,
                      const Eigen::VectorXd& start) const;
    /// Tests whether a refitted model fits the readings, and sets the p values and `accepted` of
    /// `explanation`. Further effects are not tested if the fit did not converge, or if the p value
    /// of the test for lack of fit is below half of DiagnosisOptions::least_p.
    void judge(Explanation& explanation) const;

    /// Returns the whitened residuals (in units of their errors) of the readings from a refitted
    /// model. Derivatives with respect to parameters at a bound of their range are set to zero,
    /// since these parameters cannot change to imitate an effect.
    WeightedResiduals residuals_of(const Explanation& explanation) const;
    /// Returns Akaike's criterion [1] of a refitted model (ranking.h), with ln det Sigma.
    double criterion(const Explanation& explanation, double variance_factor = 1) const;
    /// Returns the p value [1] of the test for lack of fit: probability that errors of readings and
    /// predictions alone make the mean residuals of the conditions at least as large as observed.
    /// @param roughly whether to use only the first 600 random draws of errors if the mean
    ///        residuals are far larger than in each of these draws
    double lack_of_fit_p(const WeightedResiduals& residuals, bool roughly = false) const;
    /// Returns the score tests (tests without a refit) of all suspect measurements (parts of the
    /// measurement that may be wrong), in the order of Evidence::suspects.
    /// @param but index in Evidence::suspects of one suspect measurement to leave out; empty: none
    ///        is left out
    std::vector<ScoreTest> suspect_tests(const WeightedResiduals& residuals,
                                         std::optional<std::size_t> but = {}) const;
    /// Returns the predictions of a refitted model to which one further effect is added, as a
    /// function of the amplitude of the added effect.
    /// @param candidate effect to add, as index into ModelSpace::candidates()
    Addition addition(const Explanation& explanation, std::size_t candidate) const;

    /// Returns the random draws of the errors of readings and predictions that all tests use.
    const NullDraws& draws() const { return *draws_; }
    /// Returns the p value [1] below which a single test rejects a model. The value is half of
    /// DiagnosisOptions::significance, since each model has two tests, one for lack of fit and one
    /// for further effects.
    double half_significance() const { return options_.significance / 2; }

    /// Covariances of the errors of the predicted change of the readings by each candidate effect
    /// (not in the study's model), in products of the units of the readings and in the order of
    /// ModelSpace::candidates(). The emulator predicts the change, which is divided by the
    /// amplitude of the effect (1 at the smallest size of interest). The caller sets the
    /// covariances once, before the first test of a refitted model.
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
