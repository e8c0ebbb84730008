#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "analysis/left_out.h"
#include "analysis/misfit/compare.h"

namespace pendular {

/// A fitted parameter as a rung keeps it.
struct LadderParameter {
    std::string name, unit;
    double value = 0, standard_error = 0;
};

/// The error of a study's model after one change of its effects.
struct LadderStep {
    int step = 0;                      ///< from 0 on
    std::string change = "start";      ///< "start", "add" or "drop"
    std::string effect = {};           ///< that was added or dropped
    std::vector<std::string> effects;  ///< all that are on
    std::vector<LadderParameter> parameters;
    double chi2 = 0;  ///< of all readings, those only predicted included
    int dof = 0;
    std::array<double, 2> rms_percent{};  ///< of shear stress and solid fraction
    /// RMS errors at conditions left out of the fit [%], where there is more than one condition.
    std::optional<std::array<double, 2>> left_out_percent;

    double chi2_per_dof() const { return chi2 / dof; }
    const LadderParameter* find(const std::string& name) const;  ///< null: not fitted
};

/// History of a study: its steps in the order of time. A step "start" begins the ladder anew where
/// the study was changed by other means.
using Ladder = std::vector<LadderStep>;

/// The rung of a finished calibration, a start.
LadderStep ladder_step_of(const Calibration& calibration, const Comparison& comparison,
             const std::optional<LeftOut>& left_out);

/// Appends what a change led to; before it a fresh start, unless the last rung is of the study
/// before the change: the same effects and as many degrees of freedom, chi2 up to what fresh runs
/// may change.
void climb(Ladder& ladder, LadderStep before, LadderStep after);

/// Whether chi2 fell from one rung to another by no more than chance makes of as many parameters
/// and readings with the errors they have, at 5 %.
bool fell_by_chance(const LadderStep& from, const LadderStep& to);

}  // namespace pendular
