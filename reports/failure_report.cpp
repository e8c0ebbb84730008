#include "reports/failure_report.h"

#include <fmt/format.h>

#include <algorithm>

namespace pendular {
namespace {

std::string sentence(const Check& check) {
    const std::string p = fmt::format("(p {})", p_text(check.p));
    switch (check.kind) {
        case Check::Kind::lack_of_fit:
            return fmt::format("the conditions' means are off the model {}", p);
        case Check::Kind::trend:
            return fmt::format("{}: measured over modelled {} with {} {}", check.of,
                               check.statistic > 0 ? "grows" : "falls", check.covariate, p);
        case Check::Kind::score:
            return fmt::format("{} would be another at one end of {} than at the other {}",
                               check.of, check.covariate, p);
        case Check::Kind::runs:
            return fmt::format("{}: neighbouring readings lie on the same side of the model {}",
                               check.of, p);
        default:
            return fmt::format("readings at neighbouring conditions are off alike ({}) {}",
                               check.covariate, p);
    }
}

}  // namespace

std::string p_text(double p, const char* equals) {
    return p < 1e-3 ? "< 0.001" : fmt::format("{}{:.2g}", equals, p);
}

std::vector<const Check*> significant_checks(const Checks& checks) {
    constexpr double significant = 0.05;
    std::vector<const Check*> result;
    for (const Check& check : checks.all) {
        if (check.p < significant) result.push_back(&check);
    }
    std::ranges::stable_sort(result, {}, &Check::p);
    return result;
}

std::vector<std::string> checks_table(const Checks& checks) {
    std::vector<std::string> lines;
    for (const Check* check : significant_checks(checks)) {
        lines.push_back("  " + sentence(*check));
    }
    lines.insert(lines.begin(), fmt::format("where it fails, {} checks, p {} for all together{}",
                                            checks.all.size(), p_text(checks.p),
                                            lines.empty() ? ": none is significant" : ":"));
    return lines;
}

std::vector<std::string> failure_table(const WhereItFails& where) {
    std::vector<std::string> lines = checks_table(where.checks);
    for (const Offending& offending : where.offending) {
        lines.push_back(
            fmt::format("  {} stand out (p {})", offending.readings, p_text(offending.p)));
    }
    return lines;
}

}  // namespace pendular
