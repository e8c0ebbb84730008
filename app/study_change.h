#pragma once

#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "analysis/believable.h"
#include "analysis/ladder.h"
#include "app/console.h"
#include "data/study.h"

namespace pendular::app {

enum class Action { add, drop };

/// A change of the effects that a study lists, which was checked but not made.
struct StudyChange {
    Action change = Action::add;
    std::string effect;
    Study study;           ///< as it will be
    std::string old_text;  ///< of its file
    std::string new_text;
};

/// @throws InputError where there is no such effect (with the nearest one), it does not apply to
/// the
///         study, is listed already, or is not listed
StudyChange plan_change(const Study& study, Action change, const std::string& effect);

/// A calibration beside its readings.
struct Fitted {
    Calibration calibration;
    Comparison comparison;
    Rung rung;
    Belief belief = {};            ///< judged by whoever knows the measurements
    std::size_t left_out = 0;      ///< conditions left out, one after the other
    std::size_t undetermined = 0;  ///< those without which a parameter was not determined
};
Fitted fitted(const Study& study, Calibration calibration);

/// The change in one line: the error before and after.
std::string verdict_of(const StudyChange& change, const Rung& before, const Rung& after);

/// Parameters before and after, with the drift of those that are in both.
std::vector<std::string> parameter_changes(const Rung& before, const Rung& after);

/// Whether the change served, where it did not, and what to do then; `study` as the user names it.
std::vector<std::string> advice_on(const StudyChange& change, const Rung& before, const Rung& after,
                                   const std::string& study);

/// What --json gives.
nlohmann::ordered_json to_json(const StudyChange& change, const Rung& before, const Rung& after,
                               bool written);

/// Writes fit.json and the ladder, with the change on top, to the folder, and then the study's
/// file.
/// @throws InputError where the study's file has changed since it was read; nothing is written
/// @throws std::runtime_error where something cannot be written; the study then is as it was
void carry_out(const StudyChange& change, const Rung& before, const Fitted& after, Ladder& ladder,
               const std::filesystem::path& out);

}  // namespace pendular::app
