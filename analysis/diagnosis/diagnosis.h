#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "analysis/diagnosis/explanation.h"
#include "analysis/diagnosis/leaders.h"

namespace pendular {

/// Verdict of a diagnosis: whether a study's model lacks a physical effect.
enum class Verdict {
    /// The model fits, and the readings would have revealed every effect at its smallest size of
    /// interest, except effects that the readings cannot reveal at any size.
    nothing_missing,
    /// The model fits, but the readings cannot exclude some effects, or the errors of some readings
    /// are assumed, not measured.
    inconclusive,
    missing,  ///< the study's model lacks the effects in `Diagnosis::effects`
    /// Several models fit that add different effects to the study's model, and no added effect is
    /// common to all of these models.
    indistinguishable,
    unknown,  ///< the model does not fit, and no known effect explains why
    /// No effect explains the misfit, but an error of one part of the measurement would, such as an
    /// error of all readings of one file.
    suspect_measurement
};
/// Returns the name of a verdict for output, such as "nothing-missing".
std::string_view to_string(Verdict verdict);

/// Result of a diagnosis: whether a study's model is complete and, if not, which physical effects
/// explain the residuals.
struct Diagnosis {
    Verdict verdict = Verdict::inconclusive;
    /// Names of the effects that, according to the verdict, are missing from the study's model or
    /// may be missing. If the verdict is `inconclusive`, names of the effects that the readings
    /// cannot exclude at the effects' smallest sizes of interest.
    std::vector<std::string> effects;
    /// Whether a model fits the readings: the study's model, or a model that was refitted with
    /// further effects or with an error of measurement.
    bool complete = true;
    /// Leading effects, which explain most of the misfit but not all of it, and the study's model
    /// refitted with the leading effects. Empty unless the verdict is `missing` and `complete` is
    /// false.
    std::optional<Leaders> leaders;
    /// Names of the suspect measurements (parts of the measurement) whose error alone would explain
    /// the misfit, such as "the readings of dry_1.csv". If effects explain the misfit too, the list
    /// contains only suspect measurements that explain the readings at least as well as the best
    /// model with further effects, by Akaike's criterion (`Explanations::akaike`).
    std::vector<std::string> suspects;
    /// Models that fit the readings and between which the readings cannot decide. If the study's
    /// model fits, the set contains this model alone. Otherwise, the set contains the models with
    /// one further effect that fit after a refit, and the models with two further effects that fit
    /// clearly better or are needed since no single effect suffices. If no effects explain the
    /// misfit, the set contains the models that fit with an error of one suspect measurement (part
    /// of the measurement that may be wrong).
    std::vector<Explanation> confidence_set;
    /// All models that the diagnosis refitted with further effects or with an error of a suspect
    /// measurement, whether they fit the readings or not.
    std::vector<Explanation> tried;
    /// Result of the score test (test without a refit) of each candidate effect (not in the model),
    /// sorted by the reduction of chi2 by the effect, the largest first. A refit with the effect
    /// alone gives the reduction or, if there was no refit, the score test predicts the reduction.
    std::vector<Finding> scan;
    /// p value [1] of the score test of each suspect measurement (part of the measurement that may
    /// be wrong), corrected for the number of tests, in the order of `Evidence::suspects`.
    std::vector<double> suspect_p;
    /// Absolute cosines [1] of the angles between the signatures of two effects: a row and a column
    /// for each of `effects`. The signature is the change of the readings by the effect, whitened
    /// (in units of the readings' errors), without the part that the calibrated parameters can
    /// imitate. If the cosine is 1, the readings cannot tell both effects apart. Empty unless the
    /// verdict is `indistinguishable`.
    Eigen::MatrixXd cosines;
    Fit fit;  ///< fit of the study's model, without further effects, to the readings
    /// chi2 [1] of all measured values in the fit of the study's model without further effects.
    double chi2 = 0;
    /// Degrees of freedom of `chi2`: number of measured values minus number of fitted parameters
    /// and fitted constant cohesions.
    int dof = 0;
    /// p values [1] of two tests of the study's model without further effects. `lack_of_fit_p` is
    /// the p value of the test whether the model misses the mean of the readings at a condition.
    /// `further_p` is the p value of the most significant candidate effect (not in the model) or
    /// suspect measurement (part of the measurement that may be wrong), corrected for the number of
    /// tests.
    double lack_of_fit_p = 0, further_p = 0;
    /// Covariances of the errors of the predicted change of the readings by each candidate effect
    /// (not in the model), in products of the units of the readings and in the order of
    /// ModelSpace::candidates(). The emulator (which interpolates simulations) predicts the change,
    /// which is divided by the amplitude of the effect (1 at the smallest size of interest).
    std::vector<ModelSpace::ChangeErrors> change_errors;
    bool errors_assumed = false;  ///< whether the errors of some readings are assumed, not measured

    /// Returns the whitened residuals (in units of their errors) of the readings from the fitted
    /// study's model without further effects.
    /// @param evidence readings that were diagnosed
    WeightedResiduals residuals(const Evidence& evidence) const {
        return {evidence.measured, fit.prediction};
    }
};

/// Tests whether a study's model is complete and, if not, which physical effects explain the
/// residuals. The diagnosis fits the model and tests the residuals for each candidate effect (not
/// in the model) and each suspect measurement. Then the diagnosis refits the model with each
/// significant effect or error of a suspect measurement, and keeps the models that fit
/// (`Diagnosis::confidence_set`). If no model fits, the diagnosis names the effects that explain
/// most of the misfit, if there are any.
///
/// A model fits if it passes two tests, each at half of `options.significance`: the test whether
/// the model misses the mean of a condition (lack of fit), and the test of the most significant
/// effect or suspect measurement that the model does not contain. All p values come from one set of
/// random draws of errors.
/// @param space study's model and the candidate effects
/// @param evidence readings with their errors, and suspect measurements (parts of the measurement
///        that may be wrong)
/// @throws InputError if the number of measured values does not exceed the number of fitted
///         parameters and fitted constant cohesions
Diagnosis diagnose(const ModelSpace& space, const Evidence& evidence,
                   const DiagnosisOptions& options = {});

}  // namespace pendular
