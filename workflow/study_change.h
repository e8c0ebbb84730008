#pragma once

#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "analysis/ladder.h"
#include "analysis/misfit/believable.h"
#include "sim/catalogue/resolved_study.h"
#include "workflow/fit_study.h"

namespace pendular {

enum class Action { add, drop };

/// A change of the effects that a study lists, which was checked but not made.
struct StudyChange {
    Action change = Action::add;
    std::string effect;
    ResolvedStudy study;   ///< study after the change
    std::string old_text;  ///< text of study.toml before the change
    std::string new_text;
};

/// Checks a change of the effects that a study lists.
/// @throws InputError where there is no such effect (with the nearest one), it does not apply to
///         the study, is listed already, or is not listed
StudyChange plan_change(const ResolvedStudy& study, Action change, const std::string& effect);

/// Calibration with its comparison to the readings.
struct Fitted {
    Calibration calibration;
    Comparison comparison;
    LadderStep ladder_step;
    Belief belief = {};        ///< judgement of the fit after a change
    std::size_t left_out = 0;  ///< number of conditions left out, one after the other
    std::size_t undetermined =
        0;  ///< number of conditions without which a parameter was not determined
};
/// Predicts all readings of a calibration, compares them and leaves out each condition in turn.
Fitted fitted(const ResolvedStudy& study, Calibration calibration);

/// JSON of a change with the errors before and after, as `add --json` and `drop --json` write it.
nlohmann::ordered_json to_json(const StudyChange& change, const LadderStep& before,
                               const LadderStep& after, bool written);

/// Writes fit.json and the ladder, with the change on top, to the folder, and then the study's
/// file.
/// @throws InputError where the study's file has changed since it was read; nothing is written
/// @throws std::runtime_error where something cannot be written; the study then is as it was
void apply_change(const StudyChange& change, const LadderStep& before, const Fitted& after,
                  Ladder& ladder, const std::filesystem::path& folder);

/// Study before and after a change.
struct ChangedStudy {
    StudyChange change;
    Fitted before, after;
    Ladder ladder;         ///< ladder of the study, with the change as its last step if it was made
    bool written = false;  ///< false: the fit after the change did not converge
};

/// Options of a change of effects.
struct ChangeOptions {
    FitOptions fit = {};           ///< options of the fit after the change
    bool same_fidelity = true;     ///< use the fidelity of the study's earlier fit
    std::filesystem::path folder;  ///< for results, with those of earlier commands
};

/// Fits a study as it is (or takes its earlier fit, where that can be compared with) and after the
/// change; then writes fit.json and ladder.json to the folder and, last, the study's file. Nothing
/// is written where the fit after the change does not converge.
/// @throws InputError for an effect that cannot be added or dropped, a ladder that cannot be read,
///         and where the study's file has changed since it was read
/// @throws std::runtime_error where something cannot be written; the study then is as it was
/// @throws dem::Interrupted with how to go on
ChangedStudy change_study(const ResolvedStudy& study, const Measurements& measurements,
                          Action change, const std::string& effect, SessionOptions session,
                          const ChangeOptions& options);

}  // namespace pendular
