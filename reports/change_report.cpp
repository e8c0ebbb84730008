#include "reports/change_report.h"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <utility>

#include "reports/with_error.h"

namespace pendular {
namespace {

constexpr std::array<const char*, 2> observables = {"shear stress", "solid fraction"};

std::string number(double value) {
    return std::abs(value) < 1000 ? fmt::format("{:.3g}", value) : fmt::format("{:.0f}", value);
}

std::string estimate(const LadderParameter* parameter) {
    return parameter ? with_error(parameter->value, parameter->standard_error) : "-";
}

/// Change of a parameter over its standard error before the change [1].
double drift(const LadderParameter& before, const LadderParameter& after) {
    return (after.value - before.value) / before.standard_error;
}

std::string parameter_line(const std::string& name, const std::string& unit,
                           const LadderParameter* before, const LadderParameter* after) {
    const std::string moved = before && after
                                  ? fmt::format("{:+.1f} standard errors", drift(*before, *after))
                              : after ? "new"
                                      : "removed";
    return fmt::format("  {:<36} {:>24} {:>24}   {}",
                       unit == "1" ? name : fmt::format("{} [{}]", name, unit), estimate(before),
                       estimate(after), moved);
}

/// Names of the observables whose RMS error at conditions left out of the fit rose by more than
/// 5 %: "shear stress", "shear stress and solid fraction"; empty for none.
std::string left_out_rose(const LadderStep& before, const LadderStep& after) {
    std::string which;
    if (!before.left_out_percent || !after.left_out_percent) {
        return which;
    }
    for (std::size_t o = 0; o < observables.size(); ++o) {
        if ((*after.left_out_percent)[o] > 1.05 * (*before.left_out_percent)[o]) {
            which += (which.empty() ? "" : " and ") + std::string(observables[o]);
        }
    }
    return which;
}

std::string advice_on_added(const std::string& effect, const LadderStep& before,
                            const LadderStep& after, const std::string& study) {
    const std::string undo = fmt::format(
        "remove it again with 'pendular drop {0} {1}', or find what is missing with 'pendular "
        "diagnose {0}'",
        study, effect);
    if (after.chi2 >= before.chi2) {
        return fmt::format(
            "The error did not fall (chi2 {} -> {}): {} is not the missing effect; {}.",
            number(before.chi2), number(after.chi2), effect, undo);
    }
    if (fell_by_chance(before, after)) {
        return fmt::format(
            "The error fell by no more than chance (chi2 {} -> {} with {} more parameter{}): the "
            "readings do not need {}; {}.",
            number(before.chi2), number(after.chi2), before.dof - after.dof,
            before.dof - after.dof == 1 ? "" : "s", effect, undo);
    }
    if (const std::string which = left_out_rose(before, after); !which.empty()) {
        return fmt::format(
            "The fit improved, but the error of {} rose at conditions left out of the fit: {} "
            "describes only the fitted readings. Measure at further conditions before you trust "
            "it; {}.",
            which, effect, undo);
    }
    return "";
}

std::string advice_on_dropped(const std::string& effect, const LadderStep& before,
                              const LadderStep& after, const std::string& study) {
    if (after.chi2 <= before.chi2) {
        return fmt::format("The error did not rise without {}: the model does not need it.",
                           effect);
    }
    if (fell_by_chance(after, before)) {
        return fmt::format(
            "Without {} the error rose by no more than chance (chi2 {} -> {}): the readings do not "
            "need it.",
            effect, number(before.chi2), number(after.chi2));
    }
    return fmt::format(
        "Without {0} the fit is worse (chi2 {2}, with it {1}): the model needs it, or a similar "
        "effect. 'pendular add {3} {0}' adds it again.",
        effect, number(before.chi2), number(after.chi2), study);
}

}  // namespace

std::string verdict_of(const StudyChange& change, const LadderStep& before,
                       const LadderStep& after) {
    const std::string from = number(before.chi2_per_dof()), to = number(after.chi2_per_dof());
    const double ratio = after.chi2_per_dof() / before.chi2_per_dof();
    const std::string moved = from == to  ? "stays at " + to
                              : ratio < 1 ? fmt::format("falls from {} to {}", from, to)
                                          : fmt::format("rises from {} to {}", from, to);
    return fmt::format(
        "{} {}: chi2/dof {}, the RMS error of shear stress goes from {:.2f} % to {:.2f} %.",
        change.effect, change.change == Action::add ? "added" : "dropped", moved,
        before.rms_percent[0], after.rms_percent[0]);
}

std::vector<std::string> error_changes(const LadderStep& before, const LadderStep& after) {
    const auto row = [](const std::string& name, double first, double second) {
        return fmt::format("  {:<52} {:>12.3f} {:>12.3f}", name, first, second);
    };
    std::vector<std::string> lines = {
        fmt::format("  {:<52} {:>12} {:>12}", "error", "before", "after"),
        row("chi2/dof [1]", before.chi2_per_dof(), after.chi2_per_dof())};
    for (std::size_t o = 0; o < observables.size(); ++o) {
        lines.push_back(row(fmt::format("RMS error of {} [%]", observables[o]),
                            before.rms_percent[o], after.rms_percent[o]));
    }
    if (before.left_out_percent && after.left_out_percent) {
        for (std::size_t o = 0; o < observables.size(); ++o) {
            lines.push_back(
                row(fmt::format("RMS error of {}, left-out conditions [%]", observables[o]),
                    (*before.left_out_percent)[o], (*after.left_out_percent)[o]));
        }
    }
    return lines;
}

std::vector<std::string> parameter_changes(const LadderStep& before, const LadderStep& after) {
    std::vector<std::string> lines = {
        fmt::format("  {:<36} {:>24} {:>24}   {}", "parameter", "before", "after", "change")};
    for (const LadderParameter& p : before.parameters) {
        lines.push_back(parameter_line(p.name, p.unit, &p, after.find(p.name)));
    }
    for (const LadderParameter& p : after.parameters) {
        if (!before.find(p.name)) {
            lines.push_back(parameter_line(p.name, p.unit, nullptr, &p));
        }
    }
    return lines;
}

std::vector<std::string> advice_on(const StudyChange& change, const LadderStep& before,
                                   const LadderStep& after, const std::string& study) {
    std::vector<std::string> lines;
    const auto advise = change.change == Action::add ? advice_on_added : advice_on_dropped;
    if (std::string advice = advise(change.effect, before, after, study); !advice.empty()) {
        lines.push_back(std::move(advice));
    }
    for (const LadderParameter& p : before.parameters) {
        const LadderParameter* const later = after.find(p.name);
        if (later && std::abs(drift(p, *later)) > 3) {
            lines.push_back(
                fmt::format("The fitted {0} changed by {1:.1f} standard errors: without {2} in the "
                            "model, the fit "
                            "shifts {0} to compensate.",
                            p.name, std::abs(drift(p, *later)), change.effect));
        }
    }
    return lines;
}

}  // namespace pendular
