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

double chi2_per_dof(double chi2, double dof) {
    return chi2 / std::max(1.0, dof);
}

/// "torque-offset (0.41 +- 0.03 mN m)", from the refit; a switch has its name alone.
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

/// "; it grows with height": of the strongest significant trend.
std::string carried_by(const Checks& checks) {
    const Check* strongest = nullptr;
    for (const Check* check : significant_checks(checks)) {
        const bool trend = check->kind == Check::Kind::trend;
        if (trend &&
            (strongest == nullptr || std::abs(check->statistic) > std::abs(strongest->statistic))) {
            strongest = check;
        }
    }
    return strongest == nullptr
               ? ""
               : fmt::format("; in {} it {} with {}", strongest->of,
                             strongest->statistic > 0 ? "grows" : "falls", strongest->covariate);
}

const Explanation* best_of(const std::vector<Explanation>& explanations) {
    const auto best = std::ranges::min_element(explanations, {}, &Explanation::chi2);
    return best == explanations.end() ? nullptr : &*best;
}

std::string cut(const Diagnosis& d, const Explanation& by) {
    const auto dof = static_cast<double>(by.fit.dof);
    return fmt::format("chi2/dof from {:.2f} to {:.2f}", chi2_per_dof(d.chi2, d.dof),
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

std::string missing_line(const Diagnosis& d, const ModelSpace& space) {
    const Explanation& best = *best_of(d.confidence_set);
    std::string line =
        fmt::format("Missing: {}. Adding {} should cut {}.", with_estimates(best, space),
                    best.chosen.size() > 1 ? "them" : "it", cut(d, best));
    if (d.confidence_set.size() > 1) {
        line = fmt::format(
            "Missing: {}, with something more that cannot be told: {} explain the readings alike. "
            "Adding {} should cut {}.",
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
            joined(names_of(best, space), "and"), cut(d, best));
    }
    return line;
}

std::string indistinguishable_line(const Diagnosis& d, const ModelSpace& space) {
    std::vector<std::string> sets;
    for (const Explanation& each : d.confidence_set) {
        sets.push_back(with_estimates(each, space));
    }
    return fmt::format(
        "Something is missing, but these readings cannot tell what: {}. Any of them "
        "cuts {} or so.",
        joined(sets, "or"), cut(d, *best_of(d.confidence_set)));
}

std::string inconclusive_line(const Diagnosis& d) {
    if (d.effects.empty() && !d.errors_assumed) {
        return "Nothing seems missing, but these readings could not show any of the known effects.";
    }
    if (d.effects.empty()) {
        return "Nothing seems missing, but the errors of the readings are assumed, not measured: "
               "that says nothing.";
    }
    return fmt::format(
        "Nothing seems missing, but {} effect{} that would matter could hide in "
        "these readings: {}.",
        d.effects.size(), d.effects.size() == 1 ? "" : "s", joined(d.effects, "and"));
}

std::string finding_line(const Finding& finding, const ModelSpace& space) {
    const Candidate& candidate = space.candidates()[finding.candidate];
    const EffectParameter& p = candidate.parameters.front();
    if (!finding.test.seen()) {
        return fmt::format("  {:<24} {:>26} {:>9} {:>9} {:>8.0f} % {:>6} {:>8}   {}",
                           candidate.name, "-", "-", "-", 100 * finding.test.share_imitated, "-", "-",
                           finding.decision);
    }
    const std::string unit = candidate.is_switch() ? "1" : p.unit;
    return fmt::format(
        "  {:<24} {:>26} {:>9.1f} {:>9} {:>8.0f} % {:>6.2f} {:>8}   {}", candidate.name,
        with_error(finding.value, finding.standard_error, unit), finding.test.predicted_reduction,
        finding.refitted_reduction ? fmt::format("{:.1f}", *finding.refitted_reduction) : "",
        100 * finding.test.share_imitated, finding.power, p_text(finding.p, ""), finding.decision);
}

/// How alike are what the effects do, after the calibrated parameters.
std::string alike_line(const Diagnosis& d) {
    if (d.effects.size() == 2) {
        return fmt::format("what they do to these readings is alike: cosine {:.3f}",
                           d.cosines(0, 1));
    }
    Eigen::MatrixXd others = d.cosines;
    others.diagonal().setOnes();
    Eigen::Index one = 0, other = 0;
    const double least = others.minCoeff(&one, &other);
    const auto name = [&](Eigen::Index k) { return d.effects[static_cast<std::size_t>(k)]; };
    return fmt::format(
        "what they do to these readings is alike: cosines from {:.3f} ({} and {}) upwards", least,
        name(other), name(one));
}

}  // namespace

std::string verdict_line(const Diagnosis& d, const ModelSpace& space, const Checks& checks) {
    switch (d.verdict) {
        case Verdict::nothing_missing:
            return fmt::format(
                "Nothing is missing that these readings could show (chi2/dof {:.2f}).",
                chi2_per_dof(d.chi2, d.dof));
        case Verdict::inconclusive:
            return inconclusive_line(d);
        case Verdict::missing:
            return missing_line(d, space);
        case Verdict::indistinguishable:
            return indistinguishable_line(d, space);
        case Verdict::suspect_measurement:
            return fmt::format(
                "Suspect measurement: no effect explains what one part of the "
                "readings would: {}.",
                joined(d.suspects, "or"));
        default:
            return fmt::format("Something is missing that no known effect explains{}.",
                               carried_by(checks));
    }
}

std::vector<std::string> diagnosis_table(const Diagnosis& d, const ModelSpace& space,
                                         const Evidence& evidence) {
    std::vector<std::string> lines = {
        fmt::format("chi2 = {:.1f} for {} degrees of freedom; lack of fit p {}; that nothing known "
                    "is missing, p {}",
                    d.chi2, d.dof, p_text(d.lack_of_fit_p), p_text(d.further_p)),
        fmt::format("  {:<24} {:>26} {:>9} {:>9} {:>10} {:>6} {:>8}   {}", "effect", "estimate",
                    "drop", "refitted", "absorbed", "power", "p", "decision")};
    for (const Finding& finding : d.scan) {
        lines.push_back(finding_line(finding, space));
    }
    lines.push_back(
        "  (drop of chi2, predicted and refitted; absorbed: by the calibrated parameters; power to "
        "see the size that matters; p of the best among so many)");
    if (std::ranges::any_of(d.scan,
                            [](const Finding& f) { return f.refitted_reduction.value_or(0) < 0; })) {
        lines.push_back(
            "  (a negative drop: chi2 counts the errors of the model's predictions too, and with "
            "that effect they are smaller, while the curve passes the readings no closer)");
    }
    for (std::size_t k = 0; k < d.suspect_p.size(); ++k) {
        if (d.suspect_p[k] < 0.05) {
            lines.push_back(fmt::format("  {} stand out (p {})", evidence.suspects[k].name,
                                        p_text(d.suspect_p[k])));
        }
    }
    return lines;
}

std::vector<std::string> advice_on(const Diagnosis& d, const ModelSpace& space,
                                   const std::string& study) {
    std::vector<std::string> lines;
    switch (d.verdict) {
        case Verdict::missing:
            for (const std::string& effect : d.effects) {
                lines.push_back(fmt::format("next: pendular add {} {}", study, effect));
            }
            break;
        case Verdict::indistinguishable:
            lines.push_back(alike_line(d));
            lines.push_back(fmt::format(
                "next: 'pendular next {}' says what to measure to tell them apart", study));
            break;
        case Verdict::inconclusive:
            for (const std::string& effect : d.effects) {
                const Finding& finding = finding_of(d, space, effect);
                const EffectParameter& p = parameter_of(space, finding);
                const std::string unit = p.unit == "1" ? "" : " " + p.unit;
                lines.push_back(
                    p.is_switch()
                        ? fmt::format("  {} would be seen in {:.0f} of 100 such studies", effect,
                                      100 * finding.power)
                        : fmt::format(
                              "  {} is seen where it is off by {:.2g}{}; {:.2g}{} would matter",
                              effect, finding.detectable, unit, p.smallest_of_interest, unit));
            }
            lines.push_back("next: more readings, replicates or conditions");
            break;
        case Verdict::suspect_measurement:
            lines.push_back("next: repeat those readings, or look at their recordings");
            break;
        case Verdict::unknown:
            if (const Explanation* best = best_of(d.tried); best && !best->suspect) {
                lines.push_back(fmt::format("the best of them, {}, cuts {}, which is not enough",
                                            with_estimates(*best, space), cut(d, *best)));
            }
            lines.push_back(
                "next: see where it fails above; an effect of your own can be written "
                "as [[effect]] in the study");
            break;
        default:
            break;
    }
    if (!d.suspects.empty() && d.verdict != Verdict::suspect_measurement) {
        lines.push_back(fmt::format(
            "{}, if off, would explain it as well: repeat {} before you trust an effect",
            joined(d.suspects, "or"), d.suspects.size() == 1 ? "them" : "those"));
    }
    if (d.errors_assumed) {
        lines.push_back(
            "errors of readings are assumed (2 %), not measured: with replicates or "
            "_sd columns the verdict would mean more");
    }
    return lines;
}

}  // namespace pendular
