#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "analysis/left_out.h"
#include "analysis/misfit/compare.h"

namespace pendular {

/// Fitted parameter of the model of one ladder step.
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
    std::vector<LadderParameter> parameters;
    double chi2 = 0;  ///< chi2 of all readings, fitted and predicted, and of direct measurements
    int dof = 0;      ///< degrees of freedom of `chi2`
    std::array<double, 2> rms_percent{};  ///< RMS errors of (shear stress, solid fraction) [%]
    /// Cross-validation: RMS errors of (shear stress, solid fraction) [%], each condition predicted
    /// by a fit to the other conditions; empty where fewer than two conditions are fitted.
    std::optional<std::array<double, 2>> left_out_percent;

    double chi2_per_dof() const { return chi2 / dof; }
    /// Fitted parameter with this name; null where no fitted parameter has the name.
    const LadderParameter* find(const std::string& name) const;
};

/// Sequence of a study's models in the order of time, each with one effect more or fewer than the
/// model before. A step "start" begins a new sequence where study.toml was changed by hand.
using Ladder = std::vector<LadderStep>;

/// Ladder step that describes the model of a finished calibration, with `change` "start".
/// `left_out`: errors at conditions left out of the fit, if they were computed.
LadderStep ladder_step_of(const Calibration& calibration, const Comparison& comparison,
                          const std::optional<LeftOut>& left_out);

/// Appends step `after` a change of effects to a ladder. Where the last step of the ladder does not
/// describe the model before the change, `before` is appended first, as a step "start". The last
/// step describes that model if effects and degrees of freedom are equal and chi2 differs by no
/// more than new runs may cause, 5 % of chi2 + dof.
void climb(Ladder& ladder, LadderStep before, LadderStep after);

/// Whether chance can explain the reduction of chi2 from one ladder step to another: a likelihood
/// ratio test at 5 % significance, with at least one additional parameter.
bool fell_by_chance(const LadderStep& from, const LadderStep& to);

}  // namespace pendular
