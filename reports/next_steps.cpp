#include "reports/next_steps.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>
#include <utility>

#include "analysis/design/rival.h"
#include "data/annular_cell.h"
#include "reports/impact_report.h"
#include "reports/joined.h"
#include "reports/with_error.h"
#include "workflow/diagnosis_json.h"

namespace pendular {
namespace {

/// Largest number of direct measurements among the steps.
constexpr std::size_t most_direct = 3;

/// Smallest and largest of the values that an instrument shows at the readings.
struct Range {
    double least = INFINITY, most = -INFINITY;

    void add(double value) {
        least = std::min(least, value);
        most = std::max(most, value);
    }
    /// Text of the range, "between 2.1 mN m and 80 mN m".
    std::string text(const std::string& unit) const {
        return fmt::format("between {} and {}", with_unit(least, unit), with_unit(most, unit));
    }
};

/// Check of one sensor: a known quantity, over the range of the readings.
std::string sensor_check(const std::string& target, const std::vector<Reading>& readings,
                         const Study& study) {
    Range range;
    for (const Reading& each : readings) {
        if (target == "height") {
            if (each.condition.height) range.add(*each.condition.height);
        } else if (study.cell) {
            range.add(target == "torque" ? torque(each.value(0), *study.cell)
                                         : normal_force(each.condition.normal_stress, *study.cell));
        }
    }
    const bool known = range.least <= range.most;
    const auto over = [&](const char* unit) {
        return known ? ", at several values " + range.text(unit) + " (the range of the readings)"
                     : std::string();
    };
    const std::string then = ". If it shows wrong values, correct the recordings.";
    if (target == "torque") {
        return "Check the torque transducer with known torques, such as weights on a lever" +
               over("N m") + then;
    }
    if (target == "normal_force") {
        return "Check the load cell with known weights" + over("N") + then;
    }
    return "Check the gap sensor with gauge blocks" + over("m") + then;
}

/// Steps that a diagnosis calls for.
class Steps {
  public:
    Steps(const StudyDiagnosis& d, const std::optional<ImpactTable>& impacts,
          const ResolvedStudy& resolved, const std::string& study)
        : d_(d), diagnosis_(d.diagnosis), impacts_(impacts), resolved_(resolved), study_(study) {}

    std::vector<NextStep> of_verdict() {
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
            default:
                unknown();
        }
        return std::move(steps_);
    }

  private:
    void say(std::string text) { steps_.push_back({.text = std::move(text)}); }
    void say_direct(std::string text) {
        steps_.push_back({.text = std::move(text), .direct = true});
    }
    void sharpen() {
        steps_.push_back({fmt::format("For smaller standard errors, take the readings that "
                                      "'pendular next {}' plans.",
                                      study_),
                          true});
    }
    void tell_apart(const std::string& what) {
        steps_.push_back(
            {fmt::format("Take the readings that 'pendular next {}' plans to tell {} apart.",
                         study_, what),
             true});
    }
    void repeat_suspects() {
        if (diagnosis_.suspects.empty()) return;
        say(
            fmt::format("Repeat {} with a new filling: an error there would explain the residuals "
                        "as well.",
                        joined(diagnosis_.suspects, "and")));
    }

    void missing();
    void inconclusive();
    void indistinguishable();
    void suspect();
    void unknown();
    void measure_directly(const std::vector<std::string>& effects,
                          const std::vector<Explanation>& models);
    std::string expected(const Effect& effect, const std::vector<Explanation>& models) const;
    std::string to_rule_out(const Effect& effect) const;
    bool matters(const std::string& effect) const;
    void check_sensors();

