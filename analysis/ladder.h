#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "analysis/left_out.h"
#include "analysis/misfit/compare.h"

namespace pendular {

/// Fitted parameter of one model in a ladder (the sequence of a study's models), with its standard
/// error.
struct LadderParameter {
    std::string name, unit;
    /// Fitted value of the parameter, and standard error of the value [unit].
    double value = 0, standard_error = 0;
};

/// Step of a ladder (the sequence of a study's models): one fitted model with its effects,
/// parameters and misfit. In a step that adds or drops an effect, the model differs from the model
/// before by that effect alone.
struct LadderStep {
    /// Number of the step in the ladder (the sequence of a study's models), counted from 0.
    int step = 0;
    /// Kind of the step: "add" if the model has one effect more than the model before, "drop" if
    /// the model has one effect fewer, "start" if the model begins a new sequence.
    std::string change = "start";
    /// Name of the effect by which the model of this step differs from the model before. Empty if
    /// `change` is "start".
    std::string effect = {};
    /// Names of all effects that the model of this step contains.
    std::vector<std::string> effects;
    /// Alternatives to the effect that this step added: sets of effects, by name, that do not
    /// contain this effect but explained the readings equally well.
    std::vector<std::vector<std::string>> rivals = {};
    /// Fitted parameters of the model of this step. The first parameter is the friction
    /// coefficient.
    std::vector<LadderParameter> parameters;
    /// chi2 [1] of the model of this step, for all readings (fitted or only predicted) and all
    /// direct measurements of effects' parameters.
    double chi2 = 0;
    /// Degrees of freedom of `chi2`: number of measured values minus number of fitted values.
    int dof = 0;
    /// Relative RMS errors [%] of the predicted shear stress (first) and solid fraction (second)
    /// for all readings: 100 sqrt(mean((predicted/measured - 1)^2)).
    std::array<double, 2> rms_percent{};
    /// Relative RMS errors [%] of the predicted shear stress (first) and solid fraction (second) in
    /// cross-validation, which predicts the readings of each fitted condition by a fit to the other
    /// conditions. Empty if no cross-validation was made.
    std::optional<std::array<double, 2>> left_out_percent;

    double chi2_per_dof() const { return chi2 / dof; }
    /// Returns the fitted parameter whose name is `name`. Null if the model has no parameter of
    /// that name.
    const LadderParameter* find(const std::string& name) const;
};

/// Ladder: sequence of a study's fitted models in the order of time. A step whose `change` is "add"
/// or "drop" has one effect more or fewer than the step before. The first step has `change`
/// "start". A later step with "start" begins a new sequence, after the study's model changed in
/// another way.
using Ladder = std::vector<LadderStep>;

/// Returns the step of a ladder (the sequence of a study's models) that describes the model of a
/// finished calibration. The step has `change` "start".
/// @param comparison comparison of the readings with the predictions of the calibration's model
/// @param left_out cross-validation errors of the calibration's model, if they were computed
LadderStep ladder_step_of(const Calibration& calibration, const Comparison& comparison,
                          const std::optional<LeftOut>& left_out);

/// Appends the model `after` to a ladder (the sequence of a study's models), after an effect was
/// added to or dropped from the model `before`. If the last step of the ladder is not the model
/// `before`, the function first appends `before` with `change` "start". The last step counts as
/// `before` if both have the same effects and degrees of freedom, and if their chi2 differ by at
/// most 5 % of chi2 + dof. The tolerance allows for new simulation runs, which change chi2
/// slightly. The function sets the number of each appended step (`LadderStep::step`).
void add_step(Ladder& ladder, LadderStep before, LadderStep after);

/// Whether chance can explain the reduction of chi2 from the model `from` to the model `to` of a
/// study, by a likelihood ratio test at 5 % significance. The number of additional parameters
/// counts as at least one, since an effect that is a switch (on or off) adds no parameter.
bool fell_by_chance(const LadderStep& from, const LadderStep& to);

}  // namespace pendular
