#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "analysis/left_out.h"
#include "analysis/misfit/compare.h"

namespace pendular {

/// Fitted parameter of one model in a ladder (the sequence of a study's models): name, unit, value
/// and standard error.
struct LadderParameter {
    std::string name, unit;
    double value = 0, standard_error = 0;  ///< fitted value and its standard error [unit]
};

/// One step of a ladder (the sequence of a study's models): the model after one effect was added or
/// dropped, with its fitted parameters and its misfit.
struct LadderStep {
    /// Number of the step in the ladder, from 0.
    int step = 0;
    /// Kind of the step in the ladder: "start", "add" or "drop" of an effect.
    std::string change = "start";
    /// Name of the effect that was added or dropped in this step; empty for "start".
    std::string effect = {};
    /// Names of all effects of the model after this step.
    std::vector<std::string> effects;
    /// Alternatives to the added effect: sets of effects each of which explained the readings
    /// equally well, instead of the added effect, when that effect was added.
    std::vector<std::vector<std::string>> rivals = {};
    /// Fitted parameters of the model of this step, friction first.
    std::vector<LadderParameter> parameters;
    /// chi2 of the model of this step for all readings (fitted or only predicted) and direct
    /// measurements.
    double chi2 = 0;
    /// Degrees of freedom of `chi2`: measured values minus fitted values.
    int dof = 0;
    /// RMS errors of the predicted (shear stress, solid fraction) over all readings [%]: 100
    /// sqrt(mean((predicted/measured - 1)^2)).
    std::array<double, 2> rms_percent{};
    /// RMS errors of (shear stress, solid fraction) in cross-validation [%], where each fitted
    /// condition is predicted by a fit to the other conditions; empty if not computed.
    std::optional<std::array<double, 2>> left_out_percent;

    double chi2_per_dof() const { return chi2 / dof; }
    /// Returns the fitted parameter with this name; null if the model has no parameter of this
    /// name.
    const LadderParameter* find(const std::string& name) const;
};

/// Sequence of a study's models (ladder) in the order of time, each with one effect more or fewer
/// than the model before. The first step has `change` "start". A later step with "start" begins a
/// new sequence, since its model differs from the model before by more than one added or dropped
/// effect.
using Ladder = std::vector<LadderStep>;

/// Returns the ladder step that describes the model of a finished calibration, with `change`
/// "start".
/// @param comparison comparison of the calibration's model with the readings
/// @param left_out cross-validation errors of the calibration, if they were computed
LadderStep ladder_step_of(const Calibration& calibration, const Comparison& comparison,
                          const std::optional<LeftOut>& left_out);

/// Appends a step to a ladder (the sequence of a study's models): `after`, the model after an
/// effect was added or dropped. If the last step of the ladder does not describe `before`, the
/// model before this change, `before` is appended first, with `change` "start". The last step
/// describes `before` if effects and degrees of freedom are equal and chi2 differs by at most 5 %
/// of chi2 + dof, as new runs may cause. The appended steps are numbered.
void add_step(Ladder& ladder, LadderStep before, LadderStep after);

/// Whether chance can explain the reduction of chi2 from one ladder step (model of a study) to
/// another, by a likelihood ratio test at 5 % significance. The number of additional parameters
/// counts as at least one, since an effect that is a switch (on or off) has none.
bool fell_by_chance(const LadderStep& from, const LadderStep& to);

}  // namespace pendular
