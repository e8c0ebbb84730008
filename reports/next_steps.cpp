#include "reports/next_steps.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <functional>
#include <iterator>
#include <utility>

#include "reports/diagnosis_table.h"
#include "reports/direct_measurement.h"
#include "reports/impact_report.h"
#include "reports/other_causes.h"
#include "reports/proposal_report.h"
#include "reports/with_error.h"
#include "reports/words.h"
#include "workflow/next.h"
#include "workflow/rivals.h"

namespace pendular {
namespace {

/// Largest number of direct measurements among the steps. Chosen: a list that a user can follow.
constexpr std::size_t most_direct = 3;

/// Steps that a diagnosis calls for.
class Steps {
  public:
    Steps(const StudyDiagnosis& d, const std::optional<ImpactTable>& impacts,
          const ResolvedStudy& resolved, const std::string& study)
        : d_(d), diagnosis_(d.diagnosis), impacts_(impacts), resolved_(resolved), study_(study) {}

    std::vector<NextStep> of_verdict() {
        if (diagnosis_.verdict != Verdict::suspect_measurement) look_at_odd_recording();
        check_far_error();
        switch (diagnosis_.verdict) {
            case Verdict::nothing_missing:
                sharpen();
                break;
            case Verdict::inconclusive:
                inconclusive();
                break;
            case Verdict::missing:
                missing();
                break;
            case Verdict::indistinguishable:
                indistinguishable();
                break;
            case Verdict::suspect_measurement:
                suspect();
                break;
            case Verdict::unknown:
                unknown();
                break;
        }
        return std::move(steps_);
    }

  private:
    void say(std::string text) { steps_.push_back({.text = std::move(text)}); }
    void say_direct(std::string text) {
        steps_.push_back({.text = std::move(text), .direct = true});
    }
    void sharpen() {
        if (!d_.rivals.empty() && rivals_of(d_).size() > 1) {
            measure_directly(effects_of_rivals(), {});
            tell_apart("the present model and its rivals");
            return;
        }
        steps_.push_back({fmt::format("Optional: for smaller standard errors, take the readings "
                                      "that 'pendular next {}' plans.",
                                      study_),
                          true});
    }
    void tell_apart(const std::string& what) {
        const bool repeated = !diagnosis_.suspects.empty();
        steps_.push_back({.text = fmt::format("Take the readings that 'pendular next {}' plans to "
                                              "tell {} apart.",
                                              study_, what),
                          .readings = true,
                          .condition = repeated ? "If the new readings agree with the old: " : ""});
    }
    void repeat_suspects() {
        if (diagnosis_.suspects.empty()) return;
        const bool readings = !std::ranges::all_of(diagnosis_.suspects, [&](const auto& name) {
            const auto& known = d_.evidence.suspects;
            const auto it = std::ranges::find(known, name, &SuspectMeasurement::name);
            return it != known.end() && it->group == "direct measurements";
        });
        say(fmt::format("Repeat {}{}: an error there would explain the residuals as well.",
                        joined(diagnosis_.suspects, "and"),
                        readings ? " (readings with a new filling)" : ""));
    }

    void look_at_odd_recording();
    void check_far_error();
    void missing();
    void inconclusive();
    void indistinguishable();
    void suspect();
    void unknown();
    void measure_directly(const std::vector<std::string>& effects,
                          const std::vector<FittedModel>& models);
    /// Says of an effect that is there anyway that it is to be added before others are sought.
    void add_certain(const Effect& effect) {
        steps_.push_back(
            {.text = fmt::format("Add {0} before you look for another cause, since {1}; it acts in "
                                 "every cell in which beads rest on the base. Then diagnose again: "
                                 "pendular add {2} {0}.",
                                 effect.name, effect.certain, study_),
             .add = effect.name});
    }
    std::vector<std::string> effects_of_rivals() const;
    bool matters(const std::string& effect) const;
    /// Whether the study states a direct measurement of an effect already.
    bool measured(const std::string& effect) const {
        const auto& direct = resolved_.study().direct;
        return std::ranges::find(direct, effect, &StatedDirect::effect) != direct.end();
    }
    void check_suspect_sensors(const std::vector<SuspectError>& errors);
    void check_sensors();
    /// Whether the study's files come from a sensor: tables of readings tell nothing of a gap.
    bool measured_by(std::string_view sensor) const {
        return sensor != "height" ||
               std::ranges::any_of(resolved_.study().sources, [](const Source& source) {
                   return source.kind == Source::Kind::recording;
               });
    }

