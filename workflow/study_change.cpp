#include "workflow/study_change.h"

#include <fmt/chrono.h>
#include <fmt/format.h>

#include <algorithm>
#include <ctime>
#include <nlohmann/json.hpp>
#include <optional>
#include <stdexcept>
#include <utility>

#include "calib/fit/calibrate_study.h"
#include "data/files/text_file.h"
#include "data/input_error.h"
#include "data/study/study_edit.h"
#include "workflow/json/fit.h"
#include "workflow/proposed_effects.h"
#include "workflow/study_input.h"

namespace pendular {
namespace {

/// Checks that an effect can be added to a study.
/// @throws InputError where the effect is unknown or does not apply to the study
void check_added(const ResolvedStudy& study, const std::string& name) {
    try {
        if (const auto why = why_not(study.catalogue().find(name), study)) {
            throw InputError({study.study().file.string()}, *why);
        }
    } catch (const std::invalid_argument& error) {
        throw InputError(error.what());
    }
}

/// Whether the study's catalogue has an effect with this name.
bool is_known(const std::string& name, const ResolvedStudy& study) {
    const auto& all = study.catalogue().all();
    return std::ranges::find(all, name, &Effect::name) != all.end();
}

/// Effect with this name among the `proposed` ones; null where the study's catalogue has one.
const WrittenEffect* proposed_effect(const std::string& name, const ResolvedStudy& study,
                                     const std::vector<WrittenEffect>& proposed) {
    if (is_known(name, study)) return nullptr;
    const auto found = std::ranges::find(proposed, name, &WrittenEffect::name);
    return found == proposed.end() ? nullptr : &*found;
}

/// The study with one more effect in its catalogue, which it does not list.
ResolvedStudy defining_too(const Study& study, const WrittenEffect& effect) {
    Study more = study;
    more.written_effects.push_back(effect);
    return more;
}

/// Text of study.toml with a table appended.
std::string with_table(const std::string& text, const std::string& table) {
    // The file keeps the line ends that it has.
    const bool crlf = text.find("\r\n") != std::string::npos;
    std::string added = (text.ends_with('\n') ? "\n" : "\n\n") + table;
    if (!crlf) return text + added;
    std::string converted;
    for (const char c : added) {
        converted += c == '\n' ? std::string("\r\n") : std::string(1, c);
    }
    return text + converted;
}

const char* word_for(Action change) {
    return change == Action::add ? "add" : "drop";
}

}  // namespace

StudyChange plan_change(const ResolvedStudy& study, Action change, const std::string& effect,
                        const std::vector<WrittenEffect>& proposed) {
    const std::string file = study.study().file.string();
    const std::string old_text = read_text(file, largest_settings);
    if (change == Action::drop) {
        Study changed = study;
        std::erase_if(changed.model.effects,
                      [&](const ListedEffect& one) { return one.name == effect; });
        return {change, effect, study.changed_to(std::move(changed)), old_text,
                without_effect(old_text, file, effect)};
    }
    const WrittenEffect* defined = proposed_effect(effect, study, proposed);
    const ResolvedStudy defining = defined ? defining_too(study, *defined) : study;
    check_added(defining, effect);
    Study changed = defining;
    changed.model.effects.push_back({effect, {file}});
    const std::string& text = defined ? with_table(old_text, effect_table(*defined)) : old_text;
    return {change, effect, defining.changed_to(std::move(changed)), old_text,
            with_effect(text, file, effect)};
}

void apply_change(const StudyChange& change, const LadderStep& before, LadderStep after,
                  const FittedStudy& fit, Ladder& ladder, const std::filesystem::path& out) {
    const std::filesystem::path& file = change.study.study().file;
    if (read_text(file, largest_settings) != change.old_text) {
        throw InputError({file.string()},
                         "has changed while the fit was under way; nothing was written: give the "
                         "same command again");
    }
    after.change = word_for(change.change);
    after.effect = change.effect;
    after.when = fmt::format("{:%Y-%m-%d %H:%M}", fmt::localtime(std::time(nullptr)));
    add_step(ladder, before, std::move(after));
    // The study is written last: whatever fails before, it is as it was.
    write_calibration(out, fit.calibration, fit.comparison, fit.belief);
    write_ladder(out / "ladder.json", ladder);
    replace_study(file, change.new_text);
}

namespace {

/// Fit of the study that an earlier command wrote to `file`; empty where there is none, where the
/// study has changed since, where its parameters are not those of the study's model, or where the
/// fit did not converge.
std::optional<FittedStudy> earlier_fit(const std::filesystem::path& file,
                                       const ResolvedStudy& study,
                                       const Measurements& measurements) {
    try {
        Calibration c = read_calibration(file, study, readings_to_fit(measurements));
        return c.fit.converged ? std::optional(fitted(study, std::move(c))) : std::nullopt;
    } catch (const InputError&) {
        return std::nullopt;
    }
}

/// Computes the errors of a fit at conditions left out.
/// @throws dem::Interrupted where the user stops the work
FittedStudy cross_validated(FittedStudy fit, const SessionOptions& session, bool refits = true) {
    cross_validate(fit, refits);
    if (session.stop.stop_requested()) throw interrupted_with(session.store);
    return fit;
}

}  // namespace

ChangedStudy change_study(const ResolvedStudy& study, const Measurements& measurements, Action what,
                          const std::string& effect, SessionOptions session,
                          const ChangeOptions& options, const std::filesystem::path& folder) {
    const auto proposed =
        is_known(effect, study) ? ProposedEffects{} : read_proposed(folder / "proposed.toml");
    StudyChange change = plan_change(study, what, effect, proposed.effects);
    Ladder ladder = read_ladder(folder / "ladder.json");  // throws before any work
    FitOptions fit = options.fit;
    auto earlier = earlier_fit(folder / "fit.json", study, measurements);
    const bool comparable =
        earlier &&
        (options.same_fidelity || earlier->calibration.fidelity.name == session.fidelity.name);
    if (comparable) {
        session.fidelity = earlier->calibration.fidelity;
        fit.cohesion = earlier->calibration.cohesion;
    }
    FitOptions unconfirmed = fit;
    unconfirmed.confirm = false;
    const auto fit_now = [&](const ResolvedStudy& one, const FitOptions& how, bool refits = true) {
        return cross_validated(fitted(one, fit_study(one, measurements, session, how)), session,
                               refits);
    };
    const ResolvedStudy changed = change.study;
    const std::vector<Reading> readings = readings_to_fit(measurements);
    const bool all_before = fitted_count(study, readings) == readings.size(),
               all_after = fitted_count(changed, readings) == readings.size();
    // The fit of an earlier command serves only if it was made as the new one will be: with the
    // same readings, and with runs of the same origin. Differences would else be taken for the
    // effect's.
    FittedStudy before;
    if (comparable && (all_before || !all_after) &&
        earlier->calibration.cold == begins_cold(study, session, fit)) {
        before = cross_validated(std::move(*earlier), session);
    } else {
        tell(session.listener,
             {.kind = Event::Kind::stage, .text = "fitting the study before the change"});
        before = fit_now(all_after ? fitting_all(study) : study, unconfirmed);
    }
    tell(session.listener,
         {.kind = Event::Kind::stage,
          .text = fmt::format("fitting {} {}", what == Action::add ? "with" : "without", effect)});
    ChangedStudy result{.change = std::move(change), .before = std::move(before)};
    // Where a fit to all readings is compared in its place, nobody asks for its errors.
    const bool compared = all_after || !all_before;
    FittedStudy& after = result.after = fit_now(changed, fit, compared);
    after.belief = belief_in(after, changed, measurements);
    after.ladder_step.rivals = options.rivals;
    result.widened = all_after && !all_before;
    result.written = after.calibration.fit.converged;
    if (result.written) {
        if (!compared) result.after_to_all = fit_now(fitting_all(changed), unconfirmed);
        apply_change(result.change, result.before.ladder_step,
                     result.comparable_after().ladder_step, after, ladder, folder);
    }
    result.ladder = std::move(ladder);
    return result;
}

}  // namespace pendular
