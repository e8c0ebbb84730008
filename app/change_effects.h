#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "workflow/session.h"

namespace pendular::app {

/// Returns the names of the files and folders that `pendular add` and `pendular drop` write into
/// the results folder: fit.json, fit_runs.csv, ladder.json and figures.
std::vector<std::filesystem::path> outputs_of_change();

/// Adds an effect to the model of a session's study or drops an effect, and fits the model before
/// and after the change. The function passes on the exceptions of `Session::add` and
/// `Session::drop`, which it calls.
/// @param same_fidelity whether to use the simulation settings of the fit in the results folder, if
///        there is a fit
ChangedStudy change_effects(const Session& session, Action action, const std::string& effect,
                            const FitOptions& fit, bool same_fidelity);

/// Returns a sentence on the result of adding an effect to a study's model or dropping an effect.
/// The sentence states chi2 per degree of freedom and the relative RMS error of shear stress before
/// and after the change. If the fit did not converge, the sentence says that the study is
/// unchanged.
std::string answer_on(const ChangedStudy& changed);

/// Draws the figure of a ladder (the sequence of a study's models) to a folder, and returns the
/// name of the figure.
/// @throws std::runtime_error if gnuplot is missing or fails, or if a file cannot be written
std::string draw_ladder(const Ladder& ladder, const std::filesystem::path& folder);

}  // namespace pendular::app
