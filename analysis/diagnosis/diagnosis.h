#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "analysis/diagnosis/explanation.h"
#include "analysis/diagnosis/leaders.h"

namespace pendular {

enum class Verdict {
    nothing_missing,
    inconclusive,
    missing,
    indistinguishable,
    unknown,
    suspect_measurement
};
/// Name of a verdict, such as "nothing-missing".
std::string_view to_string(Verdict verdict);

/// Result of a diagnosis: whether the model is complete and, if not, which effects explain the
/// residuals.
struct Diagnosis {
    Verdict verdict = Verdict::inconclusive;
    std::vector<std::string> effects;  ///< effects that the verdict names
    bool complete = true;  ///< whether the model with these effects explains the readings
    /// Where the verdict is `missing` and not complete: the model with the leading effects.
    std::optional<Leaders> leaders;
    std::vector<std::string> suspects;  ///< measurements whose error would explain the readings too
    std::vector<Explanation> confidence_set;  ///< smallest models that fit
    std::vector<Explanation> tried;           ///< all refitted models
    std::vector<Finding> scan;      ///< one finding per candidate, the largest reduction first
    std::vector<double> suspect_p;  ///< probability of each suspect measurement, tested alone
    Eigen::MatrixXd cosines;        ///< cosines between the projected signatures of `effects`
    Fit fit;                        ///< fit of the model without further effects
    double chi2 = 0;
    int dof = 0;
    double lack_of_fit_p = 0, further_p = 0;
    bool errors_assumed = false;

    /// Weighted residuals of the model without further effects.
    WeightedResiduals residuals(const Evidence& evidence) const {
        return {evidence.measured, fit.prediction};
    }
};

/// Tests whether the model is complete and, if not, which effects explain the residuals: fits it,
/// tests what is left for every candidate, refits those that the residuals ask for, and keeps the
/// smallest models that fit. A model fits where neither its lack of fit nor the best of the effects
/// that it still lacks is significant, each at half the significance, from the same draws of
/// errors. Where none fits, effects that explain most of the misfit are named, if there are any.
/// @throws InputError where there are no more readings than parameters
Diagnosis diagnose(const ModelSpace& space, const Evidence& evidence,
                   const DiagnosisOptions& options = {});

}  // namespace pendular
