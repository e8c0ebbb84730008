#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "workflow/session.h"

namespace pendular::app {

/// Returns the names of files and folders that `pendular add` and `pendular drop` write to the
/// results folder.
std::vector<std::filesystem::path> outputs_of_change();

/// Calls `Session::add`, with the rivals of the effect in diagnosis.json of the results folder, or
/// `Session::drop`, and passes on their exceptions.
ChangedStudy change_effects(Session& session, Action action, const std::string& effect,
                            const FitOptions& fit, bool same_fidelity);

/// Returns a sentence on the result of a change: chi2 per degree of freedom and the relative RMS
/// error of shear stress before and after it or, if the fit did not converge, that the study is
/// unchanged.
std::string answer_on(const ChangedStudy& changed);

/// Draws the figure of a ladder to a folder, and returns the name of the figure.
/// @throws std::runtime_error if gnuplot is missing or fails, or if a file cannot be written
std::string draw_ladder(const Ladder& ladder, const std::filesystem::path& folder);

}  // namespace pendular::app
