#pragma once

#include <string>

#include "calib/fit/calibrate_study.h"
#include "reports/output.h"

namespace pendular {

/// Adds lines on the largest parts of the error of the first parameter that all readings share, on
/// those of what study.toml does not state, and on what to do about walls of unknown friction.
void add_shared_errors(Output& output, const Calibration& c);

/// Returns the error of the first parameter by what study.toml does not state, as an addition to
/// its text: " +- 0.014 (systematic: ...)"; empty without one. The part of walls of unknown
/// friction is named.
std::string systematic_text(const Calibration& c);

}  // namespace pendular
