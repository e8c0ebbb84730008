#pragma once

#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "analysis/ladder.h"
#include "analysis/misfit/believable.h"
#include "sim/catalogue/resolved_study.h"
#include "workflow/fit_study.h"

namespace pendular {

/// Change of the effects that a study lists: one effect is added or dropped.
enum class Action { add, drop };

/// Change of the effects that a study lists, checked but not yet written to study.toml.
struct StudyChange {
    Action change = Action::add;
    std::string effect;    ///< name of the effect to add or drop
    ResolvedStudy study;   ///< study after the change
    std::string old_text;  ///< text of study.toml before the change
    std::string new_text;  ///< text of study.toml after the change
};

/// Checks a change of the effects that a study lists, and prepares the changed study. Nothing is
/// written. The effect to add may be one that the study's catalogue lacks but that is among
/// `proposed`; its table [[effect]] is then added to study.toml too.
/// @throws InputError where an effect to add is unknown (naming the nearest known effect), does not
///         apply to the study or is listed already, and where an effect to drop is not listed
StudyChange plan_change(const ResolvedStudy& study, Action change, const std::string& effect,
                        const std::vector<WrittenEffect>& proposed = {});

/// Calibration of a study before or after an effect was added or dropped, compared with the
/// readings.
struct Fitted {
    Calibration calibration;
    Comparison comparison;
    /// Summary of the fit, for the ladder (sequence of the study's models).
    LadderStep ladder_step;
    /// Judgement whether the fit can be believed; empty for a fit before the change.
    Belief belief = {};
    /// Number of conditions in the cross-validation, each predicted by a fit to the other
    /// conditions; 0: there are too few conditions for a cross-validation.
    std::size_t left_out = 0;
    /// Number of conditions that the cross-validation cannot predict: the readings at the other
    /// conditions alone do not determine every parameter of the model.
    std::size_t undetermined = 0;
};
/// Compares a calibration with all readings of the study, and computes its cross-validation errors:
/// the errors of each condition when it is predicted by a fit to the other conditions.
/// @param cross_validated whether to compute the cross-validation errors, which takes a refit for
///        each condition
Fitted fitted(const ResolvedStudy& study, Calibration calibration, bool cross_validated = true);

/// JSON of a change of the effects that a study lists, as `pendular add --json` and `pendular drop
/// --json` write it: the effect, and the model's parameters and errors before and after.
/// @param written whether study.toml was changed
nlohmann::ordered_json to_json(const StudyChange& change, const LadderStep& before,
                               const LadderStep& after, bool written);

/// Makes a fitted change of effects permanent: appends the model after it to the ladder (the
/// sequence of the study's models), writes fit.json and ladder.json to `folder`, and last writes
/// study.toml.
/// @param before, after the models before and after the change, fitted to the same readings
/// @param fit the fit of the changed study, for fit.json
/// @throws InputError where study.toml has changed since it was read; nothing is written
/// @throws std::runtime_error where a file cannot be written; study.toml is then unchanged
void apply_change(const StudyChange& change, const LadderStep& before, LadderStep after,
                  const Fitted& fit, Ladder& ladder, const std::filesystem::path& folder);

/// Result of adding or dropping an effect of a study: the fits before and after the change.
struct ChangedStudy {
    StudyChange change;
    /// Fit of the study before the change. If the parameters were fitted to the dry readings only
    /// but are fitted to all readings after the change, `before` is a fit to all readings too.
    Fitted before;
    Fitted after;  ///< fit of the study after the change, as in fit.json
    /// Fit of the changed study to all readings, for comparison with `before`, which is a fit to
    /// all readings. Empty unless `after` is a fit to the dry readings only.
    std::optional<Fitted> after_to_all;
    /// Ladder: sequence of the study's models. The last one is the changed model if `written` is
    /// true.
    Ladder ladder;
    /// Whether the change was written to study.toml; false where the fit after the change did not
    /// converge.
    bool written = false;

    /// Returns the fit of the study after the change that uses the same readings as `before`.
    const Fitted& comparable_after() const { return after_to_all ? *after_to_all : after; }
};

/// Options for fitting a study before and after a change of its effects.
struct ChangeOptions {
    /// Options of the fits before and after the change.
    FitOptions fit = {};
    /// Whether to use the fidelity (set of simulation settings) of the fit in `folder`, if there is
    /// one.
    bool same_fidelity = true;
    /// Folder for results, which also contains the results of earlier commands.
    std::filesystem::path folder;
};

/// Adds an effect to a study or drops one, and fits the study before and after the change. The fit
/// before is read from the results folder if that fit was made with comparable settings; otherwise
/// the study is fitted again. Then fit.json and ladder.json are written to the folder and, last,
/// study.toml. Nothing is written where the fit after the change does not converge.
/// @param effect name of the effect; to add, also one that proposed.toml of the results folder
///        defines
/// @throws InputError where the effect cannot be added or dropped, where ladder.json cannot be
///         read, where a fit is impossible, and where study.toml has changed since it was read
/// @throws std::runtime_error where a file cannot be written; study.toml is then unchanged
/// @throws dem::Interrupted where the user requests a stop; the message says how to continue
ChangedStudy change_study(const ResolvedStudy& study, const Measurements& measurements,
                          Action change, const std::string& effect, SessionOptions session,
                          const ChangeOptions& options);

}  // namespace pendular
