// `pendular add` and `pendular drop`: adds an effect to a study or removes it, and reports the
// change of the error.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <limits>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "app/belief.h"
#include "app/change_effects.h"
#include "app/command.h"
#include "app/effect_options.h"
#include "app/open_session.h"
#include "data/input_error.h"
#include "reports/change_report.h"
#include "reports/tables.h"
#include "reports/with_error.h"
#include "workflow/fit_runs.h"
#include "workflow/json_parts.h"
#include "workflow/proposed_effects.h"
#include "workflow/rival_effects.h"

namespace pendular::app {
namespace {

const char* const about_add =
    R"(Adds an effect to the list 'effects' of the model in study.toml, keeps comments and layout of the file,
and fits the model again. Prints the error before and after the change: chi2, the RMS error of the
readings, and the RMS error in cross-validation, in which a fit to the other conditions predicts each
condition. An effect that is truly missing should lower all three. Prints the fitted parameters before
and after the change.
)";

const char* const about_drop =
    R"(Removes an effect from the list 'effects' of the model in study.toml, keeps comments and layout of the
file, and fits the model again. Prints the error and the fitted parameters before and after the
change.
)";

const char* const about_both =
    R"(
Writes fit.json, ladder.json (every model of the study so far, with its chi2 and RMS error) and the
figure 'ladder' to the results folder. study.toml is changed last: it stays as it is if the fit does
not converge or is interrupted.

An emulator trained on Pendular's own simulations (the atlas) and all stored ones predicts the
readings, at the fidelity of the study's earlier fit unless --fidelity is given. New simulations are
made only with --confirm or --cold. 'pendular effects' lists the known effects.)";

struct AddOptions {
    FitOptions fit;
    std::int64_t seed = 1;
    std::vector<std::string> effects;  ///< to add or drop one after the other
    bool fidelity_given = false;
};

/// Parses the arguments of `pendular add` or `pendular drop` into `own` and the common options;
/// empty where the user requested the help text.
std::optional<CommonOptions> parse(Action change, const std::vector<std::string>& arguments,
                                   AddOptions& own) {
    const bool adds = change == Action::add;
    const std::string name = adds ? "add" : "drop";
    const std::string usage =
        name + (adds ? " STUDY EFFECT|--proposed NUMBER [options]" : " STUDY EFFECT [options]");
    Options options(usage, std::string(adds ? about_add : about_drop) + about_both,
                    fmt::format("  pendular {0} my-study torque-offset\n"
                                "  pendular {0} my-study lid-slip --confirm --json -\n"
                                "  pendular {0} my-study rolling-resistance --confirm 10\n{1}",
                                name, adds ? "  pendular add my-study --proposed 1\n" : ""),
                    true);
    std::vector<std::string> words;
    options.take(&words, one_of(names_of_effects()));
    options.add("seed", &own.seed, "seed of the simulations (default 1)");
    std::optional<double> confirming;
    options.add_time(
        "confirm", &confirming, std::numeric_limits<double>::infinity(),
        "check the new fit by new simulations, for at most MINUTES (default: no limit)");
    options.add_switch(
        "cold", &own.fit.cold,
        "simulate all states that the fit needs anew, without the simulations that come with the "
        "program (the atlas) and without those in the store");
    std::int64_t number = 0;
    if (adds) {
        options.add(
            "proposed", &number,
            "number of a proposal in proposed.toml, which 'pendular diagnose' wrote: add the "
            "effects of this proposal");
    }
    options.offer_runs_of();
    auto common = options.parse(arguments);
    if (!common) {
        return std::nullopt;
    }
    set_confirmation(confirming, own.fit);
    const bool proposed = adds && options.given("proposed");
    if (words.size() != (proposed ? 0 : 1)) {
        throw InputError(fmt::format("{}; usage: pendular {}",
                                     words.empty()
                                         ? "argument EFFECT (the name of an effect) is not given"
                                         : "too many arguments",
                                     usage));
    }
    own.effects = proposed ? proposal(common->out_folder() / "proposed.toml", number) : words;
    own.fidelity_given = options.given("fidelity");
    return common;
}

/// Sentence on the readings that the fits before and after a change use, where the study itself
/// fits the dry readings alone before or after it; empty otherwise.
std::string on_fitted_readings(const ChangedStudy& changed) {
    if (changed.after_to_all) {
        const Calibration& c = changed.after.calibration;
        return fmt::format(
            "The fits with and without {0} use all readings, dry and wet. Without {0}, a fit to "
            "the dry readings alone ('pendular calibrate') gives {1} = {2}.",
            changed.change.effect, c.parameters[0].name,
            estimate_text(c.fit, 0, c.parameters[0].unit));
    }
    return changed.widened ? fmt::format(
                                 "Both fits, with and without {0}, use all readings, dry and wet, "
                                 "as 'pendular calibrate' does if the model contains {0}.",
                                 changed.change.effect)
                           : "";
}

