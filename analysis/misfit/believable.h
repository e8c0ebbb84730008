#pragma once

#include <optional>
#include <string>
#include <vector>

#include "analysis/misfit/compare.h"
#include "analysis/misfit/unit_mistakes.h"
#include "calib/fit/fit.h"
#include "data/reading.h"

namespace pendular {

/// Judgement on whether the fit of a study's model can be believed.
struct Belief {
    /// Sentences for the user with the reasons not to believe the fit, the most serious first.
    std::vector<std::string> reasons;
    /// Whether the fitted values are meaningless: the model does not describe the readings and the
    /// friction coefficient is at the end of its range, or the import excluded more readings than
    /// it kept.
    bool meaningless = false;
    std::optional<std::size_t> misfit_reason = {};  ///< index in `reasons` of the sentence on chi2

    bool believable() const { return reasons.empty(); }
};

/// Smallest p value of chi2 [1] at which a model counts as describing the readings: the smallest
/// that is printed. The p value allows for errors that few replicates determine, so that 1 of 1000
/// fits of a right model is refused.
constexpr double incredible_p = 1e-3;

/// Returns the reasons not to believe a fit: a large misfit, parameters at the end of their range,
/// a column in a wrong unit, and doubts of the import about measured values.
/// @param parameters the first is the friction coefficient
Belief belief_in(const Fit& fit, const std::vector<Parameter>& parameters, const Misfit& misfit,
                 const Measurements& measurements, const std::optional<UnitMistake>& mistake);

/// Returns the number of doubts because of which the import excluded readings or data points.
std::size_t doubts_that_set_aside(const Measurements& measurements);

/// Returns a sentence on the source of the readings' standard errors, such as "The standard errors
/// of the readings are estimated from the scatter of 22 repeated readings."
std::string error_basis(const Measurements& measurements);

}  // namespace pendular
