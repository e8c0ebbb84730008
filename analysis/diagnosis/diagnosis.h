#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "analysis/diagnosis/explanation.h"
#include "analysis/diagnosis/leaders.h"

namespace pendular {

/// Answer of a diagnosis to the question which physical effect a study's model lacks.
enum class Verdict {
    /// Model fits, and every effect that can show in the readings at all would have shown in them
    /// if it were large enough to matter.
    nothing_missing,
    inconclusive,  ///< model fits, but some effects may be present unseen, or errors are assumed
    missing,       ///< the model lacks the effects in `Diagnosis::effects`
    /// Models with different further effects fit, and no effect is in all of them.
    indistinguishable,
    unknown,             ///< the model does not fit, and no known effect explains why
    suspect_measurement  ///< an error of the measurement would explain the misfit
};
/// Name of a verdict for output, such as "nothing-missing".
std::string_view to_string(Verdict verdict);

/// Result of a diagnosis: whether the model is complete and, if not, which effects explain the
/// residuals.
struct Diagnosis {
    Verdict verdict = Verdict::inconclusive;
    /// Names of the effects that the verdict is about: missing, possibly missing or, with
    /// `inconclusive`, effects that could matter without showing in the readings.
    std::vector<std::string> effects;
    /// False where neither the study's model nor any refitted one fits the readings.
    bool complete = true;
    /// Refitted model with the leading effects, which explain most of the misfit but not all of it;
    /// empty unless the verdict is `missing` and `complete` is false.
    std::optional<Leaders> leaders;
    /// Parts of the measurement whose error alone would explain the misfit, as text such as "the
    /// readings of dry_1.csv".
    std::vector<std::string> suspects;
    std::vector<Explanation> confidence_set;  ///< models that fit, with fewest further effects
    std::vector<Explanation> tried;           ///< all models that were refitted, accepted or not
    std::vector<Finding> scan;  ///< result for each candidate effect, largest chi2 reduction first
    /// p value of each suspect measurement (part of the measurement that may be wrong) in the order
    /// of `Evidence::suspects` [1], corrected for the number of tests.
    std::vector<double> suspect_p;
    /// Similarity of the changes of the readings by each two of `effects` [1]: absolute cosine of
    /// the whitened changes, without the parts that changes of the calibrated parameters could
    /// imitate. Empty unless the verdict is `indistinguishable`.
    Eigen::MatrixXd cosines;
    Fit fit;          ///< fit of the model without further effects
    double chi2 = 0;  ///< chi2 of all entries in the fit of the model without further effects
    int dof = 0;      ///< degrees of freedom of `chi2`
    /// p values [1] of the model without further effects: of the lack of fit of the conditions'
    /// means, and of the most significant candidate effect or suspect measurement, corrected for
    /// the number of tests.
    double lack_of_fit_p = 0, further_p = 0;
    /// For each candidate effect, covariances [squared units of the readings] of the change of the
    /// readings that it causes at amplitude 1, from errors of the emulator.
    std::vector<ModelSpace::ChangeErrors> change_errors;
    bool errors_assumed = false;  ///< whether errors of some readings are assumed, not measured

    /// Whitened residuals of the readings from the model without further effects. `evidence`: the
    /// readings that were diagnosed.
    WeightedResiduals residuals(const Evidence& evidence) const {
        return {evidence.measured, fit.prediction};
    }
};

/// Tests whether the model is complete and, if not, which effects explain the residuals. The
/// diagnosis fits the model, tests the residuals for every candidate (effect not in the model),
/// refits the model with the significant candidates, and keeps the smallest models that fit. A
/// model fits where neither its lack of fit nor the best effect that it still lacks is significant,
/// each at half of `options.significance`; both limits come from the same random draws of errors.
/// Where no model fits, the diagnosis names the effects that explain most of the misfit, if there
/// are any.
/// @throws InputError where there are no more measured values than calibrated parameters
Diagnosis diagnose(const ModelSpace& space, const Evidence& evidence,
                   const DiagnosisOptions& options = {});

}  // namespace pendular
