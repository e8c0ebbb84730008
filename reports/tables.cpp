#include "reports/tables.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "reports/with_error.h"

namespace pendular {
namespace {

std::string place(const Reading& reading) {
    const std::string file = std::filesystem::path(reading.origin.file).filename().string();
    return reading.step > 0 ? fmt::format("{} step {}", file, reading.step)
                            : fmt::format("{}:{}", file, reading.origin.line);
}

constexpr std::size_t place_width = 28;

}  // namespace

std::vector<std::string> readings_table(const Measurements& measurements) {
    std::vector<std::string> lines = {
        fmt::format("  {:<{}} {:>10} {:>10} {:>10} {:>19} {:>19}", "reading", place_width,
                    "s22 [Pa]", "I [1]", "liquid [1]", "shear stress [Pa]", "solid fraction [1]")};
    for (const auto& r : measurements.readings) {
        lines.push_back(fmt::format(
            "  {:<{}} {:>10.4g} {:>10.3g} {:>10.3g} {:>10.4g} +-{:>6.2g} {:>10.4f} +-{:>6.1g}",
            place(r), place_width, r.condition.normal_stress, r.condition.inertial_number,
            r.condition.liquid_content, r.value(0), std::sqrt(r.covariance(0, 0)), r.value(1),
            std::sqrt(r.covariance(1, 1))));
    }
    return lines;
}

std::vector<std::string> predictions_table(const Comparison& comparison) {
    std::vector<std::string> lines = {
        fmt::format("  {:<{}} {:>9} {:>9} | {:>9} {:>9} {:>6} | {:>9} {:>9} {:>6} | {:>6}",
                    "reading", place_width, "s22 [Pa]", "I [1]", "s12 [Pa]", "model", "sigma",
                    "Phi_S [1]", "model", "sigma", "chi2")};
    for (const auto& m : comparison.readings) {
        lines.push_back(fmt::format(
            "  {:<{}} {:>9.4g} {:>9.3g} | {:>9.4g} {:>9.4g} {:>6.2f} | {:>9.4f} {:>9.4f} {:>6.2f} "
            "| {:>6.2f}",
            place(m.reading), place_width, m.reading.condition.normal_stress,
            m.reading.condition.inertial_number, m.reading.value(0), m.predicted(0),
            m.normalised(0), m.reading.value(1), m.predicted(1), m.normalised(1), m.chi2.sum()));
    }
    lines.push_back("  (sigma: measured minus model over the standard error of the difference)");
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

std::vector<std::string> comparison_table(const Comparison& comparison) {
    std::vector<std::string> lines = predictions_table(comparison);
    lines.push_back(fmt::format("chi2 by observable: shear stress {:.2f}, solid fraction {:.2f}",
                                comparison.by_observable[0], comparison.by_observable[1]));
    lines.push_back("chi2 by condition:");
    for (const auto& group : comparison.by_condition) {
        lines.push_back(fmt::format(
            "  s22 {:>8.4g} Pa, I {:>8.3g}, liquid content {:>6.3g}: {:>7.2f} from {} reading{}",
            group.condition.normal_stress, group.condition.inertial_number,
            group.condition.liquid_content, group.chi2, group.readings.size(),
            group.readings.size() == 1 ? "" : "s"));
    }
    if (comparison.by_file.size() > 1) {
        lines.push_back("chi2 by file:");
        for (const auto& file : comparison.by_file) {
            lines.push_back(fmt::format("  {:<{}} {:>7.2f} from {} reading{}",
                                        std::filesystem::path(file.file).filename().string(),
                                        place_width, file.chi2, file.readings,
                                        file.readings == 1 ? "" : "s"));
        }
    }
    return lines;
}

std::vector<std::string> cohesion_table(const std::vector<CohesionLine>& lines) {
    if (lines.empty()) {
        return {};
    }
    const auto estimate = [](const Estimate& e, const char* form) {
        return fmt::format("{} +- {}", fmt::format(fmt::runtime(form), e.value),
                           fmt::format(fmt::runtime(form), e.standard_error));
    };
    std::vector<std::string> table = {
        "cohesion lines: stress ratio = intercept + c*/P*",
        fmt::format("  {:<10} {:>10} {:>9} {:>18} {:>18} {:>6} {:>16} {:>9} {:>6}", "source",
                    "liquid [1]", "I [1]", "intercept [1]", "c* [1]", "corr.", "cohesion [Pa]",
                    "P* from", "points")};
    for (const auto& line : lines) {
        table.push_back(fmt::format(
            "  {:<10} {:>10.3g} {:>9.3g} {:>18} {:>18} {:>6.2f} {:>16} {:>9.3g} {:>6}", line.source,
            line.liquid_content, line.inertial_number,
            estimate(line.stress_ratio_intercept, "{:.4f}"),
            estimate(line.reduced_cohesion, "{:.3f}"), line.correlation,
            estimate(line.cohesion, "{:.1f}"), line.lowest_reduced_pressure, line.points));
    }
    for (const auto& line : lines) {
        for (const auto& one : line.below) {
            table.push_back(fmt::format(
                "  at P* = {:.3g} the {} line of liquid content {:.3g} is {:+.1f} +- {:.1f} % off",
                one.reduced_pressure, line.source, line.liquid_content, 100 * one.relative.value,
                100 * one.relative.standard_error));
        }
    }
    return table;
}

}  // namespace pendular
