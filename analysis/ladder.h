#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "analysis/left_out.h"
#include "analysis/misfit/compare.h"

namespace pendular {

/// Fitted parameter of one model in a ladder (the sequence of a study's models).
struct LadderParameter {
    std::string name, unit;
    double value = 0, standard_error = 0;  ///< [unit]
};

/// One step of a ladder, the sequence of a study's models: the model after one effect was added or
/// dropped, with its fitted parameters and errors.
struct LadderStep {
    int step = 0;                      ///< number of the step, from 0
    std::string change = "start";      ///< "start", "add" or "drop"
    std::string effect = {};           ///< effect that was added or dropped; empty at a "start"
    std::vector<std::string> effects;  ///< all effects of the model
    /// Alternatives to the added effect: sets of effects each of which, in its place, explained the
    /// readings as well when it was added.
    std::vector<std::vector<std::string>> rivals = {};
    std::vector<LadderParameter> parameters;
    double chi2 = 0;  ///< chi2 of all readings (fitted, or only predicted) and direct measurements
    int dof = 0;      ///< degrees of freedom of `chi2`
    /// RMS of predicted/measured - 1 over all readings, for (shear stress, solid fraction) [%].
    std::array<double, 2> rms_percent{};
    /// Cross-validation: RMS of predicted/measured - 1 for (shear stress, solid fraction) [%], each
    /// fitted condition predicted by a fit to the other conditions; empty if not computed and where
    /// fewer than two conditions are fitted.
    std::optional<std::array<double, 2>> left_out_percent;

    double chi2_per_dof() const { return chi2 / dof; }
    /// Fitted parameter of the model with this name; null where no fitted parameter has the name.
    const LadderParameter* find(const std::string& name) const;
};

/// Sequence of a study's models in the order of time, each with one effect more or fewer than the
/// model before. The first step is a "start"; a further "start" begins a new sequence where a model
/// differs from the one before by more than the commands `add` and `drop` changed.
using Ladder = std::vector<LadderStep>;

/// Ladder step that describes the model of a finished calibration, with `change` "start".
/// `left_out`: cross-validation errors of the calibration, if they were computed.
LadderStep ladder_step_of(const Calibration& calibration, const Comparison& comparison,
                          const std::optional<LeftOut>& left_out);

/// Appends `after`, the step that describes the model after an effect was added or dropped, to a
/// ladder, and numbers it. Where the last step of the ladder does not describe the model before the
/// change, `before` is appended first, as a step "start". The last step describes that model if
/// effects and degrees of freedom are equal and chi2 differs by at most 5 % of chi2 + dof, as new
/// runs may cause.
void climb(Ladder& ladder, LadderStep before, LadderStep after);

/// Whether chance can explain the reduction of chi2 from one ladder step to another: a likelihood
/// ratio test at 5 % significance, with at least one additional parameter.
bool fell_by_chance(const LadderStep& from, const LadderStep& to);

}  // namespace pendular
