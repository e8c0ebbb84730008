#include "workflow/begun_tables.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <optional>
#include <set>
#include <vector>

#include "data/files/columns.h"
#include "data/files/csv.h"
#include "data/files/folded_name.h"

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

/// Row of a point.
/// @param deviation of the shear stress [Pa]
/// @param fraction cells of the solid fraction, "0.60,0.1" if nothing is known
/// @param end cells of the preshear's normal stress [Pa] and of further columns
std::string point_row(double normal, double shear, double deviation, int line,
                      const std::string& fraction, const std::string& end = "") {
    return fmt::format("{:.6g},{:.6g},{:.3g},{},0,{},{}\n", normal, shear, deviation, fraction,
                       line, end);
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
std::vector<std::size_t> steady_preshears(const FileView& view,
                                          const std::optional<std::string>& group) {
    std::vector<std::size_t> all, plateaus;
    for (std::size_t i = 0; i < view.series.size(); ++i) {
        const IntervalSeries& series = view.series[i];
        if (group && view.file.blocks[i].group != *group) continue;
        if (view.roles[i].role != "preshear" || series.shear_stress.empty() ||
            series.normal_stress.empty())
            continue;
        all.push_back(i);
        if (preshear_point(series).plateau) plateaus.push_back(i);
    }
    return plateaus.empty() ? all : plateaus;
}

/// Error of a point's shear stress that a table of points states [Pa]; empty if it states none.
std::optional<double> stated_error(const FileView& view, int line) {
    if (!view.file.table_of_points) return std::nullopt;
    const auto of_line = [&](const Block& block) {
        return !block.table.rows.empty() && block.table.rows.front().line == line;
    };
    const auto block = std::ranges::find_if(view.file.blocks, of_line);
    if (block == view.file.blocks.end()) return std::nullopt;
    return Columns(block->table).standard_error(block->table.rows.front(), "shear_stress");
}

/// Standard deviation of a shear stress [Pa], which is at least 1 %: even a peak without noise is
/// not exact.
double at_least_one_percent(double deviation, double shear) {
    return std::max(deviation, 0.01 * shear);
}

/// Error of a point's shear stress [Pa]: as the file states it, or else what smoothing takes away.
double deviation_of(const FileView& view, const FailurePoint& point) {
    const auto stated = stated_error(view, point.line);
    return stated ? *stated
                  : at_least_one_percent(point.shear_stress - point.smoothed_shear_stress,
                                         point.smoothed_shear_stress);
}

/// Group of the points of a locus.
const std::string& group_of(const FileView& view, const YieldLocus& locus) {
    return std::ranges::find(view.file.blocks, locus.test, &Block::test)->group;
}

/// Header and cell of the column that names a group; empty without one.
std::string group_header(const std::optional<std::string>& group) {
    return group ? ",material" : "";
}

std::string group_cell(const std::optional<std::string>& group) {
    return group ? "," + csv_text_cell(*group) : "";
}

/// Letters and digits of a name, with "_" for what stands between them. Bytes beyond ASCII are
/// parts of letters.
std::string part_of_file_name(const std::string& name) {
    constexpr std::size_t longest = 60;  // of the 255 bytes of most file systems
    std::string part;
    for (const char c : name) {
        const bool letter = static_cast<unsigned char>(c) > 0x7f ||
                            std::isalnum(static_cast<unsigned char>(c)) != 0;
        if (!letter && part.size() >= longest) break;
        if (letter)
            part += c;
        else if (!part.empty() && part.back() != '_')
            part += '_';
    }
    while (part.ends_with('_'))
        part.pop_back();
    return part.size() > 2 * longest ? "" : part;
}

}  // namespace

bool states_errors(const FileView& view) {
    return std::ranges::any_of(view.loci, [&](const YieldLocus& locus) {
        return std::ranges::any_of(locus.points, [&](const FailurePoint& point) {
            return stated_error(view, point.line).has_value();
        });
    });
}

std::vector<std::string> groups_of_points(const FileView& view) {
    std::vector<std::string> groups;
    if (!view.file.table_of_points) return groups;
    for (const YieldLocus& locus : view.loci)
        if (const std::string& group = group_of(view, locus);
            std::ranges::find(groups, group) == groups.end())
            groups.push_back(group);
    if (groups.size() < 2) groups.clear();
    return groups;
}

std::string name_of_table(const std::string& table, const std::string& group,
                          std::set<std::string>& taken) {
    const std::string part = part_of_file_name(group);
    const std::string begin = part.empty() ? table : table + "_" + part;
    std::string name = begin;
    for (int number = 2; !taken.insert(lower_case(name)).second; ++number)
        name = fmt::format("{}_{}", begin, number);
    return name;
}

bool states_contents(const FileView& view) {
    return std::ranges::any_of(view.file.blocks,
                               [](const Block& block) { return block.liquid_content.has_value(); });
}

std::string failure_table(const FileView& view, const std::optional<std::string>& group) {
    std::string text = points_header("solid_fraction", "1",
                                     ",failure [1]" + content_header(view) + group_header(group));
    for (const YieldLocus& locus : view.loci) {
        if (group && group_of(view, locus) != *group) continue;
        const std::string preshear =
            locus.preshear ? fmt::format("{:.6g}", locus.preshear->normal_stress) : "";
        for (const FailurePoint& point : locus.points)
            if (point.smoothed_normal_stress > 0)
                text += point_row(
                    point.smoothed_normal_stress, point.smoothed_shear_stress,
                    deviation_of(view, point), point.line, unknown_fraction,
                    preshear + ",1" + content_cell(view, point.liquid_content) + group_cell(group));
    }
    return text;
}

std::string steady_table(const FileView& view, double mass_ratio,
                         const std::optional<std::string>& group) {
    const bool weighed =
        std::ranges::any_of(view.file.blocks, [](const Block& b) { return !!b.bulk_density; });
    std::string text;
    for (const std::size_t i : steady_preshears(view, group)) {
        const IntervalSeries& series = view.series[i];
        const std::optional<double> bulk = view.file.blocks[i].bulk_density;
        if (bulk.has_value() != weighed) continue;
        const double density = bulk.value_or(0) / (1 + mass_ratio);
        const PreshearPoint point = preshear_point(series);
        text += point_row(
            point.normal_stress, point.shear_stress,
            at_least_one_percent(point.shear_stress_deviation, point.shear_stress),
            series.line.back(),
            weighed ? fmt::format("{:.5g},{:.3g}", density, 0.01 * density) : unknown_fraction,
            content_cell(view, view.file.blocks[i].liquid_content) + group_cell(group));
    }
    if (text.empty()) return text;
    const std::string more = content_header(view) + group_header(group);
    return (weighed ? points_header("bulk_density", "kg/m^3", more)
                    : points_header("solid_fraction", "1", more)) +
           text;
}

}  // namespace pendular
