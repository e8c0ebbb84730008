#pragma once

#include <vector>

#include "analysis/diagnosis/explanation.h"
#include "analysis/diagnosis/verdict.h"

namespace pendular {

/// Diagnosis of a study's model: what was tested, and what follows from it.
struct Diagnosis : TestResults, Conclusion {
    /// Absolute cosines [1] of the angles between the signatures of two effects: a row and a column
    /// for each of `effects`. The signature is the change of the readings by the effect, whitened
    /// (in units of the readings' errors), without the part that the calibrated parameters can
    /// imitate. If the cosine is 1, the readings cannot tell both effects apart. Empty unless the
    /// verdict is `indistinguishable`.
    Eigen::MatrixXd cosines;
    /// Covariances of the errors of the predicted change of the readings by each candidate effect,
    /// in products of the units of the readings and in the order of ModelSpace::candidates(). The
    /// predicted change is divided by the amplitude of the effect (1 at the smallest size of
    /// interest).
    std::vector<ModelSpace::ChangeErrors> change_errors;

    /// Returns the whitened residuals (in units of their errors) of the readings from the fitted
    /// study's model without further effects.
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

/// Concludes anew from the tests of a diagnosis, with more that has a say in the verdict.
void conclude_anew(Diagnosis& diagnosis, const ModelSpace& space, const DiagnosisOptions& options,
                   const Circumstances& circumstances);

}  // namespace pendular
