#pragma once

#include <optional>
#include <string>
#include <vector>

#include "analysis/misfit/compare.h"
#include "analysis/misfit/unit_mistakes.h"
#include "calib/fit/fit.h"
#include "data/reading.h"

namespace pendular {

/// Judgement on whether the fit of a study's model to the readings can be believed, with the
/// reasons not to believe the fit.
struct Belief {
    /// Sentences for the user with the reasons not to believe the fit, the most serious first.
    /// Empty if there is no such reason.
    std::vector<std::string> reasons;
    /// Whether the fitted parameter values are meaningless. The values are meaningless if the model
    /// does not describe the readings and the friction coefficient is at the end of its range, or
    /// if the import of the recordings excluded more readings than it kept.
    bool meaningless = false;
    /// Index in `reasons` of the sentence which says that chi2 is too large. Empty if the model
    /// describes the readings.
    std::optional<std::size_t> misfit_reason = {};

    /// Whether the fit can be believed: `reasons` is empty.
    bool believable() const { return reasons.empty(); }
};

/// Smallest p value of chi2 [1] at which a model counts as describing the readings. Below this
/// value, the model fails to describe the readings, even if the errors of the readings are
/// uncertain.
constexpr double incredible_p = 1e-6;

/// Judges whether a fit can be believed, and returns the reasons not to believe the fit. Possible
/// reasons are a large misfit, parameters at the end of their range, a column of a recording in a
/// wrong unit, and doubts about measured values that the import of the recordings found.
/// @param parameters definitions of the fitted parameters; the first is the friction coefficient
/// @param misfit chi2 of the fit with the degrees of freedom
/// @param mistake column of a recording that was probably read in a wrong unit; empty: none was
///        found
Belief belief_in(const Fit& fit, const std::vector<Parameter>& parameters, const Misfit& misfit,
                 const Measurements& measurements, const std::optional<UnitMistake>& mistake);

/// Returns the number of doubts (reasons not to believe measured values) because of which the
/// import of recordings excluded readings or data points.
std::size_t doubts_that_set_aside(const Measurements& measurements);

/// Returns a sentence that states the source of the readings' standard errors, such as "The
/// standard errors of the readings are estimated from the scatter of 22 repeated readings."
std::string error_basis(const Measurements& measurements);

}  // namespace pendular
