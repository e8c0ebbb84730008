#pragma once

#include <optional>
#include <string>
#include <vector>

#include "calib/fit/calibration.h"
#include "calib/fit/fit.h"
#include "calib/model/run_planner.h"
#include "sim/catalogue/resolved_study.h"
#include "sim/dem/run.h"

namespace pendular {

/// Returns sentences for the user that qualify the result of a calibration. The sentences report
/// - readings whose predictions the simulation runs do not support,
/// - simulation noise that exceeds the errors of the readings,
/// - time for simulations that ended before their noise was small enough,
/// - a large error of friction from corrections to the stiffness of grains and the quasi-static
///   limit,
/// - wet readings at reduced pressures so low that the grains may shear in bands, and
/// - parameters that are undetermined or at a bound.
///
/// They include RunPlanner::notes().
/// @param wet_known whether run noise in predicted wet readings is small compared with their errors
std::vector<std::string> notes_on(const Calibration& calibration, const ResolvedStudy& study,
                                  const RunPlanner& planner, bool wet_known);

/// Returns a sentence with advice for each combination of fitted parameters that the readings do
/// not determine. The combinations are the principal axes of the covariance of the parameters,
/// after each parameter is divided by the width of its range. A combination is undetermined if its
/// standard error in these units exceeds 1: of one parameter, where `Fit::determines` is false.
std::vector<std::string> undetermined(const Fit& fit, const std::vector<Parameter>& parameters);

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
