#pragma once

#include <optional>
#include <string>
#include <vector>

#include "analysis/misfit/compare.h"
#include "analysis/misfit/unit_mistakes.h"
#include "calib/fit/fit.h"
#include "data/reading.h"

namespace pendular {

/// Judgement whether the fit of a study can be believed, with the reasons against it.
struct Belief {
    /// Reasons against the fit as sentences, the most serious first; empty: no reason.
    std::vector<std::string> reasons;
    /// Whether the fitted numbers are meaningless: the friction is at the end of its range and the
    /// model does not describe the readings, or import set more readings aside than it kept.
    bool meaningless = false;
    /// Index into `reasons` of the reason that chi2 is too large; empty where the model describes
    /// the readings.
    std::optional<std::size_t> misfit_reason = {};

    /// Whether the fit can be believed: there is no reason against it.
    bool believable() const { return reasons.empty(); }
};

/// p value of chi2 [1] below which a fitted model is said not to describe the readings, however
/// uncertain their errors are.
constexpr double incredible_p = 1e-6;

/// Judges whether a fit can be believed: by its misfit, by parameters at the end of their range, by
/// a column in a wrong unit, and by the doubts that import raised about readings.
/// @param parameters definitions of the fitted parameters, friction first
Belief belief_in(const Fit& fit, const std::vector<Parameter>& parameters, const Misfit& misfit,
                 const Measurements& measurements, const std::optional<UnitMistake>& mistake);

/// Number of doubts (reasons not to believe a measurement) for which import excluded readings or
/// rows of recordings from the study.
std::size_t doubts_that_set_aside(const Measurements& measurements);

/// Text that states where the standard errors of the readings come from, as in "errors from 22
/// repeated readings".
std::string error_basis(const Measurements& measurements);

}  // namespace pendular
