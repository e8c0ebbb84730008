#include "reports/other_causes.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "reports/tables.h"
#include "reports/with_error.h"
#include "reports/words.h"

namespace pendular {

std::string own_condition(const std::vector<Reading>& readings, const SuspectMeasurement& suspect) {
    struct Property {
        const char* name;
        double (*of)(const Condition&);
        const char* unit;
    };
    static const Property properties[] = {
        {"liquid content", [](const Condition& c) { return c.liquid_content; }, "1"},
        {"normal stress", [](const Condition& c) { return c.normal_stress; }, "Pa"},
        {"mass of beads (volume)", [](const Condition& c) { return c.bead_volume.value_or(0); },
         "m^3"}};
    std::vector<std::string> texts;
    for (const Property& property : properties) {
        constexpr double equal = 0.02;  // as replicates
        std::set<double> in, out;
        for (std::size_t k = 0; k < readings.size(); ++k) {
            const auto rows = suspect.columns.middleRows<2>(2 * static_cast<Eigen::Index>(k));
            (rows.isZero(0) ? out : in).insert(property.of(readings[k].condition));
        }
        const auto as_in = [&](double value) {
            return std::abs(value - *in.begin()) <= equal * std::abs(*in.begin());
        };
        if (!in.empty() && !out.empty() && std::ranges::all_of(in, as_in) &&
            std::ranges::none_of(out, as_in)) {
            texts.push_back(
                fmt::format("{} {}", property.name, with_unit(*in.begin(), property.unit)));
        }
    }
    return joined(texts, "and");
}

std::string SuspectError::text() const {
    std::vector<std::string> texts;
    for (std::size_t k = 0; k < suspect.quantities.size(); ++k) {
        const auto o = static_cast<Eigen::Index>(k);
        if (!concerns(o)) continue;
        texts.push_back(fmt::format("{} {} % too {}", suspect.quantities[k],
                                    with_error(100 * std::abs(size(o)), 100 * standard_error(o)),
                                    size(o) < 0 ? "low" : "high"));
    }
    return joined(texts, "and");
}

std::vector<SuspectError> suspect_errors(const StudyDiagnosis& study) {
    // Largest share of a measured value that may be error: at 1, the true value would be 0.
    constexpr double largest_share = 0.99;
    const Diagnosis& d = study.diagnosis;
    std::vector<SuspectError> errors;
    if (d.verdict != Verdict::suspect_measurement || d.overruled) return errors;
    for (const FittedModel& each : d.confidence_set) {
        if (!each.suspect) continue;
        SuspectError error{.suspect = study.evidence.suspects[*each.suspect], .model = each};
        const auto quantities = static_cast<Eigen::Index>(error.suspect.quantities.size());
        const Eigen::Index first = each.fit.parameters.size() - error.suspect.columns.cols();
        for (Eigen::Index k = 0; k < quantities; ++k) {
            // The fit states the error relative to the measured value, a: measured (1 - a) = true.
            const double a = std::min(each.fit.parameters(first + k), largest_share);
            error.size(k) = a / (1 - a);
            error.standard_error(k) = each.fit.standard_error(first + k) / ((1 - a) * (1 - a));
        }
        errors.push_back(error);
    }
    return errors;
}

std::vector<std::string> suspect_lines(const StudyDiagnosis& study) {
    const auto per_dof = [](double chi2, int dof) { return chi2 / std::max(1, dof); };
    std::vector<std::string> lines;
    for (const SuspectError& error : suspect_errors(study)) {
        const std::string size = error.text();
        std::string line =
            fmt::format("With the error of {} corrected{}, chi2/dof falls from {:.2f} to {:.2f}.",
                        error.suspect.name, size.empty() ? "" : " (" + size + ")",
                        per_dof(study.diagnosis.base.fit.chi2, study.diagnosis.dof),
                        per_dof(error.model.fit.chi2, error.model.fit.dof));
        if (const std::string own = own_condition(study.readings, error.suspect); !own.empty()) {
            line += fmt::format(
                " Only these readings have {}: an effect that Pendular does not know and that "
                "acts only there would look the same.",
                own);
        }
        lines.push_back(std::move(line));
    }
    return lines;
}

std::string repetition_of(const SuspectError& error, const std::vector<Reading>& readings) {
    const std::string& group = error.suspect.group;
    if (group == "direct measurements") {
        return fmt::format("Repeat {}, and write the new value into [[direct]] of study.toml.",
                           error.suspect.name);
    }
    std::set<std::string> conditions;
    std::vector<std::string> names;
    for (std::size_t k = 0; k < readings.size(); ++k) {
        const auto rows = error.suspect.columns.middleRows<2>(2 * static_cast<Eigen::Index>(k));
        if (rows.isZero(0)) continue;
        conditions.insert(condition_text(readings[k].condition));
        names.push_back(place_of(readings[k]));
    }
    std::string text = fmt::format("Repeat {} with a new filling", error.suspect.name);
    constexpr std::size_t most_named = 4;  // in one sentence
    if (conditions.size() > 1) {
        text += fmt::format(" ({} readings at {} conditions)", names.size(), conditions.size());
    } else if (names.size() <= most_named) {
        text += fmt::format(" ({})", fmt::join(names, ", "));
    }
    if (const std::string size = error.text(); !size.empty()) {
        text += fmt::format(
            ". If the old readings are wrong ({}), the new ones differ by that much", size);
    }
    return text + (group == "conditions"
                       ? ". If they do, leave the old ones out of their file."
                       : ". If they do, list the new files in study.toml in place of the old.");
}

namespace {

/// Rank correlation from which on the contents count as measured in order [1].
constexpr double in_order = 0.9;

}  // namespace

double order_of_contents(const std::vector<Reading>& readings) {
    double with = 0, against = 0;
    for (const Reading& first : readings) {
        for (const Reading& second : readings) {
            if (first.condition.dry() || second.condition.dry()) continue;
            const double product =
                (second.condition.time - first.condition.time) *
                (second.condition.liquid_content - first.condition.liquid_content);
            (product > 0 ? with : against) += product != 0;
        }
    }
    return with + against > 0 ? (with - against) / (with + against) : 0;
}

std::string order_line(const StudyDiagnosis& diagnosis, const EffectCatalogue& catalogue) {
    const auto& named = diagnosis.diagnosis.effects;
    const auto changing = std::ranges::find_if(named, [&](const std::string& name) {
        const Effect& effect = catalogue.find(name);
        return effect.touches != Touches::dry &&
               std::ranges::find(effect.acts_through, "time") != effect.acts_through.end();
    });
    const Verdict verdict = diagnosis.diagnosis.verdict;
    if (verdict != Verdict::missing && verdict != Verdict::indistinguishable) return "";
    const double order = order_of_contents(diagnosis.readings);
    if (changing == named.end() || std::abs(order) < in_order) return "";
    return fmt::format(
        "{} changes with time, and the liquid contents were measured in {} order: an unknown "
        "change with the liquid content would look the same. Repeat the first liquid content at "
        "the end, then diagnose again.",
        *changing, order > 0 ? "increasing" : "decreasing");
}

std::string rivals_line(const std::vector<FittedModel>& rivals, double chi2,
                        const EffectCatalogue& catalogue) {
    std::vector<std::string> models;
    std::set<std::string> effects;
    for (const FittedModel& rival : rivals) {
        models.push_back(fmt::format("{} (chi2 {:.2f})", rival.name, rival.fit.chi2));
        effects.insert(rival.in_place_of);
        effects.insert(rival.effects.begin(), rival.effects.end());
    }
    if (models.empty()) return "";
    const std::string methods = direct_methods({effects.begin(), effects.end()}, catalogue);
    return fmt::format(
        "The readings do not rule out these other models: {}. The chi2 of the present model is "
        "{:.2f}.{}",
        fmt::join(models, "; "), chi2,
        methods.empty() ? "" : fmt::format(" Effects that can be measured directly: {}.", methods));
}

std::string direct_methods(const std::vector<std::string>& effects,
                           const EffectCatalogue& catalogue) {
    std::vector<std::string> methods;
    for (const std::string& name : effects) {
        const std::string& how = catalogue.find(name).directly;
        if (!how.empty()) methods.push_back(fmt::format("{} by {}", name, how));
    }
    return fmt::format("{}", fmt::join(methods, "; "));
}

}  // namespace pendular
