#include "reports/impact_report.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "reports/with_error.h"

namespace pendular {
namespace {

constexpr std::size_t most_lines = 2;
/// Smallest shift worth a sentence, in standard errors of the parameter [1].
constexpr double worth_a_line = 0.1;

bool named(const Impact& impact, const Diagnosis& d) {
    const auto& names = impact.measurement ? d.suspects : d.effects;
    return std::ranges::find(names, impact.name) != names.end();
}

/// Whether a verdict states that an effect or an error is there, with an estimate.
bool estimated(Verdict verdict) {
    return verdict == Verdict::missing || verdict == Verdict::indistinguishable ||
           verdict == Verdict::suspect_measurement;
}

std::string percent_text(double share) {
    return fmt::format("{:.2g} %", 100 * share);
}

/// Text of a size with its unit: "0.05", "0.41 mN m", "1 %".
std::string size_text(const Impact& impact, double size) {
    // Two digits would hide the difference between a factor and 1.
    if (impact.neutral != 0 && impact.unit == "1") return fmt::format("{:.4g}", size);
    if (!impact.measurement) return with_unit(size, impact.unit);
    return impact.quantity.empty() ? fmt::format("{:.2g} standard errors", size)
                                   : percent_text(size);
}

/// Beginning of a sentence that states an error of measurement: "If the shear stress in the
/// readings of dry_1.csv were 1 % too high".
std::string if_wrong(const Impact& impact, double size) {
    return fmt::format("If the {}{} were {} too {}",
                       impact.quantity.empty() ? "" : impact.quantity + " in ",
                       impact.quantity.empty() ? impact.name.substr(4) : impact.name,
                       size_text(impact, std::abs(size)), size < 0 ? "low" : "high");
}

std::string condition_of(const Impact& impact, const Shift& shift, bool at_estimate) {
    if (impact.measurement) return if_wrong(impact, shift.size);
    if (impact.quantity == "on") return fmt::format("With {}", impact.name);
    return at_estimate ? fmt::format("With {} at its estimated size", impact.name)
                       : fmt::format("If {} of {} were present", impact.name,
                                     size_text(impact, shift.size));
}

/// Sentence on the shift of the first parameter at one size; empty where the shift is negligible.
std::string line_of(const ImpactTable& table, const Impact& impact, bool at_estimate) {
    const Shift& shift = at_estimate ? impact.at_estimate : impact.at_interest;
    const double by = shift.best()(0), error = table.errors(0);
    if (!(std::abs(by) >= worth_a_line * error)) return "";
    const int digits = std::clamp(1 - static_cast<int>(std::floor(std::log10(error))), 0, 12);
    return fmt::format("{}, the fitted {} would be {:.{}f} {} ({:.{}f} instead of {:.{}f}).",
                       condition_of(impact, shift, at_estimate), table.parameters.front().name,
                       std::abs(by), digits, by < 0 ? "lower" : "higher", table.fitted(0) + by,
                       digits, table.fitted(0), digits);
}

std::string shift_text(double by, double error) {
    const int digits = std::clamp(1 - static_cast<int>(std::floor(std::log10(error))), 0, 12);
    return fmt::format("{:+.{}f}", by, digits);
}

std::string group_name(const GroupImpact& sum) {
    return "group " + sum.group;
}

/// Number of characters of the longest name in the table.
std::size_t width_of(const ImpactTable& table) {
    std::size_t width = 24;
    for (const Impact& impact : table.impacts) {
        width = std::max(width, impact_name(impact).size());
    }
    for (const GroupImpact& sum : table.groups) {
        width = std::max(width, group_name(sum).size());
    }
    return width;
}

std::string row_of(const ImpactTable& table, const Impact& impact, std::size_t width) {
    const double error = table.errors(0);
    const auto both = [&](const Shift& shift) {
        return fmt::format("{:>14} {:>9} {:>9}", size_text(impact, shift.size),
                           shift_text(shift.linear(0), error),
                           shift.refitted.size() > 0 ? shift_text(shift.refitted(0), error) : "");
    };
    return fmt::format("  {:<{}} {} {} {:>9} {:>9} {:>7}", impact_name(impact), width,
                       both(impact.at_interest), both(impact.at_estimate),
                       shift_text(impact.up()(0), error), shift_text(impact.down()(0), error),
                       std::isfinite(impact.pull()) ? fmt::format("{:.1f}", impact.pull()) : "-");
}

}  // namespace

std::string impact_name(const Impact& impact) {
    return impact.measurement && !impact.quantity.empty()
               ? fmt::format("{}, {}", impact.quantity, impact.name)
               : impact.name;
}

std::vector<std::string> impact_lines(const ImpactTable& table, const Diagnosis& d) {
    std::vector<std::string> lines;
    if (d.verdict == Verdict::unknown) return lines;  // the verdict names no effect to add
    const bool at_estimate = estimated(d.verdict);
    for (const Impact& impact : table.impacts) {
        if (lines.size() == most_lines) break;
        const bool wanted = at_estimate ? named(impact, d) : !impact.measurement;
        if (!wanted) continue;
        if (std::string line = line_of(table, impact, at_estimate); !line.empty()) {
            lines.push_back(std::move(line));
        }
    }
    return lines;
}

std::vector<std::string> impact_table(const ImpactTable& table) {
    if (table.impacts.empty()) return {};
    const std::string& parameter = table.parameters.front().name;
    const std::size_t width = width_of(table);
    std::vector<std::string> lines = {
        fmt::format("  {:<{}} {:>14} {:>9} {:>9} {:>14} {:>9} {:>9} {:>9} {:>9} {:>7}",
                    "shift of " + parameter + " by", width, "smallest size", "linear", "refitted",
                    "estimate", "linear", "refitted", "+1 error", "-1 error", "pull")};
    for (const Impact& impact : table.impacts) {
        lines.push_back(row_of(table, impact, width));
    }
    for (const GroupImpact& sum : table.groups) {
        const auto text = [&](const Eigen::VectorXd& by) {
            return shift_text(by(0), table.errors(0)).substr(1);
        };
        lines.push_back(fmt::format("  {:<{}} {:>14} {:>9} {:>9} {:>14} {:>9} {:>9} {:>9}",
                                    group_name(sum), width, "", text(sum.at_interest), "", "",
                                    text(sum.at_estimate), "", text(sum.by_error)));
    }
    lines.push_back(fmt::format(
        "  (shift of the fitted {} if the model took the effect or error of measurement into "
        "account; smallest size: the smallest that matters; estimate: the estimated size; linear: "
        "by covariance; refitted: the other parameters fitted again; +1 error, -1 error: further "
        "shift one standard error above and below the estimate; pull: distance of the estimate "
        "from no effect, in standard errors; groups: root of the sum of squares)",
        parameter));
    return lines;
}

}  // namespace pendular
