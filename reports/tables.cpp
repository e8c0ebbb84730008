#include "reports/tables.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <functional>
#include <string>
#include <utility>

#include "data/quantities/number.h"
#include "data/remarks/wording.h"
#include "reports/failure_report.h"
#include "reports/with_error.h"

namespace pendular {
namespace {

constexpr std::size_t place_width = 28;  ///< characters: fits most names with a step

}  // namespace

std::string place_of(const Reading& reading) {
    const std::string file = std::filesystem::path(reading.origin.file).filename().string();
    return reading.step > 0 ? fmt::format("{} step {}", file, reading.step)
                            : fmt::format("{}:{}{}", file, reading.origin.line,
                                          reading.condition.at_failure ? " (peak)" : "");
}

std::string freedom_text(int degrees_of_freedom) {
    return fmt::format("{} degree{} of freedom", degrees_of_freedom,
                       degrees_of_freedom == 1 ? "" : "s");
}

std::string misfit_text(const Misfit& misfit) {
    Misfit known_errors = misfit;
    known_errors.freedom = INFINITY;
    // Else a reader would compute a far smaller p.
    const bool differs = known_errors.p() < misfit.p() / 10;
    return fmt::format(
        "chi2 = {:.1f} for {} (p {}{})", misfit.chi2, freedom_text(misfit.dof), p_text(misfit.p()),
        differs && misfit.p() >= 1e-3 ? ", which allows for errors estimated from few repetitions"
                                      : "");
}

std::vector<std::string> readings_table(const Measurements& measurements) {
    std::vector<std::string> lines = {
        fmt::format("  {:<{}} {:>13} {:>9} {:>8} {:>18} {:>20}", "", place_width, "normal",
                    "inertial", "liquid", "", ""),
        fmt::format("  {:<{}} {:>13} {:>9} {:>8} {:>18} {:>20}", "reading", place_width,
                    "stress [Pa]", "number", "content", "shear stress [Pa]", "solid fraction")};
    for (const auto& r : measurements.readings) {
        lines.push_back(fmt::format("  {:<{}} {:>13.4g} {:>9.3g} {:>8.3g} {:>18} {:>20}",
                                    place_of(r), place_width, r.condition.normal_stress,
                                    r.condition.inertial_number, r.condition.liquid_content,
                                    with_error(r.value(0), std::sqrt(r.covariance(0, 0))),
                                    with_error(r.value(1), std::sqrt(r.covariance(1, 1)))));
    }
    return lines;
}

std::string excluded_text(const Measurements& measurements) {
    struct Words {
        bool (*fit)(Remark::Kind kind);
        const char *one, *several;
    };
    constexpr std::array<Words, 5> words = {
        {{beside_plateau, "transient", "transients"},
         {without_plateau, "step without a plateau", "steps without a plateau"},
         {on_reading, "reading", "readings"},
         {[](Remark::Kind kind) { return kind == Remark::Kind::cut_short; },
          "row that is cut short", "rows that are cut short"},
         {[](Remark::Kind kind) {
              return !beside_plateau(kind) && !without_plateau(kind) && !on_reading(kind) &&
                     kind != Remark::Kind::cut_short;
          },
          "other range of rows", "other ranges of rows"}}};
    std::string text;
    const std::vector<Remark> left_out = measurements.left_out();
    for (const auto& [fit, one, several] : words) {
        const auto count = std::ranges::count_if(left_out, fit, &Remark::kind);
        if (count == 0) continue;
        text += fmt::format("{}{} {}", text.empty() ? "" : ", ", count, count == 1 ? one : several);
    }
    return text;
}

bool beyond_transients(const Measurements& measurements) {
    return std::ranges::any_of(measurements.left_out(), std::not_fn(beside_plateau), &Remark::kind);
}

std::vector<std::string> excluded_table(const Measurements& measurements) {
    std::vector<std::string> lines = {
        fmt::format("  {:<{}} {}", "rows left out", place_width, "reason")};
    for (const Remark& each : measurements.left_out()) {
        const std::string file = std::filesystem::path(each.file()).filename().string();
        const std::string rows = each.last_line() > each.first_line()
                                     ? fmt::format("{} to {}", each.first_line(), each.last_line())
                                     : fmt::format("{}", each.first_line());
        lines.push_back(fmt::format("  {:<{}} {}", file + ":" + rows, place_width, text_of(each)));
    }
    return lines;
}

std::vector<std::string> scatter_table(const Measurements& measurements) {
    const ReplicateScatter& scatter = measurements.scatter;
    std::vector<std::string> lines;
    for (const auto& group : scatter.groups) {
        if (group.freedom.maxCoeff() <= 0) continue;
        std::vector<std::string> names;
        for (const std::string& file : group.files)
            names.push_back(std::filesystem::path(file).filename().string());
        lines.push_back(fmt::format("  {:>12.2f} {:>14.2f}   independent in each step: {}",
                                    100 * std::sqrt(group.excess(0, 0)),
                                    100 * std::sqrt(group.excess(1, 1)), fmt::join(names, ", ")));
    }
    if (lines.empty()) return lines;
    lines.insert(
        lines.begin(),
        fmt::format("Scatter of repeated readings [% of the value] at a normal stress of {} Pa{}:",
                    short_text(scatter.reference_stress),
                    scatter.stated ? ", as stated in [scatter]" : ""));
    lines.insert(lines.begin() + 1,
                 fmt::format("  {:>12} {:>14}", "shear stress", "solid fraction"));
    const auto& [stress, fraction] = scatter.filling;
    if (stress.variance > 0 || fraction.variance > 0) {
        lines.push_back(fmt::format("  {:>12.2f} {:>14.2f}   shared by all steps of a filling",
                                    100 * std::sqrt(stress.variance),
                                    100 * std::sqrt(fraction.variance)));
    }
    if (scatter.load_exponent.cwiseAbs().maxCoeff() > 0.05) {
        lines.push_back(fmt::format(
            "  The scatter that differs from step to step is proportional to the normal stress to "
            "the power {:.2f} (shear stress) and {:.2f} (solid fraction).",
            -scatter.load_exponent(0), -scatter.load_exponent(1)));
    }
    return lines;
}

std::vector<std::string> predictions_table(const Comparison& comparison, bool worst_first) {
    std::vector<std::string> lines = {
        fmt::format("  {:<{}} {:>11} {:>9} | {:<31} | {:<29} | {:>6}", "", place_width, "normal",
                    "inertial", "shear stress [Pa]", "solid fraction", "part"),
        fmt::format("  {:<{}} {:>11} {:>9} | {:>9} {:>9} {:>11} | {:>8} {:>7} {:>12} | {:>6}",
                    worst_first ? "reading (worst fit first)" : "reading", place_width,
                    "stress [Pa]", "number", "measured", "model", "resid./err.", "measured",
                    "model", "resid./err.", "chi2")};
    std::vector<ReadingMisfit> misfits = comparison.readings;
    if (worst_first) {
        std::ranges::stable_sort(misfits, std::greater<>(),
                                 [](const ReadingMisfit& m) { return m.chi2.sum(); });
    }
    for (const auto& m : misfits) {
        lines.push_back(fmt::format(
            "  {:<{}} {:>11.4g} {:>9.3g} | {:>9.4g} {:>9.4g} {:>11.2f} | {:>8.4f} {:>7.4f} "
            "{:>12.2f} | {:>6.2f}",
            place_of(m.reading), place_width, m.reading.condition.normal_stress,
            m.reading.condition.inertial_number, m.reading.value(0), m.predicted(0),
            m.normalised(0), m.reading.value(1), m.predicted(1), m.normalised(1), m.chi2.sum()));
    }
    lines.push_back(
        "  (resid./err.: measured minus model, divided by the standard error of this difference; "
        "part of chi2: contribution of this reading)");
    for (const DirectMisfit& direct : comparison.direct) {
        const DirectMeasurement& m = direct.measurement;
        lines.push_back(fmt::format(
            "  {} = {} measured directly; the model is {:.1f} standard "
            "errors {}",
            m.parameter, with_error(m.value, m.standard_error, m.unit),
            std::abs(direct.normalised()), direct.normalised() > 0 ? "below" : "above"));
    }
    return lines;
}

std::vector<std::string> misfit_table(const Comparison& comparison) {
    std::vector<std::string> lines;
    lines.push_back(fmt::format("Chi2 by observable: shear stress {:.2f}, solid fraction {:.2f}",
                                comparison.by_observable[0], comparison.by_observable[1]));
    lines.push_back("Chi2 by condition:");
    for (const auto& group : comparison.by_condition) {
        lines.push_back(fmt::format(
            "  {:>8.4g} Pa, I = {:<8.3g}, liquid content {:>6.3g}: {:>8.2f} from {} reading{}",
            group.condition.normal_stress, group.condition.inertial_number,
            group.condition.liquid_content, group.chi2, group.readings.size(),
            group.readings.size() == 1 ? "" : "s"));
    }
    if (comparison.by_file.size() > 1) {
        lines.push_back("Chi2 by file:");
        for (const auto& file : comparison.by_file) {
            lines.push_back(fmt::format("  {:<{}} {:>7.2f} from {} reading{}",
                                        std::filesystem::path(file.file).filename().string(),
                                        place_width, file.chi2, file.readings,
                                        file.readings == 1 ? "" : "s"));
        }
    }
    return lines;
}

namespace {

/// Text of the deviations of a cohesion line from points that it was not fitted to, as means of
/// replicates: "6.3 +- 1.2 % too high at P* = 1.4, 3.0 +- 1.0 % too low at P* = 1.9".
std::string deviations(const std::vector<Overestimate>& points) {
    std::vector<std::pair<std::string, std::vector<Overestimate>>> groups;
    for (const Overestimate& point : points) {
        const std::string at = fmt::format("{:.2g}", point.reduced_pressure);
        const auto same = std::ranges::find(groups, at, &decltype(groups)::value_type::first);
        if (same == groups.end()) {
            groups.push_back({at, {point}});
        } else {
            same->second.push_back(point);
        }
    }
    std::string text;
    for (const auto& [at, replicates] : groups) {
        Estimate mean;
        for (const Overestimate& one : replicates) {
            // The errors of replicates include the shared error of the line, so that their mean has
            // at least this error.
            mean.value += one.relative.value / static_cast<double>(replicates.size());
            mean.standard_error +=
                one.relative.standard_error / static_cast<double>(replicates.size());
        }
        text += fmt::format("{}{} % {} at P* = {}", text.empty() ? "" : ", ",
                            with_error(std::abs(100 * mean.value), 100 * mean.standard_error),
                            mean.value < 0 ? "too low" : "too high", at);
    }
    return text;
}

/// Cohesion lines sorted by liquid content and inertial number, so that the measured and the
/// simulated line of a condition follow each other.
std::vector<CohesionLine> measured_beside_simulated(std::vector<CohesionLine> lines) {
    // Two digits, since the set points of replicates differ in the third digit.
    const auto rounded = [](double x) { return fmt::format("{:.1e}", x); };
    std::ranges::stable_sort(lines, {}, [&](const CohesionLine& line) {
        return std::pair(std::stod(rounded(line.liquid_content)),
                         std::stod(rounded(line.inertial_number)));
    });
    return lines;
}

/// Returns what a cohesion line was fitted to, as a word of the table.
const char* through(const CohesionLine& line) {
    return line.source == "measured" ? "readings" : "model";
}

}  // namespace

std::vector<std::string> cohesion_table(const std::vector<CohesionLine>& lines) {
    if (lines.empty()) {
        return {};
    }
    const auto estimate = [](const Estimate& e) { return with_error(e.value, e.standard_error); };
    std::vector<std::string> table = {
        "Cohesion, from straight lines fitted to the stress ratio against 1/P* (P*: reduced "
        "pressure): stress ratio = intercept + c*/P*",
        fmt::format("  {:<10} {:>8} {:>9} {:>18} {:>18} {:>11} {:>16} {:>9} {:>7}", "line",
                    "liquid", "inertial", "", "reduced", "correlation", "", "lowest", ""),
        fmt::format("  {:<10} {:>8} {:>9} {:>18} {:>18} {:>11} {:>16} {:>9} {:>7}", "fitted to",
                    "content", "number", "intercept", "cohesion c*", "of the two", "cohesion [Pa]",
                    "P*", "points")};
    for (const auto& line : measured_beside_simulated(lines)) {
        table.push_back(fmt::format(
            "  {:<10} {:>8.3g} {:>9.3g} {:>18} {:>18} {:>11.2f} {:>16} {:>9.3g} {:>7}",
            through(line), line.liquid_content, line.inertial_number,
            estimate(line.stress_ratio_intercept), estimate(line.reduced_cohesion),
            line.correlation, estimate(line.cohesion), line.lowest_reduced_pressure, line.points));
    }
    for (const auto& line : lines) {
        if (!line.below.empty()) {
            table.push_back(fmt::format(
                "  Below the lowest P* of its fit, the line through the {} (liquid "
                "content {:.3g}, I = "
                "{:.3g}) gives a stress ratio that is {}.",
                through(line), line.liquid_content, line.inertial_number, deviations(line.below)));
        }
    }
    return table;
}

}  // namespace pendular
