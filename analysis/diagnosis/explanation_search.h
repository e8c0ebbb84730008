#pragma once

#include <vector>

#include "analysis/diagnosis/explanation.h"
#include "analysis/diagnosis/explanations.h"
#include "analysis/diagnosis/signature.h"

namespace pendular {

/// Score tests of a fitted model for every candidate (effect not in the model) and every suspect
/// measurement. The lists are in the order of the candidates or of the suspects.
struct Scanned {
    const Explanation& base;             ///< fit of the model without further effects
    const WeightedResiduals& residuals;  ///< residuals of `base`
    const std::vector<Addition>& additions;
    const std::vector<Signature>& signatures;
    const std::vector<Finding>& findings;
    const std::vector<ScoreTest>& suspect_tests;
};

/// Refitted models that may explain the residuals of a model.
struct Found {
    std::vector<Explanation> tried;  ///< all refitted models
    /// Models with further effects that fit: single effects or, where no single effect or suspect
    /// fits, pairs.
    std::vector<Explanation> fitting;
    /// Models with an error of a suspect measurement that fit.
    std::vector<Explanation> fitting_suspects;
};

/// Whether the score test of a candidate is significant enough (p < 0.05 of this test alone) to
/// refit the model with the candidate.
bool looks_missing(const Finding& finding);

/// Refits the model with each candidate that looks missing and with each significant suspect
/// measurement and, where none of these models fits, with pairs of candidates. Refits run in
/// parallel on up to `options.threads` threads. A candidate, suspect or pair is skipped where its
/// predicted reduction of chi2 is clearly below that of a model already rejected.
Found search_explanations(const ModelSpace& space, const Evidence& evidence,
                          const DiagnosisOptions& options, const Explanations& explanations,
                          const Scanned& scanned);

}  // namespace pendular
