#include "app/study_change.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <utility>

#include "calib/calibrate_study.h"
#include "data/input_error.h"
#include "data/study_edit.h"
#include "data/text_file.h"
#include "reports/fit_file.h"
#include "reports/json.h"
#include "sim/effect_catalogue.h"

namespace pendular::app {
namespace {

constexpr std::array<const char*, 2> observables = {"shear stress", "solid fraction"};

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

std::string number(double value) {
    return std::abs(value) < 1000 ? fmt::format("{:.3g}", value) : fmt::format("{:.0f}", value);
}

std::string percents(double before, double after) {
    return fmt::format("{} % -> {} %", number(before), number(after));
}

std::string left_out_text(const Rung& before, const Rung& after) {
    if (!before.left_out_percent || !after.left_out_percent) {
        return "";
    }
    const auto &a = *before.left_out_percent, &b = *after.left_out_percent;
    return fmt::format("; left-out conditions {} and {}", percents(a[0], b[0]),
                       percents(a[1], b[1]));
}

std::string estimate(const RungParameter* parameter) {
    return parameter ? with_error(parameter->value, parameter->standard_error) : "-";
}

/// Drift in the errors that the parameter had [1].
double drift(const RungParameter& before, const RungParameter& after) {
    return (after.value - before.value) / before.standard_error;
}

std::string parameter_line(const std::string& name, const std::string& unit,
                           const RungParameter* before, const RungParameter* after) {
    const std::string moved = before && after
                                  ? fmt::format("{:+.1f} standard errors", drift(*before, *after))
                              : after ? "new"
                                      : "gone";
    return fmt::format("  {:<36} {:>24} {:>24}   {}",
                       unit == "1" ? name : fmt::format("{} [{}]", name, unit), estimate(before),
                       estimate(after), moved);
}

/// "shear stress", "shear stress and solid fraction": those whose left-out error rose by more than
/// a twentieth.
std::string left_out_rose(const Rung& before, const Rung& after) {
    std::string which;
    if (!before.left_out_percent || !after.left_out_percent) {
        return which;
    }
    for (std::size_t o = 0; o < observables.size(); ++o) {
        if ((*after.left_out_percent)[o] > 1.05 * (*before.left_out_percent)[o]) {
            which += (which.empty() ? "" : " and ") + std::string(observables[o]);
        }
    }
    return which;
}

std::string advice_on_added(const std::string& effect, const Rung& before, const Rung& after,
                            const std::string& study) {
    const std::string undo = fmt::format(
        "'pendular drop {0} {1}' takes it out again, 'pendular diagnose {0}' says what may be "
        "missing",
        study, effect);
    if (after.chi2 >= before.chi2) {
        return fmt::format("the error did not fall: chi2 {} -> {}; {} is not what is missing: {}",
                           number(before.chi2), number(after.chi2), effect, undo);
    }
    if (fell_by_chance(before, after)) {
        return fmt::format(
            "the error fell by no more than chance: chi2 {} -> {} with {} more parameters; the "
            "readings do not ask for {}: {}",
            number(before.chi2), number(after.chi2), before.dof - after.dof, effect, undo);
    }
    if (const std::string which = left_out_rose(before, after); !which.empty()) {
        return fmt::format(
            "chi2 fell, but of conditions left out of the fit the error of {} rose: {} serves the "
            "readings it was fitted to and not others; measure at further conditions before you "
            "trust it, or drop it: {}",
            which, effect, undo);
    }
    return "";
}

std::string advice_on_dropped(const std::string& effect, const Rung& before, const Rung& after,
                              const std::string& study) {
    if (after.chi2 <= before.chi2) {
        return fmt::format("the error did not rise without {}: it was not needed", effect);
    }
    if (fell_by_chance(after, before)) {
        return fmt::format(
            "without {} the error rose by no more than chance: chi2 {} -> {}; the readings do not "
            "ask for it",
            effect, number(before.chi2), number(after.chi2));
    }
    return fmt::format(
        "the error rose without {0}: chi2 {1} -> {2}; the readings ask for it, or for something "
        "like it: 'pendular add {3} {0}' puts it back",
        effect, number(before.chi2), number(after.chi2), study);
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

std::string verdict_of(const StudyChange& change, const Rung& before, const Rung& after) {
    return fmt::format(
        "{} {}: chi2/dof {} -> {}, RMS error of shear stress {}, of solid fraction {}{}",
        change.effect, change.change == Action::add ? "added" : "dropped",
        number(before.chi2_per_dof()), number(after.chi2_per_dof()),
        percents(before.rms_percent[0], after.rms_percent[0]),
        percents(before.rms_percent[1], after.rms_percent[1]), left_out_text(before, after));
}

std::vector<std::string> parameter_changes(const Rung& before, const Rung& after) {
    std::vector<std::string> lines = {
        fmt::format("  {:<36} {:>24} {:>24}   {}", "parameter", "before", "after", "drift")};
    for (const RungParameter& p : before.parameters) {
        lines.push_back(parameter_line(p.name, p.unit, &p, after.find(p.name)));
    }
    for (const RungParameter& p : after.parameters) {
        if (!before.find(p.name)) {
            lines.push_back(parameter_line(p.name, p.unit, nullptr, &p));
        }
    }
    return lines;
}

std::vector<std::string> advice_on(const StudyChange& change, const Rung& before, const Rung& after,
                                   const std::string& study) {
    std::vector<std::string> lines;
    const auto advise = change.change == Action::add ? advice_on_added : advice_on_dropped;
    if (std::string advice = advise(change.effect, before, after, study); !advice.empty()) {
        lines.push_back(std::move(advice));
    }
    for (const RungParameter& p : before.parameters) {
        const RungParameter* const later = after.find(p.name);
        if (later && std::abs(drift(p, *later)) > 3) {
            lines.push_back(
                fmt::format("{} moved by {:.1f} times the error it had: one of the two models took "
                            "for {} what is something else",
                            p.name, std::abs(drift(p, *later)), p.name));
        }
    }
    return lines;
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

}  // namespace pendular::app
