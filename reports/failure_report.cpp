#include "reports/failure_report.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <utility>

#include "analysis/misfit/compare.h"
#include "data/remarks/wording.h"
#include "reports/words.h"

namespace pendular {
namespace {

std::string sentence(const Check& check) {
    const std::string p = fmt::format("p {}", p_text(check.p));
    switch (check.kind) {
        case Check::Kind::lack_of_fit:
            return fmt::format(
                "At some conditions, the mean of the readings differs from the model by more than "
                "its standard error explains (lack of fit, {}).",
                p);
        case Check::Kind::trend:
            return fmt::format("The residual of the {} (measured minus model) {} with the {} ({}).",
                               check.of, check.statistic > 0 ? "increases" : "decreases",
                               check.covariate, p);
        case Check::Kind::score:
            return fmt::format("The fitted {} depends on the {} ({}), but should be constant.",
                               parameter_in_words(check.of), check.covariate, p);
        case Check::Kind::runs:
            return fmt::format("Neighbouring readings of {} lie on one side of the model ({}).",
                               check.of, p);
        default:
            return fmt::format("Residuals of neighbouring conditions are correlated ({}).", p);
    }
}

/// Whether a check rests on the order in which files were measured, which no file states.
bool depends_on_order(const Check& check) {
    return check.covariate == "time" || check.covariate == "run order";
}

constexpr const char* order_of_files =
    " Between files, the order is that of the entries in study.toml and, within a pattern, of the "
    "names: to state another, write an entry for each file, in the order of measurement.";

}  // namespace

std::string p_text(double p, const char* equals) {
    return p < 1e-3 ? "< 0.001" : fmt::format("{}{:.2g}", equals, p);
}

std::vector<const Check*> significant_checks(const Checks& checks) {
    std::vector<const Check*> result;
    for (const Check& check : checks.all) {
        if (check.p < significant_p) result.push_back(&check);
    }
    std::ranges::stable_sort(result, {}, &Check::p);
    return result;
}

std::vector<std::string> checks_table(const Checks& checks) {
    std::vector<std::string> lines;
    bool correlated = false;  // one sentence serves all correlation lengths
    bool ordered = false;     // and one all checks along the time
    for (const Check* check : significant_checks(checks)) {
        const bool correlation = check->kind == Check::Kind::neighbours;
        if (!correlation || !std::exchange(correlated, true)) {
            lines.push_back("  " + sentence(*check));
            if (depends_on_order(*check) && !std::exchange(ordered, true))
                lines.back() += order_of_files;
        }
    }
    lines.insert(
        lines.begin(),
        lines.empty() ? fmt::format("None of the {} checks of the residuals is significant "
                                    "(together: p {}).",
                                    checks.all.size(), p_text(checks.p))
        : checks.p < significant_p
            ? fmt::format("How the model fails ({} checks of the residuals, combined p {}):",
                          checks.all.size(), p_text(checks.p))
            : fmt::format("Taken together, the {} checks of the residuals show no significant "
                          "misfit (p {}); taken singly, the following checks have p < {}:",
                          checks.all.size(), p_text(checks.p), significant_p));
    return lines;
}

std::string deviating_line(std::vector<std::pair<std::string, double>> measurements) {
    // Many measurements deviate where the model fails as a whole.
    constexpr std::size_t most_deviating = 8;
    if (measurements.empty() || measurements.size() > most_deviating) return "";
    std::ranges::stable_sort(measurements, {}, &std::pair<std::string, double>::second);
    constexpr std::size_t most_named = 3;  // in one line
    std::vector<std::string> named;
    for (const auto& [name, p] : measurements) {
        if (named.size() < most_named) named.push_back(fmt::format("{} (p {})", name, p_text(p)));
    }
    const std::size_t others = measurements.size() - named.size();
    return fmt::format("Measurements that the model fits worse than the others: {}{}.",
                       fmt::join(named, "; "),
                       others > 0 ? fmt::format("; and {} more", others) : "");
}

std::vector<std::string> failure_table(const WhereItFails& where) {
    std::vector<std::string> lines = checks_table(where.checks);
    std::vector<std::pair<std::string, double>> measurements;
    for (const DeviatingGroup& offending : where.offending) {
        measurements.emplace_back(offending.readings, offending.p);
    }
    if (const std::string line = deviating_line(std::move(measurements)); !line.empty())
        lines.push_back("  " + line);
    return lines;
}

std::string recordings_line(const std::vector<RecordingEvidence>& evidence) {
    constexpr std::size_t most_sentences = 2;  // before the verdict, which must stay in sight
    if (evidence.empty()) return "";
    std::vector<Remark> findings;
    for (const RecordingEvidence& each : evidence)
        findings.push_back(each.finding);
    const std::vector<std::string> all = sentences(findings);
    std::string line = "The recordings themselves show:";
    for (std::size_t k = 0; k < std::min(all.size(), most_sentences); ++k)
        line += " " + all[k];
    if (all.size() > most_sentences)
        line += fmt::format(" {} more; 'pendular import' lists them.", all.size() - most_sentences);
    if (evidence.front().explains_most())
        line += fmt::format(
            " This explains {:.0f} % of the misfit: correct it before you add an effect.",
            100 * evidence.front().explains);
    return line;
}

}  // namespace pendular
