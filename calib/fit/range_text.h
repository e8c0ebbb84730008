#pragma once

#include <optional>
#include <string>
#include <vector>

#include "calib/fit/fit.h"
#include "sim/dem/run.h"

namespace pendular {

/// Returns the range within which a parameter was fitted, such as "0 to 0.6 (0.6 is the end of the
/// simulations)", in the unit of the parameter.
std::string range_text(const Fit& fit, const std::vector<Parameter>& parameters, std::size_t k);

/// Returns a note that a fitted friction coefficient is implausible for beads, with the usual
/// causes; empty for a plausible one.
std::optional<std::string> implausible_friction(double friction);

/// Returns a note on the number of readings that are slower than all simulations, so that their
/// predictions are extrapolated in the inertial number; empty if there are none.
/// @param runs training runs of the emulator
std::optional<std::string> extrapolation_note(const std::vector<dem::RunResult>& runs,
                                              const std::vector<Reading>& readings);

}  // namespace pendular
