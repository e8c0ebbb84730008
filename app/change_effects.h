#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "workflow/session.h"

namespace pendular::app {

/// Paths in the results folder to which a change of effects writes.
std::vector<std::filesystem::path> outputs_of_change();

/// Adds an effect to the study of a session or drops one, and fits the study before and after.
/// @param effect name of the effect
/// @param fit options of the fits
/// @param same_fidelity whether to use the fidelity (simulation settings) of the fit in the results
///        folder
/// @throws what `Session::add` and `Session::drop` throw
ChangedStudy change_effects(const Session& session, Action action, const std::string& effect,
                            const FitOptions& fit, bool same_fidelity);

/// Sentence on a change: the error before and after it, or why the study is unchanged.
std::string answer_on(const ChangedStudy& changed);

/// Draws the ladder (the sequence of the study's models) to a folder, and returns the figure's
/// name.
/// @throws std::runtime_error where gnuplot is missing or fails, and where a file cannot be written
std::string draw_ladder(const Ladder& ladder, const std::filesystem::path& folder);

}  // namespace pendular::app
