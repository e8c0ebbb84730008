#include "reports/diagnosis_report.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "reports/failure_report.h"
#include "reports/joined.h"
#include "reports/tables.h"
#include "reports/with_error.h"
#include "workflow/diagnosis_json.h"

namespace pendular {
namespace {

/// Short list of names: "lid-slip, liquid-loss, torque-gain and 8 more".
std::string some_of(std::vector<std::string> names) {
    constexpr std::size_t most_named = 4;
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
std::string refitted_text(const Explanation& explanation, Eigen::Index k, const std::string& unit) {
    return with_error(explanation.fit.parameters(k), explanation.fit.standard_error(k), unit);
}

/// Names of the effects of an explanation with the refitted values, "torque-offset (torque 0.41 +-
/// 0.03 mN m)"; an effect that is a switch has no value.
std::string with_estimates(const Explanation& explanation, const ModelSpace& space) {
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

const Explanation* best_of(const std::vector<Explanation>& explanations) {
    const auto best = std::ranges::min_element(explanations, {}, &Explanation::chi2);
    return best == explanations.end() ? nullptr : &*best;
}

/// Text of the reduction of chi2/dof by an explanation: "chi2/dof from 7.79 to about 0.94".
std::string reduction(const Diagnosis& d, const Explanation& by) {
    const auto dof = static_cast<double>(by.fit.dof);
    return fmt::format("chi2/dof from {:.2f} to about {:.2f}", chi2_per_dof(d.chi2, d.dof),
                       chi2_per_dof(by.chi2, dof));
}

const Finding& finding_of(const Diagnosis& d, const ModelSpace& space, const std::string& name) {
    return *std::ranges::find_if(d.scan, [&](const Finding& finding) {
        return space.candidates()[finding.candidate].name == name;
    });
}

const EffectParameter& parameter_of(const ModelSpace& space, const Finding& finding) {
    return space.candidates()[finding.candidate].parameters.front();
}

/// Text of a share, rounded down so that it never reads 100 % below 1: "99.7 %".
std::string percent(double share) {
    return fmt::format("{:.{}f} %", std::floor(1000 * share) / 10, share < 0.99 ? 0 : 1);
}

std::string leading_line(const Diagnosis& d, const ModelSpace& space) {
    const Explanation& model = d.leaders->model;
    return fmt::format(
        "Missing: {}. Adding {} brings {}, which removes {} of the excess of chi2 over its degrees "
        "of freedom. No known effect explains the misfit that remains.",
        with_estimates(model, space), joined(names_of(model, space), "and"), reduction(d, model),
        percent(d.leaders->explained));
}

/// For each model that fits, its effects beyond those that all these models contain:
/// "torque-offset", "lid-slip with bead-loss".
std::vector<std::string> others_of(const Diagnosis& d, const ModelSpace& space) {
    std::vector<std::string> sets;
    for (const Explanation& each : d.confidence_set) {
        std::vector<std::string> names = names_of(each, space);
        std::erase_if(names, [&](const std::string& name) {
            return std::ranges::find(d.effects, name) != d.effects.end();
        });
        sets.push_back(names.empty() ? "nothing more" : joined(names, "with"));
    }
    return sets;
}

std::string missing_line(const Diagnosis& d, const ModelSpace& space) {
    if (d.leaders) return leading_line(d, space);
    const Explanation& best = *best_of(d.confidence_set);
    std::string line = fmt::format("Missing: {}. Adding {} brings {}.", with_estimates(best, space),
                                   best.chosen.size() > 1 ? "them" : "it", reduction(d, best));
    if (d.confidence_set.size() > 1) {
        line = fmt::format(
            "Missing: {}, and one further effect, {} (these readings do not tell which). Adding {} "
            "brings {}.",
            joined(d.effects, "and"), joined(others_of(d, space), "or"),
            joined(names_of(best, space), "and"), reduction(d, best));
    }
    return line;
}

std::string indistinguishable_line(const Diagnosis& d, const ModelSpace& space) {
    std::vector<std::string> sets;
    std::vector<double> left;
    for (const Explanation& each : d.confidence_set) {
        sets.push_back(with_estimates(each, space));
        left.push_back(chi2_per_dof(each.chi2, each.fit.dof));
    }
    const std::string least = fmt::format("{:.2f}", std::ranges::min(left)),
                      most = fmt::format("{:.2f}", std::ranges::max(left));
    return fmt::format(
        "Indistinguishable: something is missing, and these readings do not tell whether it is {}. "
        "Adding {} brings chi2/dof from {:.2f} to {}.",
        joined(sets, "or"), sets.size() == 2 ? "either" : "any one of them",
        chi2_per_dof(d.chi2, d.dof),
        least == most ? "about " + least : fmt::format("between {} and {}", least, most));
}

/// Names of the effects each of which would take at least half of a large misfit, though the errors
/// of the readings are known too badly to test it.
std::vector<std::string> untested_effects(const Diagnosis& d, const ModelSpace& space) {
    constexpr double large = 2, most = 0.5;
    std::vector<std::string> names;
    if (chi2_per_dof(d.chi2, d.dof) < large) return names;
    for (const Finding& finding : d.scan) {
        const double reduction =
            finding.refitted_reduction.value_or(finding.test.predicted_reduction);
        if (reduction > most * (d.chi2 - d.dof)) {
            names.push_back(space.candidates()[finding.candidate].name);
        }
    }
    return names;
}

std::string inconclusive_line(const Diagnosis& d, const ModelSpace& space) {
    if (const auto names = untested_effects(d, space); !names.empty()) {
        return fmt::format(
            "Inconclusive: chi2/dof is {:.2f} and {} could explain most of it, but too few "
            "repeated readings state the errors. Repeat more conditions with new fillings.",
            chi2_per_dof(d.chi2, d.dof),
            names.size() > 1 ? "any one of " + some_of(names) : names.front());
    }
    if (d.effects.empty() && !d.errors_assumed) {
        return "Inconclusive: no known effect improves the model, but none would show in these "
               "readings.";
    }
    if (d.effects.empty()) {
        return "Inconclusive: the errors of the readings are assumed, not measured, so that they "
               "do not tell whether an effect is missing.";
    }
    return fmt::format(
        "Inconclusive: the model describes the readings, but {} effect{} could go undetected at {} "
        "smallest size of interest: {}.",
        d.effects.size(), d.effects.size() == 1 ? "" : "s", d.effects.size() == 1 ? "its" : "their",
        some_of(d.effects));
}

/// Refitted model with one candidate alone; null where there is none that converged.
const Explanation* refit_with(const Diagnosis& d, std::size_t candidate) {
    const auto found = std::ranges::find_if(d.tried, [&](const Explanation& each) {
        return each.chosen == EffectSet{candidate} && !each.suspect && each.fit.converged;
    });
    return found == d.tried.end() ? nullptr : &*found;
}

}  // namespace

std::string power_text(const Finding& finding) {
    constexpr double significant = 0.05;
    return finding.p < significant ? "-" : fmt::format("{:.2f}", finding.power);
}

std::string estimate_of(const Diagnosis& d, const Finding& finding, const ModelSpace& space) {
    const Candidate& candidate = space.candidates()[finding.candidate];
    if (candidate.is_switch()) return "switch";
    const std::string& unit = candidate.parameters.front().unit;
    const auto first = static_cast<Eigen::Index>(d.fit.parameters.size());
    const Explanation* const refit = refit_with(d, finding.candidate);
    const EffectParameter& p = candidate.parameters.front();
    const bool determined = refit && refit->fit.parameters.size() > first &&
                            refit->fit.standard_error(first) > 0 &&
                            refit->fit.standard_error(first) < p.upper - p.lower;
    if (determined) return refitted_text(*refit, first, unit);
    return finding.standard_error > 0
               ? with_error(finding.value, finding.standard_error, unit)
               : fmt::format("{} (at its bound)", with_unit(finding.value, unit));
}

std::string chi2_change(double reduction) {
    const std::string text = fmt::format("{:+.1f}", -reduction);
    return text == "-0.0" || text == "+0.0" ? "0.0" : text;
}

namespace {

std::string finding_line(const Diagnosis& d, const Finding& finding, const ModelSpace& space) {
    const Candidate& candidate = space.candidates()[finding.candidate];
    if (!finding.test.seen()) {
        return fmt::format("  {:<24} {:>26} {:>11} {:>9} {:>8.0f} % {:>6} {:>8}   {}",
                           candidate.name, "-", "-", "-", 100 * finding.test.share_imitated, "-",
                           "-", finding.decision);
    }
    return fmt::format("  {:<24} {:>26} {:>11} {:>9} {:>8.0f} % {:>6} {:>8}   {}", candidate.name,
                       estimate_of(d, finding, space),
                       chi2_change(finding.test.predicted_reduction),
                       finding.refitted_reduction ? chi2_change(*finding.refitted_reduction) : "",
                       100 * finding.test.share_imitated, power_text(finding),
                       p_text(finding.p, ""), finding.decision);
}

/// Sentence on how alike the effects of the verdict change the readings, beyond what the calibrated
/// parameters imitate.
std::string alike_line(const Diagnosis& d) {
    if (d.effects.size() == 2) {
        return fmt::format(
            "{} and {} change these readings in a similar way (cosine {:.3f}; 1: in the same way).",
            d.effects[0], d.effects[1], d.cosines(0, 1));
    }
    Eigen::MatrixXd others = d.cosines;
    others.diagonal().setOnes();
    Eigen::Index one = 0, other = 0;
    const double least = others.minCoeff(&one, &other);
    const auto name = [&](Eigen::Index k) { return d.effects[static_cast<std::size_t>(k)]; };
    return fmt::format(
        "These effects change the readings in a similar way (least cosine {:.3f}, of {} and {}; 1: "
        "in the same way).",
        least, name(other), name(one));
}

}  // namespace

std::string verdict_line(const Diagnosis& d, const ModelSpace& space, const Checks& checks) {
    switch (d.verdict) {
        case Verdict::nothing_missing:
            return fmt::format(
                "Nothing missing: no known effect improves the model, and every effect large "
                "enough to matter would have shown in these readings (chi2/dof {:.2f}).",
                chi2_per_dof(d.chi2, d.dof));
        case Verdict::inconclusive:
            return inconclusive_line(d, space);
        case Verdict::missing:
            return missing_line(d, space);
        case Verdict::indistinguishable:
            return indistinguishable_line(d, space);
        case Verdict::suspect_measurement:
            return fmt::format(
                "Suspect measurement: an error in {} explains the residuals, and none of the known "
                "effects does.",
                joined(d.suspects, "or"));
        default:
            return fmt::format("Unknown: something is missing that no known effect explains{}",
                               strongest_trend(checks));
    }
}

std::vector<std::string> diagnosis_table(const Diagnosis& d, const ModelSpace& space) {
    std::vector<std::string> lines = {
        fmt::format("  {:<24} {:>26} {:>11} {:>9} {:>10} {:>6} {:>8}   {}", "effect", "estimate",
                    "chi2 change", "refitted", "imitated", "power", "p", "decision")};
    for (const Finding& finding : d.scan) {
        lines.push_back(finding_line(d, finding, space));
    }
    lines.push_back(
        "  (chi2 change: predicted change of chi2 when the effect is added. Refitted: that change "
        "after a refit. Imitated: share of the effect that a change of the fitted parameters can "
        "reproduce. Power: probability that these readings detect the effect at its smallest size "
        "of interest. p: probability that chance alone makes the most significant of all tests at "
        "least this significant.)");
    if (std::ranges::any_of(
            d.scan, [](const Finding& f) { return f.refitted_reduction.value_or(0) < 0; })) {
        lines.push_back(
            "  (chi2 can grow with an effect where the emulator predicts the readings with smaller "
            "errors.)");
    }
    return lines;
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

std::string discrepancy_line(double size) {
    if (size == 0) return "";
    return fmt::format(
        "If the model stays as it is, a systematic error of about {:.1f} % of its shear stress "
        "would explain the misfit. Look for the cause before you accept this error. To accept it, "
        "write discrepancy = {:.2g} into section [model] of study.toml, which enlarges the "
        "standard errors and corrects no value.",
        100 * size, size);
}

std::string suspects_line(const Diagnosis& d, const Evidence& evidence) {
    std::vector<std::pair<std::string, double>> measurements;
    for (std::size_t k = 0; k < d.suspect_p.size(); ++k) {
        if (d.suspect_p[k] < 0.05) {
            measurements.emplace_back(evidence.suspects[k].name, d.suspect_p[k]);
        }
    }
    return deviating_line(std::move(measurements));
}

std::string fit_line(const Diagnosis& d) {
    return fmt::format(
        "Fitted to all readings: chi2 = {:.1f} for {}. Test for lack of fit: p "
        "{}. "
        "Test for an improvement by a known effect: p {}. (A small p speaks against the model.)",
        d.chi2, freedom_text(d.dof), p_text(d.lack_of_fit_p), p_text(d.further_p));
}

namespace {

/// Texts of two sizes with their unit, with as many digits as tell them apart.
std::pair<std::string, std::string> sizes_apart(double one, double other, const std::string& unit) {
    constexpr int most_digits = 5;
    for (int digits = 2;; ++digits) {
        auto texts = std::pair(with_unit(one, unit, digits), with_unit(other, unit, digits));
        if (texts.first != texts.second || digits == most_digits) return texts;
    }
}

/// Line on the smallest size of an effect that the readings would show, and on the smallest size of
/// interest; for a switch, on the share of studies that would show it.
std::string unseen_line(const Finding& finding, const EffectParameter& p,
                        const std::string& effect) {
    if (p.is_switch()) {
        return fmt::format("  {} (switch): detected in {:.0f} % of repetitions of this study.",
                           effect, 100 * finding.power);
    }
    const auto [shown, matters] = sizes_apart(finding.detectable, p.smallest_of_interest, p.unit);
    const bool both_ways = p.neutral == 0 && p.lower < 0;
    const std::string what =
        p.neutral != 0 ? fmt::format("a change of the {} ({}) by", spoken_parameter(p.name),
                                     with_unit(p.neutral, p.unit))
                       : fmt::format("{}{}", spoken_parameter(p.name), both_ways ? " +-" : "");
    return fmt::format("  {}: {}{} or more would be detected; smallest size of interest {}.",
                       effect, both_ways ? what : what + " ", shown, matters);
}

}  // namespace

std::vector<std::string> unseen_table(const Diagnosis& d, const ModelSpace& space,
                                      const std::vector<std::string>& effects) {
    if (d.verdict != Verdict::inconclusive || effects.empty()) return {};
    std::vector<std::string> lines = {
        "Effects that could go undetected in these readings, each at its smallest size of "
        "interest:"};
    for (const std::string& effect : effects) {
        const Finding& finding = finding_of(d, space, effect);
        lines.push_back(unseen_line(finding, parameter_of(space, finding), effect));
    }
    return lines;
}

std::string undetectable_line(const Diagnosis& d, const ModelSpace& space) {
    if (d.verdict != Verdict::inconclusive) return "";
    std::vector<std::string> names;
    for (const Finding& finding : d.scan) {
        if (!finding.identifiable) names.push_back(space.candidates()[finding.candidate].name);
    }
    if (names.empty()) return "";
    const bool several = names.size() > 1;
    return fmt::format(
        "{} {} these readings too little to be detected at any size within the bounds of {}.",
        joined(names, "and"), several ? "change" : "changes",
        several ? "their parameters" : "its parameter");
}

std::vector<std::string> advice_on(const Diagnosis& d, const ModelSpace& space, bool proposes) {
    std::vector<std::string> lines;
    if (d.verdict == Verdict::indistinguishable) lines.push_back(alike_line(d));
    if (d.verdict == Verdict::inconclusive) {
        lines.push_back(
            "To rule out an effect, measure the effect directly or add readings at conditions "
            "where the effect is larger. The readings that 'pendular next' plans reduce the "
            "standard errors of the fitted parameters; they are not planned to rule out effects.");
    }
    if (d.verdict == Verdict::unknown) {
        if (const Explanation* best = best_of(d.tried); best && !best->suspect) {
            lines.push_back(fmt::format(
                "Of the known effects, {} {} most and {} {}, which is not enough.",
                with_estimates(*best, space), best->chosen.size() > 1 ? "explain" : "explains",
                best->chosen.size() > 1 ? "bring" : "brings", reduction(d, *best)));
        }
        if (!proposes) {
            lines.push_back("An effect of your own can be written as [[effect]] in study.toml.");
        }
    }
    if (!d.suspects.empty() && d.verdict != Verdict::suspect_measurement) {
        lines.push_back(fmt::format(
            "An error in {} would explain the residuals as well: repeat {} before you trust an "
            "effect.",
            joined(d.suspects, "or"), d.suspects.size() == 1 ? "this measurement" : "these"));
    }
    if (d.errors_assumed) {
        lines.push_back(
            "The errors of the readings are assumed to be 2 %: repeated readings or _sd columns "
            "give a firmer verdict.");
    }
    return lines;
}

std::string next_step(const Diagnosis& d, const std::string& study, bool proposes) {
    switch (d.verdict) {
        case Verdict::missing:
            return fmt::format("pendular add {} {}", study, d.effects.front());
        case Verdict::unknown:
            if (proposes) return fmt::format("pendular add {} --proposed 1", study);
            return fmt::format("pendular compare {} --all   # inspect the readings that deviate",
                               study);
        case Verdict::suspect_measurement:
            return fmt::format("repeat the suspect readings, then pendular diagnose {}", study);
        case Verdict::indistinguishable:
            return fmt::format("pendular next {}", study);
        default:
            return fmt::format("pendular compare {}", study);
    }
}

}  // namespace pendular
