#pragma once

#include <vector>

#include "analysis/diagnosis/explanation.h"
#include "analysis/diagnosis/explanations.h"
#include "analysis/diagnosis/signature.h"

namespace pendular {

/// Fitted model of a study, with the score tests (tests without a refit) of every candidate effect
/// (not in the model) and every suspect measurement (part of the measurement that may be wrong).
/// Each list is in the order of the candidate effects or of the suspect measurements.
struct Scanned {
    /// The study's model without further effects, fitted to the readings and tested.
    const Explanation& base;
    /// Whitened residuals (in units of their errors) of the readings from the model `base`.
    const WeightedResiduals& residuals;
    /// Predictions of `base` with one effect added, as a function of the effect's amplitude, for
    /// each candidate effect (not in the model).
    const std::vector<Addition>& additions;
    /// Change of the readings by the effect per unit of the effect's amplitude, for each candidate
    /// effect (not in the model).
    const std::vector<Signature>& signatures;
    const std::vector<Finding>& findings;  ///< result of the score test of each candidate effect
    const std::vector<ScoreTest>& suspect_tests;  ///< score test of each suspect measurement
};

/// Models that a diagnosis refitted in order to explain the residuals of a study's model.
struct Found {
    /// All models that the search refitted, whether they fit the readings or not.
    std::vector<Explanation> tried;
    /// Refitted models that fit the readings: models with one further effect, and models with two
    /// further effects if these are clearly better than the models with one (Akaike's criterion) or
    /// if no model with one further effect fits.
    std::vector<Explanation> fitting;
    /// Refitted models without further effects that fit the readings once an error of one suspect
    /// measurement (part of the measurement that may be wrong) is fitted too.
    std::vector<Explanation> fitting_suspects;
};

/// Whether the score test (test without a refit) of a candidate effect is significant enough for a
/// refit of the model with the effect: the p value, not corrected for the number of tests, is below
/// 0.05.
bool looks_missing(const Finding& finding);

/// Searches for models that explain the readings, and returns all refitted models and the models
/// that fit. The search refits a study's model with each candidate effect (not in the model) whose
/// score test (test without a refit) is significant, and with an error of each significant suspect
/// measurement (part of the measurement that may be wrong). Then the search refits pairs of
/// candidate effects if no refitted model fits the readings, or if a pair promises to fit clearly
/// better. A model is not refitted if its predicted reduction of chi2 is clearly smaller than the
/// reduction by a model that was refitted and rejected.
///
/// A model fits if Explanation::p() is at least DiagnosisOptions::significance. If no model with
/// one effect fits, models with one effect and p() of at least DiagnosisOptions::least_p are
/// accepted too, unless a model with a suspect measurement explains the readings better or a pair
/// of effects clearly better.
/// @param scanned fitted model without further effects, with its score tests
Found search_explanations(const ModelSpace& space, const Evidence& evidence,
                          const DiagnosisOptions& options, const Explanations& explanations,
                          const Scanned& scanned);

}  // namespace pendular
