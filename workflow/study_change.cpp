#include "workflow/study_change.h"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <optional>
#include <stdexcept>
#include <utility>

#include "calib/calibrate_study.h"
#include "data/input_error.h"
#include "data/study_edit.h"
#include "data/text_file.h"
#include "sim/effect_catalogue.h"
#include "workflow/belief.h"
#include "workflow/fit_file.h"
#include "workflow/known_runs.h"
#include "workflow/ladder_file.h"

namespace pendular {
namespace {

/// @throws InputError where there is no such effect or it does not apply
void check_added(const Study& study, const std::string& name) {
    const EffectCatalogue catalogue(study);
    try {
        if (const auto why = why_not(catalogue.find(name), study)) {
            throw InputError({study.file.string()}, *why);
        }
    } catch (const std::invalid_argument& error) {
        throw InputError(error.what());
    }
}

const char* word_for(Action change) {
    return change == Action::add ? "add" : "drop";
}

}  // namespace

StudyChange plan_change(const Study& study, Action change, const std::string& effect) {
    StudyChange plan{change, effect, study, read_text(study.file), {}};
    auto& listed = plan.study.model.effects;
    if (change == Action::add) {
        check_added(study, effect);
        plan.new_text = with_effect(plan.old_text, study.file.string(), effect);
        listed.push_back({effect, {study.file.string()}});
    } else {
        plan.new_text = without_effect(plan.old_text, study.file.string(), effect);
        std::erase_if(listed, [&](const ListedEffect& one) { return one.name == effect; });
    }
    return plan;
}

Fitted fitted(const Study& study, Calibration c) {
    const StudyModel model(study, c);
    c.prediction = predict_readings(model.model(), c);
    const auto left_out = left_out_errors(model.model(), c);
    Comparison comparison = compare(c);
    Rung rung = rung_of(c, comparison, left_out);
    const LeftOut counted = left_out.value_or(LeftOut{});
    return {.calibration = std::move(c),
            .comparison = std::move(comparison),
            .rung = std::move(rung),
            .left_out = counted.conditions,
            .undetermined = counted.undetermined};
}

nlohmann::ordered_json to_json(const StudyChange& change, const Rung& before, const Rung& after,
                               bool written) {
    const auto side = [](const Rung& rung) {
        auto json = to_json(rung);
        for (const char* of_the_ladder : {"step", "change", "effect"}) {
            json.erase(of_the_ladder);
        }
        return json;
    };
    return {{"change", word_for(change.change)},
            {"effect", change.effect},
            {"written", written},
            {"before", side(before)},
            {"after", side(after)}};
}

void carry_out(const StudyChange& change, const Rung& before, const Fitted& after, Ladder& ladder,
               const std::filesystem::path& out) {
    const std::filesystem::path& file = change.study.file;
    if (read_text(file) != change.old_text) {
        throw InputError({file.string()},
                         "has changed while the fit was under way; nothing was written: give the "
                         "same command again");
    }
    Rung rung = after.rung;
    rung.change = word_for(change.change);
    rung.effect = change.effect;
    climb(ladder, before, std::move(rung));
    write_calibration(out, after.calibration, after.comparison, after.belief);
    write_ladder(out / "ladder.json", ladder);
    replace_study(file, change.new_text);
}

namespace {

/// The study's fit from an earlier command, where it is still the study's and converged.
std::optional<Calibration> earlier_fit(const std::filesystem::path& file, const Study& study,
                                       const Measurements& measurements) {
    try {
        Calibration c = read_calibration(file, study, dry_first(measurements));
        return c.fit.converged ? std::optional(std::move(c)) : std::nullopt;
    } catch (const InputError&) {
        return std::nullopt;
    }
}

/// @throws dem::Interrupted where that was asked for meanwhile
Fitted fitted(const Study& study, Calibration c, const SessionOptions& session) {
    Fitted result = fitted(study, std::move(c));
    if (session.stop.stop_requested()) throw interrupted_with(session.store);
    return result;
}

/// Whether known runs would serve the fit of a study.
bool emulated(const Study& study, const SessionOptions& session, bool cold) {
    return !cold && known_runs(study, session.fidelity, session.store).has_value();
}

}  // namespace

ChangedStudy change_study(const Study& study, const Measurements& measurements, Action what,
                          const std::string& effect, SessionOptions session,
                          const ChangeOptions& options) {
    ChangedStudy result;
    result.change = plan_change(study, what, effect);
    result.ladder = read_ladder(options.folder / "ladder.json");  // refused before any work
    FitOptions fit = options.fit;
    auto earlier = earlier_fit(options.folder / "fit.json", study, measurements);
    const bool comparable =
        earlier && (options.same_fidelity || earlier->fidelity.name == session.fidelity.name);
    if (comparable) {
        session.fidelity = earlier->fidelity;
        fit.cohesion = earlier->cohesion;
    }
    if (comparable && earlier->scales.has_value() == emulated(study, session, fit.cold)) {
        result.before = fitted(study, std::move(*earlier), session);
    } else {
        tell(session.listener, {.kind = Event::Kind::stage, .text = "fitting the study as it is"});
        FitOptions unconfirmed = fit;
        unconfirmed.confirm = false;
        result.before =
            fitted(study, fit_study(study, measurements, session, unconfirmed), session);
    }
    tell(session.listener,
         {.kind = Event::Kind::stage,
          .text = fmt::format("fitting {} {}", what == Action::add ? "with" : "without", effect)});
    const Study& changed = result.change.study;
    result.after = fitted(changed, fit_study(changed, measurements, session, fit), session);
    result.after.belief =
        belief_in(changed, measurements, result.after.calibration, result.after.comparison);
    result.written = result.after.calibration.fit.converged;
    if (result.written) {
        carry_out(result.change, result.before.rung, result.after, result.ladder, options.folder);
    }
    return result;
}

}  // namespace pendular
