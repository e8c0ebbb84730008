#pragma once

#include <optional>
#include <string>
#include <vector>

#include "analysis/misfit/compare.h"
#include "analysis/misfit/unit_mistakes.h"
#include "calib/fit/fit.h"
#include "data/reading.h"

namespace pendular {

/// Judgement whether a fit can be believed, with the reasons against it.
struct Belief {
    /// Reasons against the fit as sentences, the most serious first. Empty: none.
    std::vector<std::string> reasons;
    /// Whether the numbers are meaningless: the friction is at the end of its range and the model
    /// does not describe the readings, or most readings had to be set aside.
    bool meaningless = false;
    /// Index of the reason that chi2 is too large; empty where the model describes the readings.
    std::optional<std::size_t> misfit_reason = {};

    bool believable() const { return reasons.empty(); }
};

/// Probability of chi2 below which a model does not describe the readings, however uncertain their
/// errors are [1].
constexpr double incredible_p = 1e-6;

/// Judges a fit of parameters by its misfit, by parameters at the end of their range, and by what
/// was doubted at import.
Belief belief_in(const Fit& fit, const std::vector<Parameter>& parameters, const Misfit& misfit,
                 const Measurements& measurements, const std::optional<UnitMistake>& mistake);

/// Number of doubts for which import set readings, or rows of recordings, aside.
std::size_t doubts_that_set_aside(const Measurements& measurements);

/// Basis of the readings' errors, as in "errors from 22 repeated readings"; for the first line of
/// an answer.
std::string error_basis(const Measurements& measurements);

}  // namespace pendular