    const StudyDiagnosis& d_;
    const Diagnosis& diagnosis_;
    const std::optional<ImpactTable>& impacts_;
    const ResolvedStudy& resolved_;
    const std::string& study_;
    std::vector<NextStep> steps_;
};

/// Clause that names the effects after the first: " and the readings call for lid-slip too".
std::string others_than_first(const std::vector<std::string>& effects) {
    if (effects.size() < 2) return "";
    return fmt::format(" and the readings call for {} too",
                       joined({effects.begin() + 1, effects.end()}, "and"));
}

void Steps::measure_directly(const std::vector<std::string>& effects,
                             const std::vector<FittedModel>& models) {
    std::vector<std::string> further, never;
    std::size_t named = 0;
    // An effect that is named alone is added anyway.
    for (const std::string& name : effects) {
        const Effect& effect = resolved_.catalogue().find(name);
        if (!effect.certain.empty() && effects.size() > 1) add_certain(effect);
    }
    for (const std::string& name : effects) {
        const Effect& effect = resolved_.catalogue().find(name);
        if (measured(name) || !effect.certain.empty()) continue;
        if (effect.directly.empty()) {
            never.push_back(name);
        } else if (named++ >= most_direct) {
            further.push_back(fmt::format("{} by {}", name, effect.directly));
        } else {
            say_direct(fmt::format("Measure {} directly, by {}.{}", name, effect.directly,
                                   value_to_expect(d_, resolved_, effect, models)));
        }
    }
    if (!further.empty()) {
        say(fmt::format("Measure the others directly too, if it is easy: {}.",
                        fmt::join(further, "; ")));
    }
    if (!never.empty() && never.size() < effects.size()) {
        say(fmt::format("No direct measurement settles {}: readings decide about {}.",
                        joined(never, "and"), never.size() == 1 ? "it" : "them"));
    }
}

/// Effects of the present model, and those that could stand in for them, which measurements without
/// shearing would tell apart.
std::vector<std::string> Steps::effects_of_rivals() const {
    std::vector<std::string> effects;
    const auto add = [&](const std::string& name) {
        if (std::ranges::find(effects, name) == effects.end()) effects.push_back(name);
    };
    for (const FittedModel& rival : d_.rivals) {
        add(rival.in_place_of);
        std::ranges::for_each(rival.effects, add);
    }
    std::erase_if(effects, [&](const std::string& name) {
        return resolved_.catalogue().find(name).directly.empty();
    });
    return effects;
}

/// A recording that stands out may be at fault whatever else is concluded.
void Steps::look_at_odd_recording() {
    const auto odd = odd_recording(d_);
    if (!odd || !odd->stands_out()) return;
    say(
        fmt::format("Look at {} first, and repeat it with a new filling: its {} stands out from "
                    "that of the other files.",
                    std::filesystem::path(odd->file).filename().string(),
                    odd->observable == 0 ? "shear stress" : "solid fraction"));
}

/// An error of the instrument that the readings need, and what acts like it, are measured before
/// anything else is sought.
void Steps::check_far_error() {
    if (d_.belief.far.empty()) return;
    const InstrumentError& far = d_.belief.far.front();
    std::vector<std::string> names = far.alike;
    names.insert(names.begin(), far.name);
    // Most errors of an instrument, such as that of a radius, are no effects.
    const std::vector<Effect>& known = resolved_.catalogue().all();
    std::erase_if(names, [&](const std::string& name) {
        const auto effect = std::ranges::find(known, name, &Effect::name);
        return effect == known.end() || effect->directly.empty();
    });
    measure_directly(names, {});
}

void Steps::missing() {
    const std::string& first = diagnosis_.effects.front();
    if (diagnosis_.leaders) {
        measure_directly(diagnosis_.effects, {diagnosis_.leaders->model});
    } else {
        measure_directly(diagnosis_.effects, diagnosis_.confidence_set);
    }
    repeat_suspects();
    const bool direct = std::ranges::any_of(steps_, &NextStep::direct);
    const auto* instrument =
        std::get_if<ChangeInstrument>(&resolved_.catalogue().find(first).change);
    const bool of_sensor =
        instrument != nullptr && instrument->where != ChangeInstrument::Where::grains;
    say(fmt::format("{} {} to the model{}: pendular add {} {}.{}",
                    direct ? "If the measurement agrees, or cannot be made, add" : "Add", first,
                    of_sensor ? " (or correct the data, not both)" : "", study_, first,
                    direct ? " If it disagrees, enter it and diagnose the study again." : ""));
    if (!diagnosis_.leaders && diagnosis_.confidence_set.size() > 1) {
        tell_apart("the further effects");
    } else if (diagnosis_.leaders || diagnosis_.effects.size() > 1) {
        say(
            fmt::format("Diagnose the study again, since a misfit remains with {} alone{}: "
                        "pendular diagnose {}.",
                        first, others_than_first(diagnosis_.effects), study_));
    } else {
        sharpen();
    }
}

void Steps::indistinguishable() {
    measure_directly(diagnosis_.effects, diagnosis_.confidence_set);
    repeat_suspects();
    tell_apart(joined(diagnosis_.effects, "and"));
}

/// Whether an effect of the smallest size of interest would shift the fitted friction coefficient
/// noticeably.
bool Steps::matters(const std::string& effect) const {
    // Chosen: a shift of 0.3 standard errors enlarges the error by 4 %, sqrt(1 + 0.3^2) - 1.
    constexpr double noticeable = 0.3;
    if (!impacts_) return true;
    const auto impact = std::ranges::find(impacts_->impacts, effect, &Impact::name);
    return impact == impacts_->impacts.end() ||
           std::abs(impact->at_interest.best()(0)) >= noticeable * impacts_->errors(0);
}

void Steps::inconclusive() {
    constexpr double large = 2;  // chi2/dof that errors known from few repetitions leave untested
    if (diagnosis_.errors_assumed) {
        say("Repeat some conditions with new fillings, or give the standard errors of the readings "
            "in _se columns: without known errors, no effect can be excluded.");
    } else if (diagnosis_.effects.empty() || diagnosis_.base.fit.chi2 > large * diagnosis_.dof) {
        say("Repeat more conditions with new fillings, so that the errors of the readings are "
            "better known.");
    }
    auto effects = impacts_ ? by_impact(*impacts_, diagnosis_.effects) : diagnosis_.effects;
    effects.resize(std::min(effects.size(), shown_undetected));  // those that the table shows
    std::size_t named = 0;
    for (const std::string& name : effects) {
        const Effect& effect = resolved_.catalogue().find(name);
        if (effect.directly.empty() || measured(name) || !matters(name) || named++ >= most_direct)
            continue;
        say_direct(fmt::format("To rule out {}, measure it directly, by {}.{}", name,
                               effect.directly, error_to_rule_out(d_, resolved_, effect)));
    }
    steps_.push_back({fmt::format("Optional: the readings that 'pendular next {}' plans make the "
                                  "standard errors of the fitted parameters smaller; they are not "
                                  "planned to settle the effects above.",
                                  study_),
                      true});
}

void Steps::check_sensors() {
    if (!resolved_.study().cell) return;
    for (const char* const sensor : {"torque", "normal_force", "height"}) {
        const FittedShape* change = nullptr;
        for (const Proposal& each : d_.proposals) {
            for (const auto* shapes : {&each.shapes, &each.alike}) {
                const auto found = std::ranges::find_if(*shapes, [&](const FittedShape& fitted) {
                    return fitted.shape.quantity.target == sensor;
                });
                if (change == nullptr && found != shapes->end()) change = &*found;
            }
        }
        if ((change != nullptr || d_.proposals.empty()) && measured_by(sensor)) {
            say(sensor_check(sensor, d_.readings, resolved_.study(), change));
        }
    }
}

void Steps::unknown() {
    check_sensors();
    const bool checked = !steps_.empty();
    if (d_.proposals.empty()) {
        say(fmt::format("Inspect the readings that deviate: pendular compare {} --all.", study_));
        say("If you suspect a cause, write it as a formula in a table [[effect]] of study.toml.");
        return;
    }
    if (rivals_of(d_).size() > 1) tell_apart("the causes in the beads");
    say(fmt::format(
        "{}, look for a cause in the beads. Until the cause is found, proposal 1 can stand in for "
        "it, so that the misfit falls: pendular add {} --proposed 1.",
        checked ? "If this finds no fault" : "If you find no fault of the measurement", study_));
}

void Steps::check_suspect_sensors(const std::vector<SuspectError>& errors) {
    if (!resolved_.study().cell) return;
    const auto first = [&](Eigen::Index observable) {
        return std::ranges::find_if(
            errors, [&](const SuspectError& error) { return error.concerns(observable); });
    };
    if (const auto error = first(0); error != errors.end()) {
        say(sensor_check("torque", d_.readings, resolved_.study(), nullptr, error->size(0)));
    }
    if (const auto error = first(1); error != errors.end() && measured_by("height")) {
        // A height that is shown too small makes the solid fraction too high.
        say(sensor_check("height", d_.readings, resolved_.study(), nullptr, -error->size(1)));
    }
}

void Steps::suspect() {
    if (diagnosis_.overruled) {
        say(fmt::format("Check {}, and correct it in the recordings or in study.toml.",
                        joined(diagnosis_.suspects, "or")));
        return;
    }
    const std::vector<SuspectError> errors = suspect_errors(d_);
    // A sensor that changed once is still wrong today: it is checked first. Any other error may be
    // gone: the measurement is repeated first.
    const bool lasting = std::ranges::any_of(
        errors, [](const SuspectError& error) { return error.suspect.group == "changes in time"; });
    if (lasting) check_suspect_sensors(errors);
    std::string own;
    for (const SuspectError& error : errors) {
        say(repetition_of(error, d_.readings));
        if (own.empty()) own = own_condition(d_.readings, error.suspect);
    }
    say(
        fmt::format("If new and old readings agree, keep both: the cause is then in what these "
                    "readings have in common{}.",
                    own.empty() ? "" : " (" + own + "): take readings at other values too"));
    if (!lasting) check_suspect_sensors(errors);
}

}  // namespace

std::vector<NextStep> next_steps(const StudyDiagnosis& diagnosis,
                                 const std::optional<ImpactTable>& impacts,
                                 const ResolvedStudy& resolved, const std::string& study) {
    std::vector<NextStep> steps = Steps(diagnosis, impacts, resolved, study).of_verdict();
    // 'pendular next' would only say that it plans none.
    if (std::ranges::any_of(steps, &NextStep::readings) && !can_plan(resolved, diagnosis))
        std::erase_if(steps, &NextStep::readings);
    return steps;
}

std::vector<std::string> step_lines(const std::vector<NextStep>& steps,
                                    const std::vector<std::string>& plan) {
    std::vector<std::string> lines = {"What to do, in this order:"};
    for (std::size_t k = 0; k < steps.size(); ++k) {
        const bool planned = steps[k].readings && !plan.empty();
        lines.push_back(fmt::format("  {}. {}", k + 1,
                                    steps[k].condition + (planned ? plan.front() : steps[k].text)));
        for (std::size_t line = 1; planned && line < plan.size(); ++line) {
            lines.push_back("     " + plan[line]);
        }
    }
    if (std::ranges::any_of(steps, &NextStep::direct)) {
        lines.emplace_back(
            "  (Enter a value that was measured directly into study.toml as a table [[direct]] "
            "with effect, value and error; 'pendular next --help' shows an example.)");
    }
    return lines;
}

std::string first_step(const std::vector<std::string>& lines) {
    const std::string number = "  1. ";
    return lines.size() > 1 ? lines[1].substr(number.size()) : "";
}

std::vector<std::string> texts_of(const std::vector<NextStep>& steps) {
    std::vector<std::string> texts;
    for (const NextStep& step : steps) {
        texts.push_back(step.condition + step.text);
    }
    return texts;
}

std::string next_command(const Diagnosis& diagnosis, const std::vector<NextStep>& steps,
                         const std::string& study) {
    switch (diagnosis.verdict) {
        case Verdict::missing:
            return fmt::format("pendular add {} {}", study, diagnosis.effects.front());
        case Verdict::unknown:
            if (std::ranges::any_of(steps, &NextStep::readings)) {
                return fmt::format("pendular next {}", study);
            }
            [[fallthrough]];
        case Verdict::suspect_measurement:
            return fmt::format("pendular diagnose {}   # after these steps", study);
        case Verdict::indistinguishable: {
            const auto added =
                std::ranges::find_if(steps, [](const NextStep& step) { return !step.add.empty(); });
            return added == steps.end() ? fmt::format("pendular next {}", study)
                                        : fmt::format("pendular add {} {}", study, added->add);
        }
        case Verdict::nothing_missing:
        case Verdict::inconclusive:
            break;
    }
    return fmt::format("pendular report {}", study);
}

}  // namespace pendular
