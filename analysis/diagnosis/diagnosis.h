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
    missing,  ///< the model lacks the effects in `Diagnosis::effects`
    /// Several models with different further effects fit, and no effect is in all of them.
    indistinguishable,
    unknown,             ///< the model does not fit, and no known effect explains why
    suspect_measurement  ///< an error of one part of the measurement would explain the misfit
};
/// Name of a verdict for output, such as "nothing-missing".
std::string_view to_string(Verdict verdict);

/// Result of a diagnosis: whether the model is complete and, if not, which physical effects explain
/// the residuals.
struct Diagnosis {
    Verdict verdict = Verdict::inconclusive;
    /// Names of the effects that the verdict is about: missing effects or effects that may be
    /// missing. With the verdict `inconclusive`, they are the effects that the readings cannot
    /// exclude at their smallest sizes of interest.
    std::vector<std::string> effects;
    /// Whether the study's model or a refitted one fits the readings.
    bool complete = true;
    /// Leading effects, which explain most of the misfit but not all of it, with the model refitted
    /// with them; empty unless the verdict is `missing` and `complete` is false.
    std::optional<Leaders> leaders;
    /// Parts of the measurement whose error alone would explain the misfit, as text such as "the
    /// readings of dry_1.csv".
    std::vector<std::string> suspects;
    /// Refitted models that fit the readings with the fewest further effects.
    std::vector<Explanation> confidence_set;
    std::vector<Explanation> tried;  ///< all models that were refitted, accepted or not
    /// Result of the score test of each candidate effect (not in the model), sorted by the
    /// reduction of chi2, the largest first.
    std::vector<Finding> scan;
    /// p value [1] of the test of each suspect measurement (part of the measurement that may be
    /// wrong), in the order of `Evidence::suspects`, corrected for the number of tests.
    std::vector<double> suspect_p;
    /// Similarity [1] of how each two of `effects` change the readings: absolute cosine between the
    /// whitened changes (in units of the readings' errors), without the parts that a change of the
    /// calibrated parameters can imitate. 1: the readings cannot tell the two effects apart. Empty
    /// unless the verdict is `indistinguishable`.
    Eigen::MatrixXd cosines;
    Fit fit;  ///< fit of the model without further effects
    /// Chi2 of all measured values in the fit of the model without further effects.
    double chi2 = 0;
    /// Degrees of freedom of the chi2 of all measured values in the fit of the model without
    /// further effects.
    int dof = 0;
    /// p values [1] of the tests of the model without further effects: for lack of fit of the
    /// conditions' means (`lack_of_fit_p`), and for the most significant candidate effect (not in
    /// the model) or suspect measurement (part of the measurement that may be wrong), corrected for
    /// the number of tests (`further_p`).
    double lack_of_fit_p = 0, further_p = 0;
    /// For each candidate effect (not in the model), covariances of the errors, in the squared
    /// units of the readings, with which the emulator predicts how the effect changes the readings
    /// at its smallest size of interest (amplitude 1).
    std::vector<ModelSpace::ChangeErrors> change_errors;
    bool errors_assumed = false;  ///< whether errors of some readings are assumed, not measured

    /// Returns the whitened residuals (in units of their errors) of the readings from the model
    /// without further effects.
    /// @param evidence readings that were diagnosed
    WeightedResiduals residuals(const Evidence& evidence) const {
        return {evidence.measured, fit.prediction};
    }
};

/// Tests whether a study's model is complete and, if not, which physical effects explain the
/// residuals. The diagnosis fits the model, tests the residuals for every candidate (effect not in
/// the model), refits the model with the significant candidates, and keeps the models that fit with
/// the fewest further effects. A model fits if neither its lack of fit nor the best effect that it
/// still lacks is significant, each at half of `options.significance`. All p values come from the
/// same random draws of errors. If no model fits, the diagnosis names the effects that explain most
/// of the misfit, if any do.
/// @param space the study's model and the candidates
/// @param evidence readings with their errors and with parts of the measurement that may be wrong
/// @throws InputError if the number of measured values does not exceed the number of fitted values
Diagnosis diagnose(const ModelSpace& space, const Evidence& evidence,
                   const DiagnosisOptions& options = {});

}  // namespace pendular
