#pragma once

#include <array>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "analysis/left_out.h"
#include "analysis/misfit/compare.h"

namespace pendular {

/// Fitted parameter of one model in a ladder (sequence of the fitted models of a study), with the
/// standard error of the fitted value.
struct LadderParameter {
    std::string name, unit;
    /// Fitted value of the parameter and standard error of this value, both in the unit `unit`.
    double value = 0, standard_error = 0;
    /// Width of the range within which the parameter was fitted, in the unit `unit`; infinity if it
    /// is unknown, as in a ladder that was read from its file.
    double width = std::numeric_limits<double>::infinity();
    bool at_bound = false;  ///< whether the value is at an end of the range
};

/// Step of a ladder (sequence of the fitted models of a study): one fitted model with its physical
/// effects, parameters and misfit. If the step adds or drops an effect, the model differs from the
/// model of the preceding step by this effect alone.
struct LadderStep {
    /// Number of the step in the ladder (sequence of the fitted models of a study), counted from 0.
    int step = 0;
    /// Change of the model since the preceding step: "add" if one effect was added, "drop" if one
    /// effect was dropped, "start" if the step is the first one or if the model changed in another
    /// way.
    std::string change = "start";
    /// Name of the effect that this step added or dropped. Empty if `change` is "start".
    std::string effect = {};
    /// Names of all effects that the model of this step contains.
    std::vector<std::string> effects;
    /// Alternatives to the effect that this step added: sets of effects that explained the readings
    /// equally well without this effect. Each set is a list of names of effects.
    std::vector<std::vector<std::string>> rivals = {};
    /// Fitted parameters of the model of this step. The first parameter is the friction
    /// coefficient.
    std::vector<LadderParameter> parameters;
    /// chi2 [1] of the model of this step, for all readings (fitted or only predicted) and all
    /// direct measurements of effects' parameters.
    double chi2 = 0;
    /// Degrees of freedom of `chi2`: number of measured values minus number of fitted parameters
    /// and fitted constant cohesions.
    int dof = 0;
    /// Relative RMS errors [%] of the predicted shear stress (first) and solid fraction (second)
    /// for all readings: 100 sqrt(mean((predicted/measured - 1)^2)), with the mean over the
    /// readings.
    std::array<double, 2> rms_percent{};
    /// Relative RMS errors [%] of the predicted shear stress (first) and solid fraction (second) in
    /// cross-validation: a fit to all other conditions predicts the readings at each condition
    /// (normal stress, inertial number and liquid content). Empty if no cross-validation was made.
    std::optional<std::array<double, 2>> left_out_percent;

    double chi2_per_dof() const { return chi2 / dof; }
    /// Returns the fitted parameter whose name is `name`. Null if the model has no parameter of
    /// that name.
    const LadderParameter* find(const std::string& name) const;
};

/// Ladder: sequence of the fitted models of a study, the oldest first. The model of a step whose
/// `change` is "add" or "drop" has one effect more or fewer than the model of the preceding step.
/// The first step has `change` "start". A later step has `change` "start" if the study's model was
/// changed in another way.
using Ladder = std::vector<LadderStep>;

/// Returns the step of a ladder (sequence of the fitted models of a study) that describes the model
/// of a finished calibration. `change` of the step is "start"; the caller may set it.
/// @param comparison comparison of the readings with the predictions of the calibration's model
/// @param left_out cross-validation errors of the calibration's model; empty if not computed
LadderStep ladder_step_of(const Calibration& calibration, const Comparison& comparison,
                          const std::optional<LeftOut>& left_out);

/// Appends the model `after` to a ladder (sequence of the fitted models of a study). `after`
/// differs from the model `before` by one effect. If the last step of the ladder is not the model
/// `before`, the function first appends `before` with `change` "start". The last step counts as
/// `before` if both models have equal effects and degrees of freedom, and if their chi2 differ by
/// at most 5 % of the larger chi2 plus the degrees of freedom. The tolerance allows for new
/// simulation runs, which change chi2 slightly. The function sets the number of each appended step
/// (`LadderStep::step`).
void add_step(Ladder& ladder, LadderStep before, LadderStep after);

/// Explanation of the reduction of chi2 by a further effect.
enum class Reduction {
    significant,   ///< the effect describes the readings better
    by_chance,     ///< chance explains the reduction
    beside_misfit  ///< the reduction is small compared with the misfit that remains
};

/// Judges the reduction of chi2 from the model `from` to the model `to` of a study, at 5 %
/// significance: first by a likelihood ratio test and then, if a misfit remains in `to` (5 %
/// significance), by an F test that takes the misfit as scatter of the readings. The number of
/// additional parameters counts as at least one, since an effect that is a switch (on or off) adds
/// no parameter.
/// Source: McCullagh and Nelder, Generalized Linear Models, 2nd ed. (1989), section 9.2.
Reduction reduction_of(const LadderStep& from, const LadderStep& to);

}  // namespace pendular
