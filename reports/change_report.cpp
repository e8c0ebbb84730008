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

std::string percents(double before, double after) {
    return fmt::format("{} % -> {} %", number(before), number(after));
}

std::string left_out_text(const LadderStep& before, const LadderStep& after) {
    if (!before.left_out_percent || !after.left_out_percent) {
        return "";
    }
    const auto &a = *before.left_out_percent, &b = *after.left_out_percent;
    return fmt::format("; left-out conditions {} and {}", percents(a[0], b[0]),
                       percents(a[1], b[1]));
}

std::string estimate(const LadderParameter* parameter) {
    return parameter ? with_error(parameter->value, parameter->standard_error) : "-";
}

/// Drift in the errors that the parameter had [1].
double drift(const LadderParameter& before, const LadderParameter& after) {
    return (after.value - before.value) / before.standard_error;
}

std::string parameter_line(const std::string& name, const std::string& unit,
                           const LadderParameter* before, const LadderParameter* after) {
    const std::string moved = before && after
                                  ? fmt::format("{:+.1f} standard errors", drift(*before, *after))
                              : after ? "new"
                                      : "gone";
    return fmt::format("  {:<36} {:>24} {:>24}   {}",
                       unit == "1" ? name : fmt::format("{} [{}]", name, unit), estimate(before),
                       estimate(after), moved);
}

/// "shear stress", "shear stress and solid fraction": those whose left-out error rose by more than
/// a twentieth.
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

std::string advice_on_added(const std::string& effect, const LadderStep& before, const LadderStep& after,
                            const std::string& study) {
    const std::string undo = fmt::format(
        "'pendular drop {0} {1}' takes it out again, 'pendular diagnose {0}' says what may be "
        "missing",
        study, effect);
    if (after.chi2 >= before.chi2) {
        return fmt::format("the error did not fall: chi2 {} -> {}; {} is not what is missing: {}",
                           number(before.chi2), number(after.chi2), effect, undo);
    }
    if (fell_by_chance(before, after)) {
        return fmt::format(
            "the error fell by no more than chance: chi2 {} -> {} with {} more parameters; the "
            "readings do not ask for {}: {}",
            number(before.chi2), number(after.chi2), before.dof - after.dof, effect, undo);
    }
    if (const std::string which = left_out_rose(before, after); !which.empty()) {
        return fmt::format(
            "chi2 fell, but of conditions left out of the fit the error of {} rose: {} serves the "
            "readings it was fitted to and not others; measure at further conditions before you "
            "trust it, or drop it: {}",
            which, effect, undo);
    }
    return "";
}

std::string advice_on_dropped(const std::string& effect, const LadderStep& before, const LadderStep& after,
                              const std::string& study) {
    if (after.chi2 <= before.chi2) {
        return fmt::format("the error did not rise without {}: it was not needed", effect);
    }
    if (fell_by_chance(after, before)) {
        return fmt::format(
            "without {} the error rose by no more than chance: chi2 {} -> {}; the readings do not "
            "ask for it",
            effect, number(before.chi2), number(after.chi2));
    }
    return fmt::format(
        "the error rose without {0}: chi2 {1} -> {2}; the readings ask for it, or for something "
        "like it: 'pendular add {3} {0}' puts it back",
        effect, number(before.chi2), number(after.chi2), study);
}

}  // namespace

std::string verdict_of(const StudyChange& change, const LadderStep& before, const LadderStep& after) {
    return fmt::format(
        "{} {}: chi2/dof {} -> {}, RMS error of shear stress {}, of solid fraction {}{}",
        change.effect, change.change == Action::add ? "added" : "dropped",
        number(before.chi2_per_dof()), number(after.chi2_per_dof()),
        percents(before.rms_percent[0], after.rms_percent[0]),
        percents(before.rms_percent[1], after.rms_percent[1]), left_out_text(before, after));
}

std::vector<std::string> parameter_changes(const LadderStep& before, const LadderStep& after) {
    std::vector<std::string> lines = {
        fmt::format("  {:<36} {:>24} {:>24}   {}", "parameter", "before", "after", "drift")};
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

std::vector<std::string> advice_on(const StudyChange& change, const LadderStep& before, const LadderStep& after,
                                   const std::string& study) {
    std::vector<std::string> lines;
    const auto advise = change.change == Action::add ? advice_on_added : advice_on_dropped;
    if (std::string advice = advise(change.effect, before, after, study); !advice.empty()) {
        lines.push_back(std::move(advice));
    }
    for (const LadderParameter& p : before.parameters) {
        const LadderParameter* const later = after.find(p.name);
        if (later && std::abs(drift(p, *later)) > 3) {
            lines.push_back(
                fmt::format("{} moved by {:.1f} times the error it had: one of the two models took "
                            "for {} what is something else",
                            p.name, std::abs(drift(p, *later)), p.name));
        }
    }
    return lines;
}

}  // namespace pendular
