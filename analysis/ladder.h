#pragma once

#include <array>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "analysis/left_out.h"
#include "analysis/misfit/compare.h"

namespace pendular {

/// Fitted parameter of one model in a ladder.
struct LadderParameter {
    std::string name, unit;
    double value = 0, standard_error = 0;  ///< [unit]
    /// Width of the range of the fit [unit]; infinity if unknown, as in a ladder read from its
    /// file.
    double width = std::numeric_limits<double>::infinity();
    bool at_bound = false;  ///< whether the value is at an end of the range
};

/// Sets of effects, by name, such as those that each explain the readings of a study.
using EffectNames = std::vector<std::vector<std::string>>;

/// One fitted model of a study. If the step adds or drops an effect, the model differs from that of
/// the preceding step by this effect alone.
struct LadderStep {
    int step = 0;  ///< counted from 0
    /// "add" or "drop" of one effect since the preceding step; "start" for the first step and for
    /// any other change of the model.
    std::string change = "start";
    std::string effect = {};           ///< the one added or dropped; empty at a "start"
    std::vector<std::string> effects;  ///< all effects of the model
    /// Sets of effects that explained the readings equally well without the added effect.
    EffectNames rivals = {};
    std::vector<LadderParameter> parameters;  ///< the first is the friction coefficient
    /// chi2 [1] of all readings, fitted or only predicted, and all direct measurements.
    double chi2 = 0;
    int dof = 0;  ///< measured values minus fitted parameters and constant cohesions
    /// Relative RMS errors [%] of shear stress and solid fraction over all readings:
    /// 100 sqrt(mean((predicted/measured - 1)^2)).
    std::array<double, 2> rms_percent{};
    /// Errors [%] in cross-validation (`LeftOut`); empty if none was made.
    std::optional<std::array<double, 2>> left_out_percent;
    /// When the model became the study's, in local time, such as "2026-03-01 14:05"; empty:
    /// unknown.
    std::string when = {};

    double chi2_per_dof() const { return chi2 / dof; }
    /// Returns the parameter of that name; null if there is none.
    const LadderParameter* find(const std::string& name) const;
};

/// Fitted models of a study, the oldest first.
using Ladder = std::vector<LadderStep>;

/// Returns the ladder step of a finished calibration, with `change` "start", which the caller may
/// set.
/// @param left_out cross-validation errors; empty if not computed
LadderStep ladder_step_of(const Calibration& calibration, const Comparison& comparison,
                          const std::optional<LeftOut>& left_out);

/// Appends the model `after`, which differs from the model `before` by one effect, and numbers it.
/// If the last step of the ladder is not `before`, `before` is appended first, with `change`
/// "start". The last step is `before` if effects and degrees of freedom are equal and
///     |chi2_1 - chi2_2| <= 0.05 (max(chi2_1, chi2_2) + dof),
/// which allows for new simulation runs, which change chi2 slightly.
void add_step(Ladder& ladder, LadderStep before, LadderStep after);

enum class Reduction {
    significant,   ///< the effect describes the readings better
    by_chance,     ///< chance explains the reduction
    beside_misfit  ///< the reduction is small compared with the misfit that remains
};

/// Judges the reduction of chi2 from the model `from` to the model `to`, at 5 % significance: first
/// by a likelihood ratio test and then, if a misfit remains in `to`, by an F test that takes the
/// misfit as scatter of the readings. A switch adds no parameter, but counts as one.
/// Source: McCullagh and Nelder, Generalized Linear Models, 2nd ed. (1989), section 9.2.
Reduction reduction_of(const LadderStep& from, const LadderStep& to);

}  // namespace pendular
