#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "sim/catalogue/resolved_study.h"
#include "workflow/fit_study.h"
#include "workflow/fitted_study.h"

namespace pendular {

/// Kind of change of the effects that a study lists.
enum class Action { add, drop };

/// Change of the effects that a study lists, checked but not yet written to study.toml.
struct StudyChange {
    Action change = Action::add;
    std::string effect;    ///< effect to add or drop
    ResolvedStudy study;   ///< study after the change
    std::string old_text;  ///< text of study.toml before the change
    std::string new_text;  ///< text of study.toml after the change
};

/// Checks a change and prepares the changed study. Nothing is written.
/// @param proposed effects that can be added although the study's catalogue lacks them; the new
///        text of study.toml then contains the table [[effect]] that defines the added effect
/// @throws InputError if an effect to add is unknown (the message names the nearest known effect),
///         does not apply to the study or is listed already, or if an effect to drop is not listed
StudyChange plan_change(const ResolvedStudy& study, Action change, const std::string& effect,
                        const std::vector<WrittenEffect>& proposed = {});

/// Makes a fitted change permanent: appends the model after the change to the ladder, writes
/// fit.json and ladder.json to `folder`, and last study.toml.
/// @param before, after models before and after the change, fitted to the same readings
/// @param fit fit of the changed study, for fit.json
/// @throws InputError if study.toml has changed since it was read; nothing is written
/// @throws std::runtime_error if a file cannot be written; study.toml is then unchanged
void apply_change(const StudyChange& change, const LadderStep& before, LadderStep after,
                  const FittedStudy& fit, Ladder& ladder, const std::filesystem::path& folder);

/// Result of adding or dropping an effect. The misfits of two fits can be compared only if both use
/// the same readings, all or the dry ones.
struct ChangedStudy {
    StudyChange change;
    /// Fit before the change. If the fit after it uses all readings, so does `before` (`widened`).
    FittedStudy before;
    FittedStudy after;  ///< fit after the change, which fit.json contains if `written` is true
    /// Fit of the changed study to all readings, if `before` is a fit to all readings and `after`
    /// to the dry ones only. Empty otherwise, or if the fit `after` did not converge.
    std::optional<FittedStudy> after_to_all;
    Ladder ladder;  ///< ends with the changed model if `written` is true
    /// Whether `before` uses all readings although the study was fitted to the dry ones only.
    bool widened = false;
    bool written = false;  ///< whether study.toml was changed; false: the fit did not converge

    /// Returns the fit of the changed study to the same readings that `before` uses.
    const FittedStudy& comparable_after() const { return after_to_all ? *after_to_all : after; }
};

/// Options for fitting a study before and after a change of its effects.
struct ChangeOptions {
    FitOptions fit = {};
    bool same_fidelity = true;  ///< whether to use the fidelity of the fit in the folder, if any
    /// Sets of effects without the added one that explained the readings equally well
    /// (`rivals_among`), which ladder.json is to keep.
    EffectNames rivals = {};
};

/// Adds an effect to a study or drops one, and fits the study before and after the change. The fit
/// in the results folder serves as the fit before the change if its fidelity and its choice of
/// readings (dry or all) are comparable. If the fit after the change converges, fit.json and
/// ladder.json are written to the results folder and, last, study.toml; otherwise nothing.
/// @param effect name of the effect; an effect to add may be defined in proposed.toml of `folder`
/// @param folder folder for results, also of earlier commands
/// @throws InputError if the effect cannot be added or dropped, if ladder.json cannot be read, if a
///         fit is impossible, or if study.toml has changed since it was read
/// @throws std::runtime_error if a file cannot be written; study.toml is then unchanged
/// @throws dem::Interrupted if the user requests a stop; the message says how to continue
ChangedStudy change_study(const ResolvedStudy& study, const Measurements& measurements,
                          Action change, const std::string& effect, SessionOptions session,
                          const ChangeOptions& options, const std::filesystem::path& folder);

}  // namespace pendular
