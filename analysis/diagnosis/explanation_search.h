#pragma once

#include <vector>

#include "analysis/diagnosis/explanation.h"
#include "analysis/diagnosis/explanations.h"
#include "analysis/diagnosis/signature.h"

namespace pendular {

/// Results of the scan of a fitted model, by candidate.
struct Scanned {
    const Explanation& base;
    const WeightedResiduals& residuals;
    const std::vector<Addition>& additions;
    const std::vector<Signature>& signatures;
    const std::vector<Finding>& findings;
    const std::vector<ScoreTest>& suspect_tests;
};

/// Refitted models that may explain the residuals of a model.
struct Found {
    std::vector<Explanation> tried;  ///< all
    std::vector<Explanation>
        fitting;  ///< models with candidates that fit; pairs where no single candidate fits
    std::vector<Explanation>
        fitting_suspects;  ///< models with an error of the measurement that fit
};

/// Whether a candidate, by its test alone, is worth refitting.
bool looks_missing(const Finding& finding);

/// Refits single candidates that look missing and suspects of the measurement, and, where none of
/// them fits, pairs; side by side where there are further instances of the space. What cannot do
/// better than what was refused is not refitted.
Found search_explanations(const ModelSpace& space, const Evidence& evidence,
                          const DiagnosisOptions& options, const Explanations& explanations,
                          const Scanned& scanned);

}  // namespace pendular
