#pragma once

#include <vector>

#include "analysis/diagnosis/evidence.h"
#include "analysis/diagnosis/explanations.h"
#include "analysis/diagnosis/signature.h"

namespace pendular {

/// Study's model with the score tests of every candidate and suspect measurement, in their order.
struct Scanned {
    const FittedModel& base;  ///< fitted and tested, without further effects
    const WeightedResiduals& residuals;
    const std::vector<Addition>& additions;       ///< `base` with each candidate
    const std::vector<Signature>& signatures;     ///< change of the readings by each candidate
    const std::vector<Finding>& findings;         ///< of each candidate
    const std::vector<ScoreTest>& suspect_tests;  ///< of each suspect measurement
};

/// Models that were refitted to explain the residuals.
struct Found {
    std::vector<FittedModel> tried;  ///< all of them, whether they fit or not
    /// Models that fit: with one further effect, and with two if these are clearly better (Akaike's
    /// criterion) or if no model with one fits.
    std::vector<FittedModel> fitting;
    std::vector<FittedModel> fitting_suspects;  ///< models that fit with an error of measurement
};

/// Whether the score test of a candidate is significant enough for a refit: p < 0.05, not corrected
/// for the number of tests.
bool looks_missing(const Finding& finding);

/// Searches for models that explain the readings. The study's model is refitted with each
/// significant candidate, with an error of each significant suspect measurement, and then with
/// pairs of candidates, if no model fits or if a pair promises to fit clearly better. A model is
/// not refitted if its predicted reduction of chi2 is clearly smaller than that by a model that was
/// refitted and rejected.
///
/// A model fits if FittedModel::p() is at least DiagnosisOptions::significance. Models with one
/// effect and a p value of at least DiagnosisOptions::least_p are accepted too: beside a model with
/// one effect that fits, where only the lack of fit counts, if the difference of the criterion does
/// not rule them out (`ruled_out`); elsewhere, unless a model with a suspect measurement explains
/// the readings better or a pair of effects clearly better.
Found search_explanations(const ModelSpace& space, const Evidence& evidence,
                          const DiagnosisOptions& options, const Explanations& explanations,
                          const Scanned& scanned);

}  // namespace pendular
