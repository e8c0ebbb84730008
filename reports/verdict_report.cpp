#include "reports/verdict_report.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "reports/failure_report.h"
#include "reports/fit_report.h"
#include "reports/tables.h"
#include "reports/with_error.h"
#include "reports/words.h"
#include "workflow/json/diagnosis.h"

namespace pendular {
namespace {

/// Short list of names: "lid-slip, liquid-loss, torque-gain and 8 more".
std::string some_of(std::vector<std::string> names) {
    constexpr std::size_t most_named = 4;  // in one sentence; the table has all
    if (names.size() > most_named) {
        const std::size_t others = names.size() - (most_named - 1);
        names.resize(most_named - 1);
        names.push_back(fmt::format("{} more", others));
    }
    return joined(names, "and");
}

double chi2_per_dof(double chi2, double dof) {
    return chi2 / std::max(1.0, dof);
}

/// Name of an effect's parameter in a sentence: "surface tension" of
/// "capillary-bridges.surface_tension".
std::string spoken_parameter(std::string parameter) {
    parameter.erase(0, parameter.rfind('.') + 1);
    std::ranges::replace(parameter, '_', ' ');
    return parameter;
}

/// Text of a refitted parameter of an explanation with its error: "0.41 +- 0.03 mN m".
std::string refitted_text(const FittedModel& explanation, Eigen::Index k, const std::string& unit) {
    return estimate_text(explanation.fit, k, unit);
}

/// Names of the effects of an explanation with the refitted values, "torque-offset (torque 0.41 +-
/// 0.03 mN m)"; an effect that is a switch has no value.
std::string with_estimates(const FittedModel& explanation, const ModelSpace& space) {
    const auto parameters = space.with(explanation.chosen)->parameters();
    auto next = static_cast<Eigen::Index>(space.with({})->parameters().size());
    std::vector<std::string> texts;
    for (const std::size_t k : explanation.chosen) {
        const Candidate& candidate = space.candidates()[k];
        std::string values;
        for (std::size_t own = 0; own < candidate.free_parameters(); ++own, ++next) {
            const Parameter& parameter = parameters[static_cast<std::size_t>(next)];
            values +=
                fmt::format("{}{} {}", values.empty() ? "" : ", ", spoken_parameter(parameter.name),
                            refitted_text(explanation, next, parameter.unit));
        }
        texts.push_back(values.empty() ? candidate.name
                                       : fmt::format("{} ({})", candidate.name, values));
    }
    return joined(texts, "and");
}

/// ". Measured shear stress falls below the model as height grows.": the strongest significant
/// trend as a sentence; "." where no trend is significant.
std::string strongest_trend(const Checks& checks) {
    const Check* strongest = nullptr;
    for (const Check* check : significant_checks(checks)) {
        const bool trend = check->kind == Check::Kind::trend;
        if (trend &&
            (strongest == nullptr || std::abs(check->statistic) > std::abs(strongest->statistic))) {
            strongest = check;
        }
    }
    return strongest == nullptr
               ? "."
               : fmt::format(": the residual of the {} (measured minus model) {} with the {}.",
                             strongest->of, strongest->statistic > 0 ? "increases" : "decreases",
                             strongest->covariate);
}

const FittedModel* best_of(const std::vector<FittedModel>& explanations) {
    const auto best = std::ranges::min_element(
        explanations, {}, [](const FittedModel& each) { return each.fit.chi2; });
    return best == explanations.end() ? nullptr : &*best;
}

/// Text of the reduction of chi2/dof by an explanation: "chi2/dof from 7.79 to about 0.94".
std::string reduction(const Diagnosis& d, const FittedModel& by) {
    const auto dof = static_cast<double>(by.fit.dof);
    return fmt::format("chi2/dof from {:.2f} to about {:.2f}", chi2_per_dof(d.base.fit.chi2, d.dof),
                       chi2_per_dof(by.fit.chi2, dof));
}

/// Text of a share, rounded down so that it never reads 100 % below 1: "99.7 %".
std::string percent(double share) {
    return fmt::format("{:.{}f} %", std::floor(1000 * share) / 10, share < 0.99 ? 0 : 1);
}

std::string leading_line(const Diagnosis& d, const ModelSpace& space) {
    const FittedModel& model = d.leaders->model;
    return fmt::format(
        "Missing: {}. Adding {} brings {}, which removes {} of the excess of chi2 over its degrees "
        "of freedom. No effect in the catalogue explains the misfit that remains.",
        with_estimates(model, space), joined(names_of(model, space), "and"), reduction(d, model),
        percent(d.leaders->explained));
}

/// For each model that fits, its effects beyond those that all these models contain:
/// "torque-offset", "lid-slip with bead-loss".
std::vector<std::string> others_of(const Diagnosis& d, const ModelSpace& space) {
    std::vector<std::string> sets;
    for (const FittedModel& each : d.confidence_set) {
        std::vector<std::string> names = names_of(each, space);
        std::erase_if(names, [&](const std::string& name) {
            return std::ranges::find(d.effects, name) != d.effects.end();
        });
        sets.push_back(names.empty() ? "nothing more" : joined(names, "with"));
    }
    return sets;
}

/// Sentence on weak evidence that something is missing; empty where the evidence is strong.
std::string weak_evidence(const Diagnosis& d) {
    constexpr double strong = 0.01;  // chosen: one complete study in 33 has p of 1 to 2.5 %
    const double p = std::min(d.base.lack_of_fit_p, d.base.further_p);
    return p < strong
               ? ""
               : fmt::format(" The evidence that anything is missing is weak (p {}).", p_text(p));
}

/// Refitted model of one effect that leaves the least misfit of those that the verdict does not
/// name; null where none was refitted, or where it fits too, as an effect that contains the named
/// one does.
const FittedModel* next_best(const Diagnosis& d, const ModelSpace& space) {
    const FittedModel* closest = nullptr;
    for (const FittedModel& each : d.tried) {
        if (each.suspect || each.chosen.size() != 1 || !each.fit.converged) continue;
        const std::string name = names_of(each, space).front();
        const bool named = std::ranges::any_of(d.confidence_set, [&](const FittedModel& set) {
            const auto names = names_of(set, space);
            return std::ranges::find(names, name) != names.end();
        });
        if (!named && (closest == nullptr || each.fit.chi2 < closest->fit.chi2)) closest = &each;
    }
    return closest && closest->accepted ? nullptr : closest;
}

/// Words on how alone the named effect stands: "; the next-best effect, torque-gain, would leave
/// 3.15, and the readings rule it out". Empty where nothing is known of others (`next_best`).
std::string uniqueness(const Diagnosis& d, const ModelSpace& space) {
    const FittedModel* const other = next_best(d, space);
    if (other == nullptr) return "";
    return fmt::format(
        "; the next-best effect, {}, would leave {:.2f}, and the readings rule it out",
        names_of(*other, space).front(), chi2_per_dof(other->fit.chi2, other->fit.dof));
}

std::string missing_line(const Diagnosis& d, const ModelSpace& space) {
    if (d.leaders) return leading_line(d, space);
    const FittedModel& best = *best_of(d.confidence_set);
    std::string line =
        fmt::format("Missing: {}. Adding {} brings {}{}.", with_estimates(best, space),
                    best.chosen.size() > 1 ? "them" : "it", reduction(d, best),
                    best.chosen.size() > 1 ? "" : uniqueness(d, space));
    if (d.confidence_set.size() > 1) {
        line = fmt::format(
            "Missing: {}, and one further effect, {} (these readings do not tell which). Adding {} "
            "brings {}.",
            joined(d.effects, "and"), joined(others_of(d, space), "or"),
            joined(names_of(best, space), "and"), reduction(d, best));
    }
    return line + weak_evidence(d);
}

std::string indistinguishable_line(const Diagnosis& d, const ModelSpace& space) {
    std::vector<std::string> sets;
    std::vector<double> left;
    for (const FittedModel& each : d.confidence_set) {
        sets.push_back(with_estimates(each, space));
        left.push_back(chi2_per_dof(each.fit.chi2, each.fit.dof));
    }
    const std::string least = fmt::format("{:.2f}", std::ranges::min(left)),
                      most = fmt::format("{:.2f}", std::ranges::max(left));
    return fmt::format(
               "Indistinguishable: something {} missing, and these readings do not tell whether it "
               "is {}. Adding {} brings chi2/dof from {:.2f} to {}.",
               weak_evidence(d).empty() ? "is" : "may be", joined(sets, "or"),
               sets.size() == 2 ? "either" : "any one of them",
               chi2_per_dof(d.base.fit.chi2, d.dof),
               least == most ? "about " + least : fmt::format("between {} and {}", least, most)) +
           weak_evidence(d);
}

/// Names of the effects each of which would take at least half of a large misfit, though the errors
/// of the readings are known too badly to test it.
std::vector<std::string> untested_effects(const Diagnosis& d, const ModelSpace& space) {
    // `Steps::inconclusive` advises repeats from the same chi2/dof on.
    constexpr double large = 2, most = 0.5;
    std::vector<std::string> names;
    if (chi2_per_dof(d.base.fit.chi2, d.dof) < large) return names;
    for (const Finding& finding : d.scan) {
        const double reduction =
            finding.refitted_reduction.value_or(finding.test.predicted_reduction);
        if (reduction > most * d.excess()) {
            names.push_back(space.candidates()[finding.candidate].name);
        }
    }
    return names;
}

/// Sentence on errors of measurement that explain the readings at least as well as the effects of
/// the verdict; empty without any.
std::string suspects_beside(const Diagnosis& d) {
    return d.suspects.empty()
               ? ""
               : fmt::format(" An error in {} would explain the readings at least as well.",
                             joined(d.suspects, "or"));
}

std::string inconclusive_line(const Diagnosis& d, const ModelSpace& space) {
    if (const auto names = untested_effects(d, space); !names.empty()) {
        return fmt::format(
            "Inconclusive: chi2/dof is {:.2f} and {} could explain most of it, but too few "
            "repeated readings state the errors. Repeat more conditions with new fillings.",
            chi2_per_dof(d.base.fit.chi2, d.dof),
            names.size() > 1 ? "any one of " + some_of(names) : names.front());
    }
    if (d.effects.empty() && !d.errors_assumed) {
        return fmt::format(
            "The model describes the readings (chi2/dof {:.2f}). No known effect improves it, but "
            "none would show in these readings.",
            chi2_per_dof(d.base.fit.chi2, d.dof));
    }
    if (d.effects.empty()) {
        return "Inconclusive: the errors of the readings are assumed, not measured, so that they "
               "do not tell whether an effect is missing.";
    }
    const bool one = d.effects.size() == 1;
    return fmt::format(
        "The model describes the readings{} (chi2/dof {:.2f}). They are inconclusive about {} "
        "effect{} that could go undetected at the size that matters: {}.",
        d.errors_assumed ? " within assumed errors" : "", chi2_per_dof(d.base.fit.chi2, d.dof),
        d.effects.size(), one ? "" : "s", some_of(d.effects));
}

/// Sentence on how alike the effects of the verdict change the readings, beyond what the calibrated
/// parameters imitate.
std::string alike_line(const Diagnosis& d) {
    constexpr double similar = 0.9;  // a fifth of the squared change (1 - 0.9^2) differs: chosen
    if (d.effects.size() == 2) {
        return fmt::format(
            "{} and {} change these readings in a {} way (cosine {:.3f}; 1: in the "
            "same way).",
            d.effects[0], d.effects[1], d.cosines(0, 1) < similar ? "partly similar" : "similar",
            d.cosines(0, 1));
    }
    // Both halves are equal but for rounding, which must not decide who is named first.
    Eigen::MatrixXd others = d.cosines;
    others.triangularView<Eigen::Lower>().setOnes();
    Eigen::Index one = 0, other = 0;
    const double least = others.minCoeff(&one, &other);
    const auto name = [&](Eigen::Index k) { return d.effects[static_cast<std::size_t>(k)]; };
    return fmt::format(
        "These effects change the readings in {} ways (least cosine {:.3f}, of {} and {}; 1: in "
        "the same way).",
        least < similar ? "partly similar" : "similar", least, name(one), name(other));
}

/// Sentence on the known effect that comes closest to a change of unknown cause.
std::string outdone_line(const Diagnosis& d, const ModelSpace& space) {
    const auto best = std::ranges::min_element(
        d.fitting, {}, [](const FittedModel& each) { return each.fit.chi2; });
    if (best == d.fitting.end()) return "";
    return fmt::format(
        "{} would describe the readings too ({}), but proposal 1 describes them clearly better: "
        "its chi2 is lower by more than 10 after a penalty for the choice.",
        with_estimates(*best, space), reduction(d, *best));
}

/// Text of an explanation in a sentence: "with wall-friction".
std::string with_effects(const FittedModel& explanation, const ModelSpace& space) {
    return explanation.suspect ? "with the error of measurement corrected"
                               : "with " + joined(names_of(explanation, space), "and");
}

}  // namespace

std::string doubt_line(const StudyDiagnosis& study) {
    if (!is_of_fitting_model(study.diagnosis.verdict) || study.belief.believable()) return "";
    const auto odd = odd_recording(study);
    if (!odd || !odd->stands_out())
        return "Its fitted values are in doubt all the same: see the warnings.";
    return std::filesystem::path(odd->file).filename().string() +
           " stands out, and the fitted values are in doubt: see the warnings.";
}

std::string friction_line(const StudyDiagnosis& study, bool calibrated) {
    const Diagnosis& d = study.diagnosis;
    const StudyModelSpace& space = *study.models;
    if (study.mistake || study.diagnosis.overruled) return "";
    const auto text = [](const Fit& fit, const std::string& of) {
        return fmt::format("{} {}", estimate_text(fit, 0, "1"), of);
    };
    std::vector<std::string> values;
    const auto add = [&](const FittedModel& each) {
        constexpr std::size_t most = 3;  // values in one sentence; the table has all
        if ((!each.chosen.empty() || each.suspect) && values.size() < most) {
            values.push_back(text(each.fit, with_effects(each, space)));
        }
    };
    if (d.leaders) add(d.leaders->model);
    std::ranges::for_each(d.confidence_set, add);
    if (values.empty() && !study.proposals.empty()) {
        values.push_back(text(study.proposals.front().model.fit, "with proposal 1"));
    }
    const bool alone = values.empty();
    values.push_back(text(d.base.fit, alone ? "" : "in the study's present model"));
    std::string line = fmt::format("The {} fitted to all readings{} {}",
                                   parameter_in_words(space.with({})->parameters().front().name),
                                   alone ? " is" : ":", fmt::join(values, "; "));
    if (alone) line.pop_back();
    if (alone && d.complete && !calibrated && study.belief.believable())
        line += " ('pendular calibrate' gives the value to report)";
    return line + (d.complete || d.leaders ? "." : ". Do not report it before the cause is found.");
}

std::vector<std::string> close_effects_lines(const Diagnosis& d, const ModelSpace& space) {
    std::vector<std::string> lines;
    const auto add = [&](std::string line) {
        if (!line.empty()) lines.push_back(std::move(line));
    };
    if (d.verdict == Verdict::indistinguishable) add(alike_line(d));
    if (d.verdict == Verdict::unknown && d.outdone()) {
        add(outdone_line(d, space));
    } else if (d.verdict == Verdict::unknown) {
        if (const FittedModel* best = best_of(d.tried); best && !best->suspect) {
            add(fmt::format("Of the known effects, {} {} closest and {} {}, which is not enough.",
                            with_estimates(*best, space),
                            best->chosen.size() > 1 ? "come" : "comes",
                            best->chosen.size() > 1 ? "bring" : "brings", reduction(d, *best)));
        }
    }
    if (d.errors_assumed) {
        add("The errors of the readings are assumed to be 2 %: repeated readings or _se columns "
            "give a firmer verdict.");
    }
    return lines;
}

std::string verdict_line(const Diagnosis& d, const ModelSpace& space, const Checks& checks) {
    switch (d.verdict) {
        case Verdict::nothing_missing:
            return fmt::format(
                "Nothing missing: no known effect improves the model, and every effect large "
                "enough to matter would have shown in these readings (chi2/dof {:.2f}).",
                chi2_per_dof(d.base.fit.chi2, d.dof));
        case Verdict::inconclusive:
            return inconclusive_line(d, space);
        case Verdict::missing:
            return missing_line(d, space) + suspects_beside(d);
        case Verdict::indistinguishable:
            return indistinguishable_line(d, space) + suspects_beside(d);
        case Verdict::suspect_measurement:
            if (d.overruled && (d.base.accepted || !d.fitting.empty()))
                return fmt::format(
                    "Suspect measurement: values of {} are doubtful in themselves, so that no test "
                    "of an effect counts before they are corrected.",
                    joined(d.suspects, "and"));
            return fmt::format(
                "Suspect measurement: an error in {} explains the residuals, and none of the known "
                "effects does.",
                joined(d.suspects, "or"));
        case Verdict::unknown:
            break;
    }
    return fmt::format("Unknown: something is missing that no known effect explains{}{}",
                       d.outdone() ? " as well as a proposed change does" : "",
                       strongest_trend(checks));
}

std::string verdict_headline(const Diagnosis& d, const ModelSpace& space, const Checks& checks) {
    if (d.verdict != Verdict::indistinguishable) {
        const std::string all = verdict_line(d, space, checks);
        const auto end = all.find(". ");
        return end == std::string::npos ? all : all.substr(0, end + 1);
    }
    constexpr std::size_t most_named = 4;
    std::vector<std::string> names;
    for (const FittedModel& each : d.confidence_set) {
        names.push_back(joined(names_of(each, space), "with"));
    }
    if (names.size() > most_named) {
        const std::size_t others = names.size() - (most_named - 1);
        names.resize(most_named - 1);
        names.push_back(fmt::format("{} more", others));
    }
    return fmt::format(
        "Something {} missing, and these readings do not tell what: {} explain them about as well.",
        weak_evidence(d).empty() ? "is" : "may be", joined(names, "and"));
}

std::string undetected_shift_line(const Diagnosis& d, const std::optional<ImpactTable>& impacts) {
    if (d.verdict != Verdict::inconclusive || !impacts) return "";
    const Impact* largest = nullptr;
    for (const Impact& each : impacts->impacts) {
        if (each.measurement || std::ranges::find(d.effects, each.name) == d.effects.end())
            continue;
        const auto shift = [](const Impact& one) { return std::abs(one.at_interest.best()(0)); };
        if (!largest || shift(each) > shift(*largest)) largest = &each;
    }
    if (!largest) return "";
    const Parameter& friction = impacts->parameters.front();
    const double shift = largest->at_interest.best()(0);
    return fmt::format("Of these, {} would change the {} most: by {}{} at the size that matters.",
                       largest->name, parameter_in_words(friction.name), shift > 0 ? "+" : "",
                       with_unit(shift, friction.unit));
}

std::vector<std::string> incomplete_lines(const Diagnosis& d, const std::array<double, 2>& before,
                                          const std::array<double, 2>& after,
                                          const Checks& remaining) {
    if (!d.leaders) return {};
    const std::string effects = joined(d.effects, "and");
    std::vector<std::string> lines = {
        fmt::format("With {}, the relative RMS error of shear stress goes from {:.2f} % to {:.2f} "
                    "%, that of solid "
                    "fraction from {:.2f} % to {:.2f} %.",
                    effects, before[0], after[0], before[1], after[1])};
    lines.push_back(fmt::format(
        "The diagnosis names {} as the leading effect in {} simulated repetitions of "
        "the experiment. The repetitions allow for the scatter of the readings, not "
        "for effects that Pendular does not know.",
        effects,
        d.leaders->rival_share == 0 ? "all" : percent(1 - d.leaders->rival_share) + " of"));
    const std::string trend = strongest_trend(remaining);
    lines.push_back("A misfit remains with " + effects + " in the model" + trend);
    return lines;
}

}  // namespace pendular
