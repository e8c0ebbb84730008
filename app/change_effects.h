#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "workflow/session.h"

namespace pendular::app {

/// Paths in the results folder to which a change of effects writes.
std::vector<std::filesystem::path> outputs_of_change();

/// Adds an effect to the study of a session or drops one, as `Session::add` and `Session::drop` do,
/// whose parameters and exceptions these are.
ChangedStudy change_effects(const Session& session, Action action, const std::string& effect,
                            const FitOptions& fit, bool same_fidelity);

/// Sentence on a change: the error before and after it, or why the study is unchanged.
std::string answer_on(const ChangedStudy& changed);

/// Draws the ladder (the sequence of the study's models) to a folder, and returns the figure's
/// name.
/// @throws std::runtime_error where gnuplot is missing or fails, and where a file cannot be written
std::string draw_ladder(const Ladder& ladder, const std::filesystem::path& folder);

}  // namespace pendular::app
