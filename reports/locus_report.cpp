#include "reports/locus_report.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <numbers>
#include <string_view>

#include "reports/with_error.h"

namespace pendular {
namespace {

constexpr double degree = 180 / std::numbers::pi;

/// Value with its error, if known, and unit.
std::string result_text(double value, const std::optional<LocusErrors>& errors,
                        double LocusErrors::*error, const char* unit, double scale = 1) {
    const double own = errors ? scale * (*errors).*error : 0;
    if (!(own > 0) || !std::isfinite(own) || !std::isfinite(value))
        return std::isinf(value) && value > 0 ? "infinite"
                                              : fmt::format("{:.4g}{}", scale * value, unit);
    return with_error(scale * value, own) + unit;
}

std::string strength_line(const char* rule, const LinearYieldLocus& line, std::size_t points) {
    using Errors = LocusErrors;
    const auto text_of = [&](double value, double Errors::*error, const char* unit,
                             double scale = 1) {
        return result_text(value, line.errors, error, unit, scale);
    };
    std::string text = fmt::format(
        "  {:<22} cohesion {}, angle of internal friction {}, tensile strength {}, unconfined "
        "strength {}",
        rule, text_of(line.cohesion, &Errors::cohesion, " Pa"),
        text_of(line.slope_angle, &Errors::slope_angle, " deg", degree),
        text_of(line.tensile_strength, &Errors::tensile_strength, " Pa"),
        text_of(line.unconfined_strength, &Errors::unconfined_strength, " Pa"));
    if (line.intercept < 0) text += fmt::format(" (the intercept is {:.4g} Pa)", line.intercept);
    if (line.flowability)
        text += fmt::format(
            ", major principal stress {}, effective angle {}, flowability {}, {}",
            text_of(*line.major_principal_stress, &Errors::major_principal_stress, " Pa"),
            text_of(*line.effective_angle, &Errors::effective_angle, " deg", degree),
            text_of(*line.flowability, &Errors::flowability, ""), line.flow_class);
    if (!line.errors) text += fmt::format("; errors: not determined by {} points", points);
    return text + ".";
}

/// Reasons not to believe a yield locus.
std::vector<std::string> doubts_of(const YieldLocus& locus) {
    std::vector<std::string> doubts;
    if (locus.line && locus.line->intercept < 0)
        doubts.emplace_back(
            "The line meets the axis below zero, as no grains do: repeat points that lie apart.");
    if (!locus.preshear) return doubts;
    std::vector<int> above;
    for (const FailurePoint& point : locus.points)
        if (point.shear_stress > locus.preshear->shear_stress &&
            point.normal_stress < locus.preshear->normal_stress)
            above.push_back(point.interval);
    if (!above.empty())
        doubts.push_back(fmt::format(
            "Interval{} {}: sheared above the shear stress of the preshear at a lower normal "
            "stress, so that the preshear may not have been steady.",
            above.size() == 1 ? "" : "s", fmt::join(above, ", ")));
    return doubts;
}

std::string heading_of(const YieldLocus& locus) {
    std::string heading = "Yield locus";
    if (!locus.test.empty()) heading += " of " + locus.test;
    if (!locus.preshear) return heading + ":";
    const PreshearPoint& preshear = *locus.preshear;
    heading += fmt::format(", preshear with normal stress {:.4g} Pa", preshear.normal_stress);
    if (std::isfinite(preshear.shear_stress))
        heading += ", shear stress " +
                   (preshear.shear_stress_error
                        ? with_error(preshear.shear_stress, *preshear.shear_stress_error)
                        : fmt::format("{:.4g}", preshear.shear_stress)) +
                   " Pa";
    if (preshear.bulk_density)
        heading += fmt::format(", bulk density {:.4g} kg/m^3", *preshear.bulk_density);
    if (!preshear.plateau) heading += " (still changing at its end: the preshear was too short)";
    return heading + ":";
}

/// Largest change by prorating of a locus's points, in per cent; empty if it is not known.
std::optional<double> change_by_prorating(const YieldLocus& locus) {
    std::optional<double> largest;
    for (const FailurePoint& point : locus.points)
        if (point.prorating)
            largest = std::max(largest.value_or(0), 100 * std::abs(*point.prorating - 1));
    return largest;
}

/// Sentence on prorating; empty where it makes no difference that one would see.
std::string prorating_sentence(const YieldLocus& locus) {
    constexpr double seen = 0.1;  // per cent
    const auto change = change_by_prorating(locus);
    if (locus.prorated)
        return fmt::format(
            "Prorated: each shear stress is multiplied by the mean shear stress of "
            "the preshears over that of its own, a change of at most {:.2g} %.",
            change.value_or(0));
    if (!change || *change < seen) return "";
    return fmt::format(
        "Not prorated: --prorate would change the shear stresses by at most {:.2g} "
        "%. Leave it if the instrument's program has prorated them.",
        *change);
}

/// Why a line through points of failure has no flowability.
std::string unknown_flowability(const YieldLocus& locus) {
    const std::string_view unknown = "major principal stress and flowability are unknown.";
    if (!locus.preshear)
        return fmt::format("The stresses of a preshear are not known: {}", unknown);
    if (!std::isfinite(locus.preshear->shear_stress))
        return fmt::format("The shear stress of the preshear is not known: {}", unknown);
    return fmt::format("No Mohr circle through the preshear touches the line: {}", unknown);
}

void add_points(const YieldLocus& locus, std::vector<std::string>& lines) {
    lines.push_back(fmt::format("  {:>8} {:>8} {:>18} {:>18} {:>16} {:>16}", "interval", "line",
                                "normal stress [Pa]", "shear stress [Pa]", "smoothed normal",
                                "smoothed shear"));
    for (const FailurePoint& point : locus.points)
        lines.push_back(fmt::format(
            "  {:>8} {:>8} {:>18.4g} {:>18.4g} {:>16.4g} {:>16.4g}{}", point.interval, point.line,
            point.normal_stress, point.shear_stress, point.smoothed_normal_stress,
            point.smoothed_shear_stress,
            point.at_end ? "  at the last rows: failure may not have been reached" : ""));
}

void add_locus(const YieldLocus& locus, std::vector<std::string>& lines) {
    lines.push_back(heading_of(locus));
    add_points(locus, lines);
    for (const std::string& line : doubts_of(locus))
        lines.push_back("  " + line);
    if (const std::string prorating = prorating_sentence(locus); !prorating.empty())
        lines.push_back("  " + prorating);
    if (locus.line)
        lines.push_back(strength_line("Largest sample:", *locus.line, locus.points.size()));
    const bool rows = std::ranges::any_of(locus.points, [](const FailurePoint& point) {
        return point.smoothed_end > point.smoothed_begin + 1;
    });
    if (locus.smoothed && rows)
        lines.push_back(strength_line("Smoothed peak:", *locus.smoothed, locus.points.size()));
    if (locus.line && !locus.line->flowability)
        lines.push_back("  (" + unknown_flowability(locus) + ")");
}

/// Value of a table with its error, if known.
std::string cell_text(double value, const std::optional<LocusErrors>& errors,
                      double LocusErrors::*error) {
    return result_text(value, errors, error, "");
}

/// The sheets and tests that tell a locus from others.
std::string name_of_locus(const FileView& view, const YieldLocus& locus) {
    const std::string file = std::filesystem::path(view.file.file).filename().string();
    return locus.test.empty() ? file : fmt::format("{}, {}", file, locus.test);
}

}  // namespace

std::vector<std::string> yield_locus_lines(const FileView& view) {
    std::vector<std::string> lines;
    if (view.file.table_of_points && !view.loci.empty())
        lines.emplace_back(
            "Each row counts as the peak of one test. If the rows are steady shear, read them in "
            "[[readings]] without state = \"failure\".");
    for (const YieldLocus& locus : view.loci)
        add_locus(locus, lines);
    return lines;
}

std::vector<std::string> flow_function_table(const std::vector<FileView>& views) {
    using Errors = LocusErrors;
    std::vector<std::string> lines = {fmt::format("  {:>14} {:>20} {:>20} {:>18}  {:<14} {}",
                                                  "preshear [Pa]", "sigma 1 [Pa]", "strength [Pa]",
                                                  "flowability", "class", "yield locus")};
    for (const FileView& view : views)
        for (const YieldLocus& locus : view.loci) {
            if (!locus.preshear || !locus.line || !locus.line->flowability) continue;
            const LinearYieldLocus& line = *locus.line;
            lines.push_back(fmt::format(
                "  {:>14.4g} {:>20} {:>20} {:>18}  {:<14} {}", locus.preshear->normal_stress,
                cell_text(*line.major_principal_stress, line.errors,
                          &Errors::major_principal_stress),
                cell_text(line.unconfined_strength, line.errors, &Errors::unconfined_strength),
                cell_text(*line.flowability, line.errors, &Errors::flowability), line.flow_class,
                name_of_locus(view, locus)));
        }
    constexpr std::size_t fewest = 3;  // the heading, and two consolidations
    if (lines.size() < fewest) return {};
    lines.insert(lines.begin(), "Flow function:");
    return lines;
}

namespace {

/// Value and error for study.toml.
struct DirectText {
    std::string value, error, remark;
};

DirectText direct_text(const WallLocus& wall) {
    // Of ring shear testers with four points or more, 1 to 3 %: chosen three times as large.
    constexpr double guessed = 0.1;
    const WallLine line = wall.line();
    if (!(line.slope_error > 0))
        return {fmt::format("{:.3g}", line.slope), fmt::format("{:.1g}", guessed * line.slope),
                wall.errors
                    ? "   # GUESS: points exactly on a line do not determine it"
                    : fmt::format("   # GUESS: {} points do not determine it", wall.points.size())};
    return {fmt::format("{:.4g}", line.slope), fmt::format("{:.2g}", line.slope_error), ""};
}

void add_wall(const WallLocus& wall, std::vector<std::string>& lines) {
    lines.push_back(
        fmt::format("Wall yield locus{}:", wall.test.empty() ? "" : " of " + wall.test));
    lines.push_back(
        fmt::format("  {:>8} {:>18} {:>18}", "line", "normal stress [Pa]", "shear stress [Pa]"));
    for (const WallPoint& point : wall.points)
        lines.push_back(fmt::format("  {:>8} {:>18.4g} {:>18.4g}", point.line, point.normal_stress,
                                    point.shear_stress));
    const auto text = [&](double value, double error, double scale = 1) {
        return wall.errors && error > 0 ? with_error(scale * value, scale * error)
                                        : fmt::format("{:.4g}", scale * value);
    };
    const WallErrors errors = wall.errors.value_or(WallErrors{});
    const auto angle_of = [&](double slope, double error) {
        return text(std::atan(slope), error / (1 + slope * slope), degree);
    };
    lines.push_back(
        fmt::format("  Through the origin: angle of wall friction {} deg (coefficient {}).",
                    angle_of(wall.coefficient, errors.coefficient),
                    text(wall.coefficient, errors.coefficient)));
    lines.push_back(fmt::format(
        "  Best line: adhesion {} Pa, angle {} deg{}.", text(wall.adhesion, errors.adhesion),
        angle_of(wall.slope, errors.slope),
        wall.errors ? ""
                    : fmt::format("; errors: not determined by {} points", wall.points.size())));
    if (wall.adheres())
        lines.emplace_back(
            "  The best line meets the axis above zero by more than its error: its slope is the "
            "friction of the wall.");
    if (wall.below_origin())
        lines.emplace_back(
            "  The best line meets the axis below zero by more than its error, as no grains do: "
            "repeat points that lie apart.");
    const DirectText direct = direct_text(wall);
    // Above it, beads that can turn roll along a wall (docs/explanation/cell.md).
    constexpr double rolling = 0.15;
    const std::string_view limit =
        wall.line().slope > rolling
            ? "   # an upper limit: above about 0.15, free beads roll along walls"
            : "";
    lines.emplace_back(
        "  Where the side walls of the cell are of this material, study.toml may "
        "state it as a direct measurement:");
    for (const std::string& line :
         {std::string("[[direct]]"), std::string("effect = \"wall-friction\""),
          fmt::format("value = {}{}", direct.value, limit),
          fmt::format("error = {}{}", direct.error, direct.remark)})
        lines.push_back("    " + line);
}

}  // namespace

std::vector<std::string> wall_locus_lines(const FileView& view) {
    std::vector<std::string> lines;
    for (const WallLocus& wall : view.walls)
        add_wall(wall, lines);
    return lines;
}

}  // namespace pendular
