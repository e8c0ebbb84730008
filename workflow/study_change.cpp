#include "workflow/study_change.h"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <optional>
#include <stdexcept>
#include <utility>

#include "calib/fit/calibrate_study.h"
#include "data/files/text_file.h"
#include "data/input_error.h"
#include "data/study/study_edit.h"
#include "workflow/belief.h"
#include "workflow/fit_file.h"
#include "workflow/known_runs.h"
#include "workflow/ladder_file.h"
#include "workflow/rival_effects.h"

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

const char* word_for(Action change) {
    return change == Action::add ? "add" : "drop";
}

}  // namespace

StudyChange plan_change(const ResolvedStudy& study, Action change, const std::string& effect) {
    Study changed = study;
    const std::string file = changed.file.string();
    std::string old_text = read_text(changed.file), new_text;
    auto& listed = changed.model.effects;
    if (change == Action::add) {
        check_added(study, effect);
        new_text = with_effect(old_text, file, effect);
        listed.push_back({effect, {file}});
    } else {
        new_text = without_effect(old_text, file, effect);
        std::erase_if(listed, [&](const ListedEffect& one) { return one.name == effect; });
    }
    ResolvedStudy after = study.changed_to(std::move(changed));
    return {change, effect, std::move(after), std::move(old_text), std::move(new_text)};
}

Fitted fitted(const ResolvedStudy& study, Calibration c) {
    const StudyModel model(study, c);
    c.prediction = predict_readings(model.model(), c);
    const auto left_out = left_out_errors(model.predictor(), c);
    Comparison comparison = compare(c);
    LadderStep ladder_step = ladder_step_of(c, comparison, left_out);
    const LeftOut counted = left_out.value_or(LeftOut{});
    return {.calibration = std::move(c),
            .comparison = std::move(comparison),
            .ladder_step = std::move(ladder_step),
            .left_out = counted.conditions,
            .undetermined = counted.undetermined};
}

nlohmann::ordered_json to_json(const StudyChange& change, const LadderStep& before,
                               const LadderStep& after, bool written) {
    const auto side = [](const LadderStep& ladder_step) {
        auto json = to_json(ladder_step);
        for (const char* of_the_ladder : {"step", "change", "effect", "rivals"}) {
            json.erase(of_the_ladder);
        }
        return json;
    };
    return {{"change", word_for(change.change)},
            {"effect", change.effect},
            {"written", written},
            {"rivals", after.rivals},
            {"before", side(before)},
            {"after", side(after)}};
}

void apply_change(const StudyChange& change, const LadderStep& before, const Fitted& after,
                  Ladder& ladder, const std::filesystem::path& out) {
    const std::filesystem::path& file = change.study.study().file;
    if (read_text(file) != change.old_text) {
        throw InputError({file.string()},
                         "has changed while the fit was under way; nothing was written: give the "
                         "same command again");
    }
    LadderStep ladder_step = after.ladder_step;
    ladder_step.change = word_for(change.change);
    ladder_step.effect = change.effect;
    climb(ladder, before, std::move(ladder_step));
    write_calibration(out, after.calibration, after.comparison, after.belief);
    write_ladder(out / "ladder.json", ladder);
    replace_study(file, change.new_text);
}

namespace {

/// Fit of the study that an earlier command wrote to `file`; empty where there is none, where the
/// study has changed since, or where the fit did not converge.
std::optional<Calibration> earlier_fit(const std::filesystem::path& file,
                                       const ResolvedStudy& study,
                                       const Measurements& measurements) {
    try {
        Calibration c = read_calibration(file, study, dry_first(measurements));
        return c.fit.converged ? std::optional(std::move(c)) : std::nullopt;
    } catch (const InputError&) {
        return std::nullopt;
    }
}

/// Compares a calibration with all readings, and computes its errors at conditions left out.
/// @throws dem::Interrupted where the user stops the work
Fitted fitted(const ResolvedStudy& study, Calibration c, const SessionOptions& session) {
    Fitted result = fitted(study, std::move(c));
    if (session.stop.stop_requested()) throw interrupted_with(session.store);
    return result;
}

}  // namespace

ChangedStudy change_study(const ResolvedStudy& study, const Measurements& measurements, Action what,
                          const std::string& effect, SessionOptions session,
                          const ChangeOptions& options) {
    StudyChange change = plan_change(study, what, effect);
    Ladder ladder = read_ladder(options.folder / "ladder.json");  // throws before any work
    FitOptions fit = options.fit;
    auto earlier = earlier_fit(options.folder / "fit.json", study, measurements);
    const bool comparable =
        earlier && (options.same_fidelity || earlier->fidelity.name == session.fidelity.name);
    if (comparable) {
        session.fidelity = earlier->fidelity;
        fit.cohesion = earlier->cohesion;
    }
    Fitted before;
    if (comparable && earlier->cold == begins_cold(study, session, fit)) {
        before = fitted(study, std::move(*earlier), session);
    } else {
        tell(session.listener,
             {.kind = Event::Kind::stage, .text = "fitting the study before the change"});
        FitOptions unconfirmed = fit;
        unconfirmed.confirm = false;
        before = fitted(study, fit_study(study, measurements, session, unconfirmed), session);
    }
    tell(session.listener,
         {.kind = Event::Kind::stage,
          .text = fmt::format("fitting {} {}", what == Action::add ? "with" : "without", effect)});
    const ResolvedStudy& changed = change.study;
    Fitted after = fitted(changed, fit_study(changed, measurements, session, fit), session);
    after.belief = belief_in(changed, measurements, after.calibration, after.comparison);
    if (what == Action::add) {
        after.ladder_step.rivals = rivals_in(options.folder / "diagnosis.json", study, effect);
    }
    const bool written = after.calibration.fit.converged;
    if (written) {
        apply_change(change, before.ladder_step, after, ladder, options.folder);
    }
    return {std::move(change), std::move(before), std::move(after), std::move(ladder), written};
}

}  // namespace pendular
