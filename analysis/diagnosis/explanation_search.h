#pragma once

#include <vector>

#include "analysis/diagnosis/explanation.h"
#include "analysis/diagnosis/explanations.h"
#include "analysis/diagnosis/signature.h"

namespace pendular {

/// Fitted model of a study with its score tests (tests without a refit) for every candidate (effect
/// not in the model) and every suspect measurement (part of the measurement that may be wrong). The
/// lists are in the order of the candidates or of the suspect measurements.
struct Scanned {
    /// The study's model without further effects, fitted to the readings and tested.
    const Explanation& base;
    /// Whitened residuals (in units of their errors) of the model `base`.
    const WeightedResiduals& residuals;
    /// For each candidate effect (not in the model), the predictions of `base` with this effect
    /// added.
    const std::vector<Addition>& additions;
    /// For each candidate effect (not in the model), how it changes the readings per unit of its
    /// amplitude.
    const std::vector<Signature>& signatures;
    const std::vector<Finding>& findings;         ///< result of each candidate's score test
    const std::vector<ScoreTest>& suspect_tests;  ///< score test of each suspect measurement
};

/// Refitted models that were tried to explain the residuals of a study's model.
struct Found {
    /// All models that were refitted to explain the residuals, whether they fit or not.
    std::vector<Explanation> tried;
    /// Models with further effects that fit the readings: one effect each or, if no single effect
    /// or suspect measurement suffices, pairs of effects.
    std::vector<Explanation> fitting;
    /// Models without further effects that fit the readings once an error of one suspect
    /// measurement is fitted too.
    std::vector<Explanation> fitting_suspects;
};

/// Whether the score test of a candidate effect (not in the model) is significant enough to refit
/// the model with the effect: the p value of this test alone is below 0.05.
bool looks_missing(const Finding& finding);

/// Refits a study's model with each candidate (effect not in the model) that looks missing, and
/// with each significant suspect measurement (part of the measurement that may be wrong). If none
/// of these models fits, refits it with pairs of candidates. Returns all refitted models and those
/// that fit. Refits run in parallel on up to `options.threads` threads. A model is not refitted if
/// its predicted reduction of chi2 is clearly below that of a model already rejected.
/// @param scanned the fitted model without further effects, with its score tests
Found search_explanations(const ModelSpace& space, const Evidence& evidence,
                          const DiagnosisOptions& options, const Explanations& explanations,
                          const Scanned& scanned);

}  // namespace pendular
