#pragma once

#include <array>
#include <vector>

#include "analysis/diagnosis/evidence.h"
#include "analysis/diagnosis/verdict.h"
#include "calib/model/study_model_space.h"

namespace pendular {

/// Tests of a study's model and the conclusion from them.
struct Diagnosis : TestResults, Conclusion {
    /// Absolute cosines [1] of the angles between the projected signatures of `effects`; 1: the
    /// readings cannot tell two effects apart. Empty unless the verdict is `indistinguishable`.
    Eigen::MatrixXd cosines;
    /// Covariances of the errors of the predicted change of the readings per unit of each
    /// candidate's amplitude, in products of the units of the readings.
    std::vector<ModelSpace::ChangeErrors> change_errors;
    /// Largest factor [1] on the discrepancy of the models at which the study's model is rejected
    /// still, up to `most_inexact`; 0 if it is accepted, or if its discrepancy is 0.
    double holds_up_to = 0;

    /// Returns the residuals of the study's model without further effects.
    WeightedResiduals residuals(const Evidence& evidence) const {
        return {evidence.measured, base.fit.prediction};
    }
};

/// Tests whether a study's model is complete and, if not, which effects explain the residuals: fits
/// the model, applies score tests of each candidate and suspect measurement, refits the model with
/// the significant ones, and keeps the models that fit (`Conclusion::confidence_set`). If no model
/// fits, the effects that explain most of the misfit are sought (`find_leaders`).
///
/// A model fits if it passes two tests, each at half of `options.significance`: the test for lack
/// of fit, and the test of the most significant effect or suspect measurement that the model does
/// not contain. All p values come from one set of random draws of errors.
/// @throws InputError if the measured values are not more than the fitted parameters and constant
///         cohesions
Diagnosis diagnose(const ModelSpace& space, const Evidence& evidence,
                   const DiagnosisOptions& options = {});

/// Largest factor [1] at which `Diagnosis::holds_up_to` is tested: chosen, since what errs by 4 %
/// of the stress ratio or more is no model of the grains.
inline constexpr double most_inexact = 10;

/// Concludes anew from the tests of a diagnosis, with more that has a say in the verdict.
void conclude_anew(Diagnosis& diagnosis, const ModelSpace& space, const DiagnosisOptions& options,
                   const Circumstances& circumstances);

/// Diagnosis of a study, with the models and the discrepancy that led to it.
struct InexactDiagnosis {
    Diagnosis diagnosis;
    StudyModelSpace models;
    /// Relative standard errors [1] of stress ratio and solid fraction that the models are expected
    /// to have.
    std::array<double, 2> discrepancy;
    Fit as_expected;  ///< of the study's model, with the discrepancy that is expected
};

/// Diagnoses a study with the discrepancy that it expects and, if its model is rejected and the
/// likeliest explanation leaves more, again with that, since no model is exact: effects are judged
/// against the lack of fit that remains with the best explanation. The first diagnosis stands
/// where no model fits even so; the errors of its fits then allow for their `likely_inexactness`.
InexactDiagnosis diagnose_inexact(const StudyModelSpace& models,
                                  const std::array<double, 2>& discrepancy,
                                  const Evidence& evidence, const DiagnosisOptions& options);

}  // namespace pendular
