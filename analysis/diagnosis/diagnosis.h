#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "analysis/diagnosis/explanation.h"
#include "analysis/diagnosis/leaders.h"

namespace pendular {

/// Answer of a diagnosis to the question which physical effect a study's model lacks.
enum class Verdict {
    nothing_missing,     ///< the model fits, and every effect of interest would have been seen
    inconclusive,        ///< the model fits, but some effects of interest would stay unseen
    missing,             ///< the named effects are missing
    indistinguishable,   ///< several effect sets that share no effect fit equally well
    unknown,             ///< the model fails, and no known effect explains why
    suspect_measurement  ///< an error of the measurement explains the misfit
};
/// Name of a verdict, such as "nothing-missing".
std::string_view to_string(Verdict verdict);

/// Result of a diagnosis: whether the model is complete and, if not, which effects explain the
/// residuals.
struct Diagnosis {
    Verdict verdict = Verdict::inconclusive;
    /// Effects that the verdict names; with `inconclusive`, effects that would stay unseen.
    std::vector<std::string> effects;
    bool complete = true;  ///< whether the model with these effects fits the readings
    /// Model with the leading effects, which explain most of the misfit but not all of it; empty
    /// unless the verdict is `missing` and `complete` is false.
    std::optional<Leaders> leaders;
    /// Parts of the measurement whose error alone would explain the misfit.
    std::vector<std::string> suspects;
    std::vector<Explanation> confidence_set;  ///< smallest models that fit
    std::vector<Explanation> tried;           ///< all refitted models
    std::vector<Finding> scan;  ///< one finding per candidate, the largest reduction of chi2 first
    /// p value of each suspect measurement in the order of `Evidence::suspects`, corrected for the
    /// number of tests.
    std::vector<double> suspect_p;
    /// Absolute cosines between the whitened signatures of `effects`, after projecting out what the
    /// calibrated parameters imitate [1]; empty unless the verdict is `indistinguishable`.
    Eigen::MatrixXd cosines;
    Fit fit;          ///< fit of the model without further effects
    double chi2 = 0;  ///< chi2 of the model without further effects
    int dof = 0;      ///< degrees of freedom of `chi2`
    /// p values of the model without further effects: of the lack of fit of the conditions' means,
    /// and of the best further effect or suspect measurement, corrected for the number of tests.
    double lack_of_fit_p = 0, further_p = 0;
    bool errors_assumed = false;  ///< whether errors of some readings are assumed, not measured

    /// Whitened residuals of the model without further effects.
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