void print_evidence(Console& console, const ChangedStudy& changed) {
    const StudyChange& change = changed.change;
    const FittedStudy& before = changed.before;
    const FittedStudy& after = changed.comparable_after();
    console.table(error_changes(before.ladder_step, after.ladder_step), 10);
    console.table(parameter_changes(before.ladder_step, after.ladder_step), 5);
    const bool adds = change.change == Action::add;
    console.line(fmt::format("Chi2 is {:.2f} for {} {} {}, and {:.2f} for {} {} it.",
                             before.ladder_step.chi2, freedom_text(before.ladder_step.dof),
                             adds ? "without" : "with", change.effect, after.ladder_step.chi2,
                             after.ladder_step.dof, adds ? "with" : "without"));
    if (const std::string line = on_fitted_readings(changed); !line.empty()) {
        console.line(line);
    }
    if (change.change == Action::drop &&
        change.study.catalogue().is_written(change.study.catalogue().find(change.effect))) {
        console.line(
            fmt::format("Its table [[effect]] stays in {}.", change.study.study().file.string()));
    }
    for (const auto& line : advice_on(change, before.ladder_step, after.ladder_step)) {
        console.note(line);
    }
    if (const auto& rivals = after.ladder_step.rivals; !rivals.empty()) {
        std::vector<std::string> names, effects = {change.effect};
        for (const auto& rival : rivals) {
            names.push_back(fmt::format("{}", fmt::join(rival, " with ")));
            for (const std::string& effect : rival) {
                if (std::ranges::find(effects, effect) == effects.end()) effects.push_back(effect);
            }
        }
        console.line(fmt::format(
            "In the last diagnosis, other effects explained the readings as well as {}: {}. "
            "'pendular diagnose' and 'pendular next' continue to compare these models.",
            change.effect, fmt::join(names, ", ")));
        const std::string methods = direct_methods(effects, change.study.catalogue());
        if (!methods.empty()) {
            console.line(
                fmt::format("A direct measurement would decide between them: {}.", methods));
        }
    }
    print_limits(console, after.calibration.runs, after.calibration.readings,
                 after.calibration.fit.parameters(0));
    if (!before.calibration.fit.converged) {
        console.note("The fit before the change did not converge: " +
                     before.calibration.fit.message);
    }
    if (after.left_out.undetermined > 0) {
        console.note(fmt::format(
            "Cross-validation: without {} of the {} conditions, the other conditions do not "
            "determine a parameter, which then keeps its starting value.",
            after.left_out.undetermined == 1
                ? "one"
                : fmt::format("any of {}", after.left_out.undetermined),
            after.left_out.conditions));
    }
    for (const auto& note : after.calibration.notes) {
        console.note(note);
    }
}

int refuse_fit(Console& console, const ChangedStudy& changed) {
    console.answer(answer_on(changed));
    for (const auto& note : changed.after.calibration.notes) {
        console.note(note);
    }
    return not_converged;
}

/// Adds or drops one effect, and prints the error before and after. Returns the exit code.
/// @param last whether it is the last effect, whose change the JSON states
int change_study(Action what, const std::string& effect, const AddOptions& own,
                 const CommonOptions& common, Console& console, bool last) {
    const auto figures = common.out_folder() / "figures";
    OpenSession session(console, common, outputs_of_change(), own.seed,
                        OpenSession::Access::changes);
    const ChangedStudy changed =
        change_effects(*session, what, effect, own.fit, !own.fidelity_given);
    const LadderStep &before = changed.before.ladder_step,
                     &after = changed.comparable_after().ladder_step;
    const Belief& belief = changed.after.belief;
    auto json = to_json(changed.change, before, after, changed.written);
    const Calibration& fit = changed.after.calibration;
    json["runs"] = runs_json(fit.runs, fit.known);
    add_belief(json, belief);
    if (last || !changed.written) console.json(json);  // before the figure, which needs gnuplot
    if (changed.written) {
        console.answer(answer_on(changed));
        print_doubts(console, belief, 0,
                     changed.after_to_all
                         ? "Warning from 'pendular calibrate', which fits the dry readings alone: "
                         : "Warning about the new fit: ");
        print_evidence(console, changed);
        console.figures(figures, {draw_ladder(changed.ladder, figures)});
        console.next(
            next_after(changed.change, before, after, belief.believable(), common.study_word()));
    }
    const int code = changed.written ? static_cast<int>(done) : refuse_fit(console, changed);
    return belief.meaningless ? static_cast<int>(not_converged) : code;
}

int change_study(Action what, const std::vector<std::string>& arguments) {
    AddOptions own;
    const auto common = parse(what, arguments, own);
    if (!common) {
        return done;
    }
    Console console(*common);
    for (const std::string& effect : own.effects) {
        const bool last = effect == own.effects.back();
        const int code = change_study(what, effect, own, *common, console, last);
        if (code != done || last) return code;
    }
    return done;
}

}  // namespace

int add(const std::vector<std::string>& arguments) {
    return change_study(Action::add, arguments);
}

int drop(const std::vector<std::string>& arguments) {
    return change_study(Action::drop, arguments);
}

}  // namespace pendular::app
