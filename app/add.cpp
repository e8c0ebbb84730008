// `pendular add` and `pendular drop`: adds an effect to a study or removes it, and reports the
// change of the error.
#include <fmt/format.h>

#include <limits>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "app/command.h"
#include "app/effect_options.h"
#include "app/open_session.h"
#include "data/input_error.h"
#include "reports/change_figure.h"
#include "reports/change_report.h"
#include "reports/misfit_figures.h"
#include "workflow/json/diagnosis.h"
#include "workflow/proposed_effects.h"

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
figures 'ladder' and 'change' (readings against the model, before and after) to the results folder.
study.toml is changed last: it stays as it is if the fit does not converge or is interrupted.

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

/// Adds or drops one effect, and prints the error before and after. Returns the exit code.
/// @param last whether it is the last effect, whose change the JSON states
int change_study(Action what, const std::string& effect, const AddOptions& own,
                 const CommonOptions& common, Console& console, bool last) {
    OpenSession session(console, common, outputs_of_change(), own.seed,
                        OpenSession::Access::changes);
    const ChangedStudy changed =
        change_effects(*session, what, effect, own.fit, !own.fidelity_given);
    const Belief& belief = changed.after.belief;
    // Before the figure, which needs gnuplot.
    if (last || !changed.written) console.json(to_json(changed));
    console.print(change_output(changed));
    if (changed.written) {
        console.figures(common.out_folder() / "figures",
                        {ladder_figure(changed.ladder), change_figure(changed)});
        console.next(next_after(changed.change, changed.before.ladder_step,
                                changed.comparable_after().ladder_step, belief.believable(),
                                common.study_word()));
    }
    return changed.written && !belief.meaningless ? done : not_converged;
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
