#pragma once

#include <array>

#include "analysis/diagnosis/diagnosis.h"
#include "calib/model/study_model_space.h"

// Effects are judged against the lack of fit that remains with the best explanation, since no model
// is exact.
namespace pendular {

/// Returns the factor [1] on the expected discrepancy of the model with which the likeliest of all
/// explanations describes the readings: the study's model, or one that was refitted with an effect,
/// a pair or an error of measurement. Explanations are compared by
///     chi2 + ln det Sigma + ((ln factor)/(ln 2))^2 + 2 k (1 + ln m)
/// at their likeliest factor (`likely_inexactness`), with k effects among m candidates, or else
/// with the k columns of one of m suspect measurements (2 k + 2 ln m). An effect thus has to
/// explain more than the differences between conditions that an inexact model leaves, and a pair
/// more than an effect with such differences. Source: Foster and George, Ann. Stat. 22 (1994) 1947,
/// for the price of the search.
double inexactness_left(const Diagnosis& diagnosis, const Evidence& evidence);

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
/// best explanation leaves more (`inexactness_left`), again with that. The first diagnosis stands
/// where no model fits even so; the errors of its fits then allow for their `likely_inexactness`.
InexactDiagnosis diagnose_inexact(const StudyModelSpace& models,
                                  const std::array<double, 2>& discrepancy,
                                  const Evidence& evidence, const DiagnosisOptions& options);

}  // namespace pendular
