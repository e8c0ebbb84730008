// `pendular add` and `pendular drop`: an effect into a study or out of it, and what becomes of the
// error.
#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <utility>

#include "app/belief.h"
#include "app/calibration_run.h"
#include "app/command.h"
#include "app/interrupt.h"
#include "app/stored_runs.h"
#include "app/study_change.h"
#include "app/study_input.h"
#include "calib/calibrate_study.h"
#include "data/input_error.h"
#include "reports/draw_figure.h"
#include "reports/fit_file.h"
#include "reports/json.h"
#include "reports/json_parts.h"
#include "reports/ladder_figure.h"

namespace pendular::app {
namespace {

const char* const about_add =
    R"(Adds an effect to the list in the study's study.toml (its comments and layout stay), fits the
study with it and says what became of the error: chi2 and RMS error before and after, and that of
conditions left out of the fit one after the other, which must fall too. )";

const char* const about_drop =
    R"(Takes an effect out of the list in the study's study.toml (its comments and layout stay), fits
the study without it and says what became of the error. )";

const char* const about_both =
    R"(The parameters follow, before and after, with how far they moved. Writes fit.json, ladder.json,
which keeps every step, and the figure 'ladder' to the results folder. The study's file is changed
last; where the fit does not converge, or is interrupted, it stays as it was.

The fit is emulated from the atlas and all stored runs, at the fidelity of the study's earlier fit;
no simulation is made unless --confirm is given. 'pendular effects' lists the effects there are.)";

struct ChangeOptions {
    bool confirm = false, cold = false;
    std::int64_t seed = 1;
    std::string effect;
    bool fidelity_given = false;
};

/// Empty: help was asked for.
std::optional<CommonOptions> parse(Action change, const std::vector<std::string>& arguments,
                                   ChangeOptions& own) {
    const bool adds = change == Action::add;
    const std::string name = adds ? "add" : "drop";
    const std::string usage = name + " STUDY EFFECT [options]";
    Options options(usage, std::string(adds ? about_add : about_drop) + about_both,
                    fmt::format("  pendular {0} my-study torque-offset\n"
                                "  pendular {0} my-study lid-slip --confirm --json -\n",
                                name),
                    true);
    std::vector<std::string> words;
    options.take(&words);
    options.add("seed", &own.seed, "seed of the simulations (default 1)");
    options.add_switch("confirm", &own.confirm,
                       "fresh runs at the new optimum, until they and the emulator agree");
    options.add_switch("cold", &own.cold,
                       "by direct simulation alone, from neither the atlas nor earlier runs");
    auto common = options.parse(arguments);
    if (!common) {
        return std::nullopt;
    }
    if (words.size() != 1) {
        throw InputError(fmt::format("{}; usage: pendular {}",
                                     words.empty() ? "the effect is missing" : "too many arguments",
                                     usage));
    }
    own.effect = words.front();
    own.fidelity_given = options.given("fidelity");
    return common;
}

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

/// One change of a study from its input to its end.
class ChangeRun {
  public:
    ChangeRun(Console& console, const CommonOptions& common, const ChangeOptions& own)
        : console_(console), common_(common), own_(own), store_(open_store(common)) {}

    /// The study as it is: by its earlier fit where that one can be compared with.
    Fitted before(const Study& study, const Measurements& measurements) {
        request_.fidelity = common_.fidelity;
        request_.seed = checked_seed(own_.seed);
        auto earlier = earlier_fit(common_.out_folder() / "fit.json", study, measurements);
        const bool same_fidelity =
            earlier && (!own_.fidelity_given || earlier->fidelity.name == common_.fidelity.name);
        if (same_fidelity) {
            request_.fidelity = earlier->fidelity;
            request_.cohesion = earlier->cohesion;
        }
        const auto known = known_for(study);
        if (same_fidelity && earlier->scales.has_value() == known.has_value()) {
            return judged(study, std::move(*earlier));
        }
        say("the study as it is");
        return judged(study, calibrated(study, measurements, known, false));
    }
    Fitted after(const StudyChange& change, const Measurements& measurements) {
        say(fmt::format("{} {}", change.change == Action::add ? "with" : "without", change.effect));
        return judged(change.study, calibrated(change.study, measurements, known_for(change.study),
                                               own_.confirm));
    }