    const StudyDiagnosis& d_;
    const Diagnosis& diagnosis_;
    const std::optional<ImpactTable>& impacts_;
    const ResolvedStudy& resolved_;
    const std::string& study_;
    std::vector<NextStep> steps_;
};

/// Text of a standard error with which a deviation of this size is seen.
std::string deciding_error(double deviation, const std::string& unit) {
    return with_unit(std::abs(deviation) / std::sqrt(telling_directly), unit, 1);
}

/// Sentence on the value to expect if the effect is there, as the first of `models` that contains
/// it says; empty where none determines it.
std::string Steps::expected(const Effect& effect, const std::vector<Explanation>& models) const {
    const StudyModels& space = *d_.models;
    for (const Explanation& each : models) {
        if (each.suspect) continue;
        auto at = diagnosis_.fit.parameters.size();
        for (const std::size_t k : each.chosen) {
            const Candidate& candidate = space.candidates()[k];
            if (candidate.name == effect.name && candidate.free_parameters() > 0 &&
                at < each.fit.parameters.size()) {
                const EffectParameter& p = candidate.parameters.front();
                const double value = each.fit.parameters(at), error = each.fit.standard_error(at);
                const double without = effect.unlisted_value(resolved_.study().liquid);
                return fmt::format(
                    " Expect {} ({}) if the effect is there, else {}. A standard error of {} or "
                    "less decides.",
                    with_error(value, error, p.unit), p.meaning, with_unit(without, p.unit),
                    deciding_error(value - without, p.unit));
            }
            at += static_cast<Eigen::Index>(candidate.free_parameters());
        }
    }
    return "";
}

void Steps::measure_directly(const std::vector<std::string>& effects,
                             const std::vector<Explanation>& models) {
    std::size_t named = 0;
    for (const std::string& name : effects) {
        const Effect& effect = resolved_.catalogue().find(name);
        if (effect.directly.empty() || named++ == most_direct) continue;
        say_direct(fmt::format("Measure {} directly, by {}.{}", name, effect.directly,
                               expected(effect, models)));
    }
}

void Steps::missing() {
    const std::string& first = diagnosis_.effects.front();
    if (diagnosis_.leaders) {
        measure_directly(diagnosis_.effects, {diagnosis_.leaders->model});
    } else {
        measure_directly(diagnosis_.effects, diagnosis_.confidence_set);
    }
    repeat_suspects();
    say(fmt::format("Add {} to the model: pendular add {} {}.", first, study_, first));
    if (!diagnosis_.leaders && diagnosis_.confidence_set.size() > 1) {
        tell_apart("the further effects");
    } else if (diagnosis_.leaders || diagnosis_.effects.size() > 1) {
        say(
            fmt::format("Diagnose the study again, since a misfit remains with {} alone: "
                        "pendular diagnose {}.",
                        first, study_));
    } else {
        sharpen();
    }
}

void Steps::indistinguishable() {
    measure_directly(diagnosis_.effects, diagnosis_.confidence_set);
    repeat_suspects();
    tell_apart("these effects");
}

/// Sentence on the accuracy that rules an effect out at its smallest size of interest.
std::string Steps::to_rule_out(const Effect& effect) const {
    const EffectParameter& p = effect.parameters.front();
    if (p.is_switch()) return "";
    return fmt::format(" A standard error of {} or less rules out a deviation of {}.",
                       deciding_error(p.smallest_of_interest, p.unit),
                       with_unit(p.smallest_of_interest, p.unit));
}

/// Whether an effect of the smallest size of interest would shift the fitted friction coefficient
/// noticeably.
bool Steps::matters(const std::string& effect) const {
    constexpr double noticeable = 0.3;
    if (!impacts_) return true;
    const auto impact = std::ranges::find(impacts_->impacts, effect, &Impact::name);
    return impact == impacts_->impacts.end() ||
           std::abs(impact->at_interest.best()(0)) >= noticeable * impacts_->errors(0);
}

void Steps::inconclusive() {
    if (diagnosis_.errors_assumed || diagnosis_.effects.empty()) {
        say("Repeat some conditions with new fillings, or give the standard errors of the readings "
            "in _sd columns: without known errors, no effect can be excluded.");
    }
    const auto effects = impacts_ ? by_impact(*impacts_, diagnosis_.effects) : diagnosis_.effects;
    std::size_t named = 0;
    for (const std::string& name : effects) {
        const Effect& effect = resolved_.catalogue().find(name);
        if (effect.directly.empty() || !matters(name) || named++ >= most_direct) continue;
        say_direct(fmt::format("To rule out {}, measure it directly, by {}.{}", name,
                               effect.directly, to_rule_out(effect)));
    }
    sharpen();
}

void Steps::check_sensors() {
    static const char* const sensors[] = {"torque", "normal_force", "height"};
    for (const char* const sensor : sensors) {
        bool concerned = d_.proposals.empty();
        for (const Proposal& each : d_.proposals) {
            for (const auto* shapes : {&each.shapes, &each.alike}) {
                concerned |= std::ranges::any_of(*shapes, [&](const FittedShape& fitted) {
                    return fitted.shape.quantity.target == sensor;
                });
            }
        }
        if (concerned && resolved_.study().cell) {
            say(sensor_check(sensor, d_.readings, resolved_.study()));
        }
    }
}

/// Number of proposed causes that no check of a sensor settles.
std::size_t causes_in_beads(const StudyDiagnosis& d) {
    const auto of_sensor = [](const FittedShape& each) { return each.shape.quantity.of_sensor(); };
    std::size_t number = 0;
    for (const Proposal& each : d.proposals) {
        number += std::ranges::none_of(each.shapes, of_sensor);
    }
    if (!d.proposals.empty()) {
        const auto& alike = d.proposals.front().alike;
        number += static_cast<std::size_t>(std::ranges::count_if(alike, std::not_fn(of_sensor)));
    }
    return number;
}

void Steps::unknown() {
    check_sensors();
    const bool checked = !steps_.empty();
    if (d_.proposals.empty()) {
        say(fmt::format("Inspect the readings that deviate: pendular compare {} --all.", study_));
        say("If you suspect a cause, write it as a formula in a table [[effect]] of study.toml.");
        return;
    }
    if (causes_in_beads(d_) > 1) tell_apart("the causes in the beads");
    say(fmt::format("{}, add the change to the model: pendular add {} --proposed 1.",
                    checked ? "If the sensors are right" : "If the change has a cause in the beads",
                    study_));
}

void Steps::suspect() {
    const std::string all = joined(diagnosis_.suspects, "or");
    if (d_.overruled) {
        say(fmt::format("Check {}, and correct it in the recordings or in study.toml.", all));
    } else {
        bool stress = false, fraction = false;
        for (const Explanation& each : diagnosis_.confidence_set) {
            if (!each.suspect || d_.evidence.suspects[*each.suspect].quantities.empty()) continue;
            const auto first = diagnosis_.fit.parameters.size();
            const auto deviates = [&](Eigen::Index k) {
                return first + k < each.fit.parameters.size() &&
                       std::abs(each.fit.parameters(first + k)) >
                           2 * each.fit.standard_error(first + k);
            };
            stress |= deviates(0);
            fraction |= deviates(1);
        }
        if (stress && resolved_.study().cell) {
            say(sensor_check("torque", d_.readings, resolved_.study()));
        }
        if (fraction && resolved_.study().cell) {
            say(sensor_check("height", d_.readings, resolved_.study()));
        }
        say(fmt::format("Repeat {} with a new filling.", all));
        say("If the new readings differ from the old, remove the old file (its table [[readings]]) "
            "from study.toml. If they agree, keep both: the cause is then in what these readings "
            "have in common.");
    }
}

}  // namespace

