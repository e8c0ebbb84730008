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

/// Kind of change of the effects that a study lists: one effect is added or dropped.
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
/// written.
/// @param proposed effects that can be added although the study's catalogue (list of known effects)
///        lacks them; the new text of study.toml then contains the table [[effect]] that defines
///        the added effect
/// @throws InputError if an effect to add is unknown (the message names the nearest known effect),
///         does not apply to the study or is listed already, or if an effect to drop is not listed
StudyChange plan_change(const ResolvedStudy& study, Action change, const std::string& effect,
                        const std::vector<WrittenEffect>& proposed = {});

/// Calibration of a study before or after an effect was added or dropped, with the comparison of
/// the readings with the predictions.
struct Fitted {
    Calibration calibration;
    Comparison comparison;
    /// Summary of the fit, as a step of the ladder (the sequence of the study's models).
    LadderStep ladder_step;
    /// Judgement whether the fit can be believed. Only the fit after the change is judged. For the
    /// fit before the change, the judgement is empty.
    Belief belief = {};
    /// Number of conditions (normal stress, inertial number and liquid content) in the
    /// cross-validation, each predicted by a fit to the other conditions. 0 if no cross-validation
    /// was made.
    std::size_t left_out = 0;
    /// Number of conditions that the cross-validation cannot predict reliably: the readings of the
    /// other conditions do not determine every parameter of the model, or the fit to these readings
    /// does not converge (`LeftOut::undetermined`). The prediction of such a condition depends on
    /// the starting values of the fit.
    std::size_t undetermined = 0;
};
/// Compares all readings of a study with the predictions of a calibration, and computes the
/// cross-validation errors: the errors of the predictions of each condition by a fit to the other
/// conditions.
/// @param cross_validated whether to compute the cross-validation errors, which takes a refit for
///        each condition
Fitted fitted(const ResolvedStudy& study, Calibration calibration, bool cross_validated = true);

/// Returns the JSON of a change of the effects that a study lists, as `pendular add --json` and
/// `pendular drop --json` write it: the effect, the alternatives to an added effect (other sets of
/// effects that explain the readings equally well), and the parameters and errors of the model
/// before and after the change.
/// @param written whether study.toml was changed
nlohmann::ordered_json to_json(const StudyChange& change, const LadderStep& before,
                               const LadderStep& after, bool written);

/// Makes a fitted change of effects permanent: appends the model after the change to the ladder
/// (the sequence of the study's models), writes fit.json and ladder.json to `folder`, and last
/// writes study.toml.
/// @param before, after models before and after the change, fitted to the same readings
/// @param fit fit of the changed study, for fit.json
/// @throws InputError if study.toml has changed since it was read; nothing is written
/// @throws std::runtime_error if a file cannot be written; study.toml is then unchanged
void apply_change(const StudyChange& change, const LadderStep& before, LadderStep after,
                  const Fitted& fit, Ladder& ladder, const std::filesystem::path& folder);

/// Result of adding or dropping an effect of a study: the fits before and after the change.
struct ChangedStudy {
    StudyChange change;
    /// Fit of the study before the change. If the fit after the change uses all readings, `before`
    /// is a fit to all readings too, even if the study was fitted to the dry readings only.
    Fitted before;
    /// Fit of the study after the change, which fit.json contains if `written` is true.
    Fitted after;
    /// Fit of the changed study to all readings, for comparison with `before`, if `before` is a fit
    /// to all readings and `after` is a fit to the dry readings only. Empty otherwise, or if the
    /// fit `after` did not converge.
    std::optional<Fitted> after_to_all;
    /// Ladder (the sequence of the study's models). The last model is the changed model if
    /// `written` is true.
    Ladder ladder;
    /// Whether the change was written to study.toml. False if the fit after the change did not
    /// converge.
    bool written = false;

    /// Returns the fit of the changed study to the same readings that the fit `before` uses, so
    /// that the misfits of the two fits can be compared.
    const Fitted& comparable_after() const { return after_to_all ? *after_to_all : after; }
};

/// Options for fitting a study before and after a change of its effects.
struct ChangeOptions {
    /// Options of the fits before and after the change.
    FitOptions fit = {};
    /// Whether to use the fidelity (set of simulation settings) of the fit in `folder`, if there is
    /// a fit.
    bool same_fidelity = true;
    /// Folder for results, which also contains the results of earlier commands.
    std::filesystem::path folder;
};

/// Adds an effect to a study or drops an effect, and fits the study before and after the change.
/// The fit in the results folder serves as the fit before the change if its simulation settings and
/// its choice of readings (dry or all) are comparable. If the fit after the change converges, the
/// function writes fit.json and ladder.json to the results folder and, last, study.toml. Otherwise
/// the function writes nothing.
/// @param effect name of the effect; an effect to add may be defined in proposed.toml of the
///        results folder
/// @throws InputError if the effect cannot be added or dropped, if ladder.json cannot be read, if a
///         fit is impossible, or if study.toml has changed since it was read
/// @throws std::runtime_error if a file cannot be written; study.toml is then unchanged
/// @throws dem::Interrupted if the user requests a stop; the message says how to continue
ChangedStudy change_study(const ResolvedStudy& study, const Measurements& measurements,
                          Action change, const std::string& effect, SessionOptions session,
                          const ChangeOptions& options);

}  // namespace pendular