  private:
    void say(const std::string& what) {
        if (!common_.quiet) {
            fmt::print(stderr, "fitting {}\n", what);
        }
    }
    std::optional<KnownRuns> known_for(const Study& study) const {
        return own_.cold ? std::nullopt : known_runs(study, request_.fidelity, store_.get());
    }
    Calibration calibrated(const Study& study, const Measurements& measurements,
                           std::optional<KnownRuns> known, bool confirm) {
        CalibrationRequest request = request_;
        choose_rounds(request, std::move(known), confirm);
        return run_calibration(console_, common_, study, measurements, request, store_.get(),
                               !own_.cold, guard_.token());
    }
    Fitted judged(const Study& study, Calibration c) {
        Fitted result = fitted(study, std::move(c));
        if (guard_.token().stop_requested()) {
            throw store_ ? interrupted_with(*store_) : dem::Interrupted();
        }
        return result;
    }

    Console& console_;
    const CommonOptions& common_;
    const ChangeOptions& own_;
    const InterruptGuard guard_;
    std::unique_ptr<RunStore> store_;
    CalibrationRequest request_;
};

void print_evidence(Console& console, const StudyChange& change, const Fitted& before,
                    const Fitted& after, const CommonOptions& common) {
    for (const auto& line : parameter_changes(before.rung, after.rung)) {
        console.line(line);
    }
    console.line(fmt::format("chi2 = {:.2f} for {} degrees of freedom -> {:.2f} for {}",
                             before.rung.chi2, before.rung.dof, after.rung.chi2, after.rung.dof));
    for (const auto& line : advice_on(change, before.rung, after.rung, common.study.string())) {
        console.note(line);
    }
    if (!before.calibration.fit.converged) {
        console.note("the fit before the change had not converged: " +
                     before.calibration.fit.message);
    }
    if (after.undetermined > 0) {
        console.note(fmt::format(
            "without {} of the {} conditions left out one after the other, the others do not "
            "determine a parameter, which then keeps the value it starts with",
            after.undetermined, after.left_out));
    }
    for (const auto& note : after.calibration.notes) {
        console.note(note);
    }
}

int refuse_fit(Console& console, const StudyChange& change, const Fitted& after) {
    console.line(fmt::format("{} not {}: the fit {} it did not converge ({}); {} is as it was",
                             change.effect, change.change == Action::add ? "added" : "dropped",
                             change.change == Action::add ? "with" : "without",
                             after.calibration.fit.message, change.study.file.string()));
    for (const auto& note : after.calibration.notes) {
        console.note(note);
    }
    return not_converged;
}

int change_study(Action what, const std::vector<std::string>& arguments) {
    ChangeOptions own;
    const auto common = parse(what, arguments, own);
    if (!common) {
        return done;
    }
    Console console(*common);
    const auto out = common->out_folder();
    const auto [study, measurements] = read_input(*common, {"fit.json", "ladder.json", "figures"});
    const StudyChange change = plan_change(study, what, own.effect);
    Ladder ladder = read_ladder(out / "ladder.json");  // refused before any work

    ChangeRun run(console, *common, own);
    const Fitted before = run.before(study, measurements);
    Fitted after = run.after(change, measurements);
    after.belief = belief_in(change.study, measurements, after.calibration, after.comparison);
    const bool converged = after.calibration.fit.converged;
    if (converged) {
        carry_out(change, before.rung, after, ladder, out);
        console.line(verdict_of(change, before.rung, after.rung));
        print_doubts(console, after.belief);
        print_evidence(console, change, before, after, *common);
        const Figure figure = ladder_figure(ladder);
        draw(figure, out / "figures");
        console.line(
            fmt::format("figure: {}", (out / "figures" / (figure.name + ".png")).string()));
    }
    const int code = converged ? static_cast<int>(done) : refuse_fit(console, change, after);
    auto json = to_json(change, before.rung, after.rung, converged);
    add_belief(json, after.belief);
    console.json(json);
    return after.belief.meaningless ? static_cast<int>(not_converged) : code;
}

}  // namespace

int add(const std::vector<std::string>& arguments) {
    return change_study(Action::add, arguments);
}

int drop(const std::vector<std::string>& arguments) {
    return change_study(Action::drop, arguments);
}

}  // namespace pendular::app
