#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "analysis/left_out.h"
#include "analysis/misfit/compare.h"

namespace pendular {

/// Fitted parameter of a ladder step, that is of the study's model after one change of its effects.
struct LadderParameter {
    std::string name, unit;
    double value = 0, standard_error = 0;
};

/// Ladder step: the error of a study's model after one change of its effects.
struct LadderStep {
    int step = 0;                      ///< number of the step, from 0
    std::string change = "start";      ///< "start", "add" or "drop"
    std::string effect = {};           ///< effect that was added or dropped
    std::vector<std::string> effects;  ///< all effects of the model
    std::vector<LadderParameter> parameters;
    double chi2 = 0;  ///< chi2 of all readings, fitted and predicted
    int dof = 0;
    std::array<double, 2> rms_percent{};  ///< RMS errors of shear stress and solid fraction [%]
    /// RMS errors at conditions left out of the fit [%], where there is more than one condition.
    std::optional<std::array<double, 2>> left_out_percent;

    double chi2_per_dof() const { return chi2 / dof; }
    const LadderParameter* find(const std::string& name) const;  ///< null: not fitted
};

/// History of a study: its steps in the order of time. A step "start" begins the ladder anew where
/// the study was changed by other means.
using Ladder = std::vector<LadderStep>;

/// Ladder step of a finished calibration, with change "start".
LadderStep ladder_step_of(const Calibration& calibration, const Comparison& comparison,
                          const std::optional<LeftOut>& left_out);

/// Appends the step after a change. A step "start" precedes it unless the last step describes the
/// study before the change: the same effects and as many degrees of freedom, chi2 up to what fresh
/// runs may change.
void climb(Ladder& ladder, LadderStep before, LadderStep after);

/// Whether the fall of chi2 between two steps is within chance for their numbers of parameters and
/// readings, at 5 %.
bool fell_by_chance(const LadderStep& from, const LadderStep& to);

}  // namespace pendular