std::vector<NextStep> next_steps(const StudyDiagnosis& diagnosis,
                                 const std::optional<ImpactTable>& impacts,
                                 const ResolvedStudy& resolved, const std::string& study) {
    return Steps(diagnosis, impacts, resolved, study).of_verdict();
}

std::vector<std::string> step_lines(const std::vector<NextStep>& steps,
                                    const std::vector<std::string>& plan) {
    std::vector<std::string> lines = {"What to do, in this order:"};
    for (std::size_t k = 0; k < steps.size(); ++k) {
        const bool planned = steps[k].readings && !plan.empty();
        lines.push_back(fmt::format("  {}. {}", k + 1, planned ? plan.front() : steps[k].text));
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
    std::ranges::transform(steps, std::back_inserter(texts), &NextStep::text);
    return texts;
}

std::string next_command(const StudyDiagnosis& d, const std::string& study) {
    const Diagnosis& diagnosis = d.diagnosis;
    switch (diagnosis.verdict) {
        case Verdict::missing:
            return fmt::format("pendular add {} {}", study, diagnosis.effects.front());
        case Verdict::unknown:
            return causes_in_beads(d) > 1 ? fmt::format("pendular next {}", study)
                                          : fmt::format("pendular compare {} --all", study);
        case Verdict::suspect_measurement:
            return fmt::format("pendular diagnose {}   # after these steps", study);
        case Verdict::indistinguishable:
            return fmt::format("pendular next {}", study);
        default:
            return fmt::format("pendular compare {}", study);
    }
}

}  // namespace pendular
