#include "reports/diagnosis_report.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "reports/failure_report.h"
#include "reports/with_error.h"
#include "workflow/diagnosis_json.h"

namespace pendular {
namespace {

std::string joined(const std::vector<std::string>& words, const std::string& last) {
    std::string text;
    for (std::size_t k = 0; k < words.size(); ++k) {
        text += (k == 0 ? "" : k + 1 == words.size() ? " " + last + " " : ", ") + words[k];
    }
    return text;
}

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

/// Names of the effects of an explanation with the refitted values, "torque-offset (0.41 +- 0.03
/// mN m)"; an effect that is a switch has no value.
std::string with_estimates(const Explanation& explanation, const ModelSpace& space) {
    const auto parameters = space.with(explanation.chosen)->parameters();
    auto next = static_cast<Eigen::Index>(space.with({})->parameters().size());
    std::vector<std::string> texts;
    for (const std::size_t k : explanation.chosen) {
        const Candidate& candidate = space.candidates()[k];
        std::string values;
        for (std::size_t own = 0; own < candidate.free_parameters(); ++own, ++next) {
            values +=
                (values.empty() ? "" : ", ") +
                with_error(explanation.fit.parameters(next), explanation.fit.standard_error(next),
                           parameters[static_cast<std::size_t>(next)].unit);
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
               : fmt::format(". Measured {} {} the model as {} grows.", strongest->of,
                             strongest->statistic > 0 ? "rises above" : "falls below",
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
        "Missing: {}, and something smaller that no known effect explains. Adding {} brings {}, "
        "which removes {} of the misfit beyond the errors.",
        with_estimates(model, space), model.chosen.size() > 1 ? "them" : "it", reduction(d, model),
        percent(d.leaders->explained));
}

std::string missing_line(const Diagnosis& d, const ModelSpace& space) {
    if (d.leaders) return leading_line(d, space);
    const Explanation& best = *best_of(d.confidence_set);
    std::string line = fmt::format("Missing: {}. Adding {} brings {}.", with_estimates(best, space),
                                   best.chosen.size() > 1 ? "them" : "it", reduction(d, best));
    if (d.confidence_set.size() > 1) {
        line = fmt::format(
            "Missing: {}, and something else that these readings do not identify: {} explain them "
            "equally well. Adding {} brings {}.",
            joined(d.effects, "and"),
            joined(
                [&] {
                    std::vector<std::string> sets;
                    for (const auto& each : d.confidence_set) {
                        sets.push_back(joined(names_of(each, space), "with"));
                    }
                    return sets;
                }(),
                "or"),
            joined(names_of(best, space), "and"), reduction(d, best));
    }
    return line;
}

std::string indistinguishable_line(const Diagnosis& d, const ModelSpace& space) {
    std::vector<std::string> sets;
    for (const Explanation& each : d.confidence_set) {
        sets.push_back(with_estimates(each, space));
    }
    return fmt::format(
        "Something is missing, and these readings do not tell which effect: {}. Adding {} of them "
        "brings {}.",
        joined(sets, "or"), sets.size() == 2 ? "either" : "any one",
        reduction(d, *best_of(d.confidence_set)));
}

std::string inconclusive_line(const Diagnosis& d) {
    if (d.effects.empty() && !d.errors_assumed) {
        return "No effect is missing as far as these readings show, but none of the known effects "
               "would show in them.";
    }
    if (d.effects.empty()) {
        return "The readings do not tell whether an effect is missing: their errors are assumed, "
               "not "
               "measured.";
    }
    return fmt::format(
        "No effect is missing as far as these readings show, but {} effect{} could be large enough "
        "to matter without showing in them: {}.",
        d.effects.size(), d.effects.size() == 1 ? "" : "s", some_of(d.effects));
}

/// Text of an estimate with its error; an estimate without error was fitted at a bound of the
/// parameter.
std::string estimate_of(const Finding& finding, const std::string& unit) {
    return finding.standard_error > 0
               ? with_error(finding.value, finding.standard_error, unit)
               : fmt::format("{} (at its bound)", with_unit(finding.value, unit));
}

std::string finding_line(const Finding& finding, const ModelSpace& space) {
    const Candidate& candidate = space.candidates()[finding.candidate];
    const EffectParameter& p = candidate.parameters.front();
    if (!finding.test.seen()) {
        return fmt::format("  {:<24} {:>26} {:>9} {:>9} {:>8.0f} % {:>6} {:>8}   {}",
                           candidate.name, "-", "-", "-", 100 * finding.test.share_imitated, "-",
                           "-", finding.decision);
    }
    const std::string unit = candidate.is_switch() ? "1" : p.unit;
    return fmt::format(
        "  {:<24} {:>26} {:>9.1f} {:>9} {:>8.0f} % {:>6.2f} {:>8}   {}", candidate.name,
        estimate_of(finding, unit), finding.test.predicted_reduction,
        finding.refitted_reduction ? fmt::format("{:.1f}", *finding.refitted_reduction) : "",
        100 * finding.test.share_imitated, finding.power, p_text(finding.p, ""), finding.decision);
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
                "No physical effect is missing that these readings could show (chi2/dof {:.2f}).",
                chi2_per_dof(d.chi2, d.dof));
        case Verdict::inconclusive:
            return inconclusive_line(d);
        case Verdict::missing:
            return missing_line(d, space);
        case Verdict::indistinguishable:
            return indistinguishable_line(d, space);
        case Verdict::suspect_measurement:
            return fmt::format(
                "A measurement is suspect: an error in {} explains the residuals, and no physical "
                "effect does.",
                joined(d.suspects, "or"));
        default:
            return fmt::format("Something is missing that no known effect explains{}",
                               strongest_trend(checks));
    }
}

std::vector<std::string> diagnosis_table(const Diagnosis& d, const ModelSpace& space) {
    std::vector<std::string> lines = {
        fmt::format("  {:<24} {:>26} {:>9} {:>9} {:>10} {:>6} {:>8}   {}", "effect", "estimate",
                    "chi2 falls", "refitted", "imitated", "power", "p", "decision")};
    for (const Finding& finding : d.scan) {
        lines.push_back(finding_line(finding, space));
    }
    lines.push_back(
        "  (chi2 falls: by how much chi2 would fall with the effect in the model; refitted: by how "
        "much it falls in a fit with the effect; imitated: share of the effect that other values "
        "of the calibrated parameters imitate; power: probability that these readings show an "
        "effect just large enough to matter; p: probability that chance makes any tested effect "
        "look as good)");
    if (std::ranges::any_of(
            d.scan, [](const Finding& f) { return f.refitted_reduction.value_or(0) < 0; })) {
        lines.push_back(
            "  (chi2 may grow with an effect: the model's own errors, which chi2 includes, are "
            "then "
            "smaller)");
    }
    return lines;
}

std::vector<std::string> incomplete_lines(const Diagnosis& d, const std::array<double, 2>& before,
                                          const std::array<double, 2>& after,
                                          const Checks& remaining) {
    if (!d.leaders) return {};
    const std::string effects = joined(d.effects, "and");
    std::vector<std::string> lines = {fmt::format(
        "With {}, the RMS error of shear stress goes from {:.2f} % to {:.2f} %, that of solid "
        "fraction from {:.2f} % to {:.2f} %.",
        effects, before[0], after[0], before[1], after[1])};
    lines.push_back(fmt::format(
        "In {:.1f} of 100 simulated repetitions of the experiment, the best model would lack {}.",
        100 * d.leaders->rival_share, joined(d.effects, "or")));
    const std::string trend = strongest_trend(remaining);
    lines.push_back("With " + effects + " in the model, a misfit remains" + trend);
    return lines;
}

std::string discrepancy_line(double size) {
    if (size == 0) return "";
    return fmt::format(
        "A smooth error of the model of about {:.1f} % of the shear stress would account for what "
        "remains. If the model may be wrong by that much, write discrepancy = {:.2g} in [model].",
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
        "Fitted to all readings, the present model has chi2 = {:.1f} for {} degrees of freedom "
        "(test for lack of fit: p {}; test for a missing known effect: p {}).",
        d.chi2, d.dof, p_text(d.lack_of_fit_p), p_text(d.further_p));
}

namespace {

/// Name of a parameter with its article: "a force", "an angle", "a surface tension".
std::string with_article(std::string name) {
    std::ranges::replace(name, '_', ' ');
    const bool vowel = std::string("aeiou").find(name.front()) != std::string::npos;
    return (vowel ? "an " : "a ") + name;
}

/// Line on the size from which the readings would show an effect, and the size from which it
/// matters; for a switch, on the share of studies that would show it.
std::string unseen_line(const Finding& finding, const EffectParameter& p,
                        const std::string& effect) {
    if (p.is_switch()) {
        return fmt::format("  {}: {:.0f} of 100 such studies would show it.", effect,
                           100 * finding.power);
    }
    const std::string name = with_article(p.name);
    const std::string shown = with_unit(finding.detectable, p.unit),
                      matters = with_unit(p.smallest_of_interest, p.unit);
    if (p.neutral != 0) {
        return fmt::format(
            "  {}: the readings would show {} that differs from {} by {} or more; a difference of "
            "{} or more would matter.",
            effect, name, with_unit(p.neutral, p.unit), shown, matters);
    }
    return fmt::format("  {}: the readings would show {} of {} or more{}; {} or more would matter.",
                       effect, name, shown, p.lower < 0 ? ", positive or negative" : "", matters);
}

}  // namespace

std::vector<std::string> unseen_table(const Diagnosis& d, const ModelSpace& space) {
    if (d.verdict != Verdict::inconclusive || d.effects.empty()) return {};
    std::vector<std::string> lines = {
        "Effects that could matter without showing in these readings:"};
    for (const std::string& effect : d.effects) {
        const Finding& finding = finding_of(d, space, effect);
        lines.push_back(unseen_line(finding, parameter_of(space, finding), effect));
    }
    return lines;
}

std::vector<std::string> advice_on(const Diagnosis& d, const ModelSpace& space, bool proposes) {
    std::vector<std::string> lines;
    if (d.verdict == Verdict::indistinguishable) lines.push_back(alike_line(d));
    if (d.verdict == Verdict::inconclusive) {
        lines.push_back(
            "More readings, replicates or conditions would tell whether one of these effects is "
            "missing.");
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
            "The errors of the readings are assumed (2 %): replicates or _sd columns make the "
            "verdict firmer.");
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
        default:
            return fmt::format("pendular next {}", study);
    }
}

}  // namespace pendular
