#include "workflow/begun_tables.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <vector>

namespace pendular {
namespace {

/// Header of a table of points, with the name and unit of the column of the solid fraction.
/// @param more names of further columns
std::string points_header(const std::string& fraction, const std::string& unit,
                          const std::string& more) {
    return fmt::format(
        "normal_stress [Pa],shear_stress [Pa],shear_stress_se [Pa],{0} [{1}],{0}_se [{1}],"
        "inertial_number [1],line [1],preshear_stress [Pa]{2}\n",
        fraction, unit, more);
}

/// Row of a point. The standard deviation of the shear stress is at least 1 %: even a peak without
/// noise is not exact.
/// @param fraction cells of the solid fraction, "0.60,0.1" if nothing is known
/// @param end cells of the preshear's normal stress [Pa] and of further columns
std::string point_row(double normal, double shear, double deviation, int line,
                      const std::string& fraction, const std::string& end = "") {
    return fmt::format("{:.6g},{:.6g},{:.3g},{},0,{},{}\n", normal, shear,
                       std::max(deviation, 0.01 * shear), fraction, line, end);
}

/// Cells of a solid fraction of which nothing is known.
constexpr const char* unknown_fraction = "0.60,0.1";

/// Name of the column of liquid contents; empty if a file states none.
std::string content_header(const FileView& view) {
    return states_contents(view) ? ",liquid_content [1]" : "";
}

/// Cell of that column, which is empty where a row states none.
std::string content_cell(const FileView& view, const std::optional<double>& content) {
    if (!states_contents(view)) return "";
    return content ? fmt::format(",{:.6g}", *content) : ",";
}

/// Indices of the preshears that have both stresses and reached a plateau; of all with both
/// stresses if none did.
std::vector<std::size_t> steady_preshears(const FileView& view) {
    std::vector<std::size_t> all, plateaus;
    for (std::size_t i = 0; i < view.series.size(); ++i) {
        const IntervalSeries& series = view.series[i];
        if (view.roles[i].role != "preshear" || series.shear_stress.empty() ||
            series.normal_stress.empty())
            continue;
        all.push_back(i);
        if (preshear_point(series).plateau) plateaus.push_back(i);
    }
    return plateaus.empty() ? all : plateaus;
}

}  // namespace

bool states_contents(const FileView& view) {
    return std::ranges::any_of(view.file.blocks,
                               [](const Block& block) { return block.liquid_content.has_value(); });
}

std::string failure_table(const FileView& view) {
    std::string text = points_header("solid_fraction", "1", ",failure [1]" + content_header(view));
    for (const YieldLocus& locus : view.loci) {
        const std::string preshear =
            locus.preshear ? fmt::format("{:.6g}", locus.preshear->normal_stress) : "";
        for (const FailurePoint& point : locus.points)
            if (point.smoothed_normal_stress > 0)
                text += point_row(point.smoothed_normal_stress, point.smoothed_shear_stress,
                                  point.shear_stress - point.smoothed_shear_stress, point.line,
                                  unknown_fraction,
                                  preshear + ",1" + content_cell(view, point.liquid_content));
    }
    return text;
}

std::string steady_table(const FileView& view, double mass_ratio) {
    const bool weighed =
        std::ranges::any_of(view.file.blocks, [](const Block& b) { return !!b.bulk_density; });
    std::string text;
    for (const std::size_t i : steady_preshears(view)) {
        const IntervalSeries& series = view.series[i];
        const std::optional<double> bulk = view.file.blocks[i].bulk_density;
        if (bulk.has_value() != weighed) continue;
        const double density = bulk.value_or(0) / (1 + mass_ratio);
        const PreshearPoint point = preshear_point(series);
        text += point_row(
            point.normal_stress, point.shear_stress, point.shear_stress_deviation,
            series.line.back(),
            weighed ? fmt::format("{:.5g},{:.3g}", density, 0.01 * density) : unknown_fraction,
            content_cell(view, view.file.blocks[i].liquid_content));
    }
    if (text.empty()) return text;
    return (weighed ? points_header("bulk_density", "kg/m^3", content_header(view))
                    : points_header("solid_fraction", "1", content_header(view))) +
           text;
}

}  // namespace pendular
