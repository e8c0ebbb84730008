#include "data/recordings/file_view.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <functional>
#include <iterator>
#include <stdexcept>
#include <string_view>

#include "data/files/column_names.h"
#include "data/files/columns.h"
#include "data/files/formats/layouts.h"
#include "data/files/header_cell.h"
#include "data/quantities/number.h"
#include "data/quantities/quantity.h"
#include "data/quantities/units.h"
#include "data/recordings/column_kinds.h"
#include "data/recordings/columns_by_unit.h"
#include "data/recordings/filled_down.h"
#include "data/recordings/findings/detectors.h"
#include "data/recordings/interval_checks.h"
#include "data/recordings/point_checks.h"
#include "data/recordings/point_texts.h"
#include "data/recordings/repeated_loads.h"
#include "data/recordings/stated_preshear.h"
#include "data/recordings/test_kinds.h"

namespace pendular {
namespace {

/// Quantities of steady shear of which one of a group is needed, with the group's name.
struct Needed {
    const char* name;
    std::vector<std::string_view> quantities;
};

const std::vector<Needed>& needed_quantities() {
    static const std::vector<Needed> all = {
        {"time", {"time"}},
        {"torque or shear stress", {"torque", "shear_stress", "lever_force"}},
        {"normal force or normal stress", {"normal_force", "normal_stress"}},
        {"gap", {"height"}},
        {"speed of the lid", {"rotational_speed", "angular_velocity", "shear_velocity"}}};
    return all;
}

/// Names of what steady shear needs but no interval of a file has.
std::vector<std::string> missing_quantities(const std::vector<IntervalSeries>& series) {
    const auto has = [&](std::string_view name) {
        return std::ranges::any_of(
            series, [&](const IntervalSeries& each) { return !each.column(name).empty(); });
    };
    std::vector<std::string> missing;
    for (const Needed& needed : needed_quantities())
        if (std::ranges::none_of(needed.quantities, has)) missing.emplace_back(needed.name);
    return missing;
}

/// Whether any row has a number in a column.
bool holds_numbers(const Block& block, std::size_t column) {
    return std::ranges::any_of(block.table.rows, [&](const Row& row) {
        return parse_number(row.cells[column].text).has_value();
    });
}

/// Quantities of steady shear that are missing, the first of each group; of a speed alone where a
/// unit is that of a rate.
std::vector<std::string_view> first_missing(const std::string& unit, const FileView& view) {
    std::vector<std::string_view> found;
    for (const Needed& needed : needed_quantities())
        if (std::ranges::find(view.missing, needed.name) != view.missing.end())
            found.push_back(needed.quantities.front());
    const std::string_view speed = needed_quantities().back().quantities.front();
    const bool rate = unit.find('/') != std::string::npos;
    if (rate && std::ranges::find(found, speed) != found.end()) return {speed};
    return found;
}

/// Whether a mass is written where its weight is one of the quantity: "kg" for "kgf".
bool fits_as_weight(const std::string& unit, std::string_view quantity_name) {
    if (unit.empty() || unit_fits(unit, quantity_name)) return false;
    const std::string weight = weight_meant(unit);
    return !weight.empty() && unit_fits(weight, quantity_name);
}

/// Missing quantities of which a column has the unit or, if it has that of none, the name.
std::vector<std::string_view> missing_quantities_of(const BlockColumn& column,
                                                    const FileView& view) {
    const ColumnMeaning named = meaning_of_column(column.name, "");
    std::vector<std::string_view> by_unit, by_name;
    for (const Needed& needed : needed_quantities()) {
        if (std::ranges::find(view.missing, needed.name) == view.missing.end()) continue;
        const auto fits = std::ranges::find_if(needed.quantities, [&](std::string_view name) {
            return name != "lever_force" && !names_another(column.name, name) &&
                   (unit_fits(column.unit, name) || fits_as_weight(column.unit, name));
        });
        if (fits != needed.quantities.end()) by_unit.push_back(*fits);
        if (!named.shared &&
            std::ranges::find(needed.quantities, named.quantity) != needed.quantities.end())
            by_name.push_back(named.quantity);
    }
    if (!by_unit.empty()) return by_unit;
    if (!by_name.empty()) return by_name;
    // A force is one on a lever only where the normal force is known.
    const bool no_torque =
        std::ranges::find(view.missing, "torque or shear stress") != view.missing.end();
    if (no_torque && unit_fits(column.unit, "lever_force")) return {"lever_force"};
    return {};
}

/// Unit at the end of a name, as programs write it, "F_daN" and "rpm"; that of a weight for a mass.
/// Empty if there is none of a missing quantity.
std::string unit_in_name(const std::string& name, const FileView& view) {
    const std::size_t bar = name.rfind('_');
    std::string unit = bar == std::string::npos ? name : name.substr(bar + 1);
    if (unit == "millis") unit = "ms";  // of an Arduino
    if (unit == "micros") unit = "us";
    // A letter alone is a symbol: "h", "T".
    if (unit.size() < 2 && bar == std::string::npos) return "";
    for (const std::string& each : {unit, weight_meant(unit)})
        if (is_unit(each) && !missing_quantities_of({"", each, ""}, view).empty()) return each;
    return "";
}

/// Unused columns in the unit of a missing quantity, or with its name, or in an unknown unit.
std::vector<BlockColumn> candidates(const FileView& view) {
    std::vector<BlockColumn> found;
    if (!is_own_table(view.file.layout)) return found;
    const Block& block = view.file.blocks.front();
    for (std::size_t i = 0; i < block.columns.size(); ++i) {
        BlockColumn column = block.columns[i];
        const bool errors = bare_mark({column.name, column.unit}) != ErrorMark::none;
        if (!column.quantity.empty() || !column.set_point_of.empty() || errors) continue;
        if (column.unit.empty() && holds_numbers(block, i))
            column.unit = unit_in_name(column.name, view);
        if (column.unit.empty()) continue;
        std::vector<std::string_view> possible = missing_quantities_of(column, view);
        if (possible.empty() && !is_unit(column.unit) && holds_numbers(block, i))
            possible = first_missing(column.unit, view);
        if (!possible.empty() && !names_result_of_locus(column))
            found.push_back({column.name, column.unit, std::string(possible.front())});
    }
    return found;
}

/// Fault in the unit of the first column with the name of a quantity; empty if there is none.
std::string wrong_unit(const Block& block) {
    for (const BlockColumn& column : block.columns) {
        const std::string_view named = meaning_of_column(column.name, "").quantity;
        if (column.unit.empty() || named.empty() || unit_fits(column.unit, named)) continue;
        return fmt::format("column '{} [{}]': {}", column.name, column.unit,
                           why_unit_is_wrong(column.unit, named));
    }
    return "";
}

/// @throws InputError if no column of a file is read
void refuse_unused_file(const BlockFile& file) {
    std::vector<std::string> names;
    for (const Block& block : file.blocks) {
        for (const BlockColumn& column : block.columns) {
            if (!column.quantity.empty()) return;
            if (&block != &file.blocks.front() || column.name.empty()) continue;
            names.push_back(column.unit.empty() ? column.name
                                                : fmt::format("{} [{}]", column.name, column.unit));
        }
    }
    if (const std::string why = wrong_unit(file.blocks.front()); !why.empty())
        throw InputError({file.file, file.blocks.front().table.header.line},
                         "no column is read: " + why);
    constexpr std::size_t most = 8;
    const bool more = names.size() > most;
    if (more) names.resize(most);
    throw InputError(
        {file.file, file.blocks.front().table.header.line},
        fmt::format("no column is read, since none has the name and the unit of a quantity: "
                    "'{}'{}; write names and units like 'Time [s]', 'Torque [mN m]' into this "
                    "line, or remove it if the names are in another",
                    fmt::join(names, "', '"), more ? ", ..." : ""));
}

/// Divides a table with a column of intervals into one block per interval.
void split_by_interval(BlockFile& file) {
    // Readings of several recordings have the numbers of these, or none.
    if (file.blocks.size() != 1 || is_table_of_readings(file.blocks.front())) return;
    const Block whole = std::move(file.blocks.front());
    const Columns columns(whole.table);
    if (!columns.has("interval")) {
        file.blocks.front() = whole;
        return;
    }
    file.blocks.clear();
    double number = 0;
    for (const Row& row : whole.table.rows) {
        const double own = columns.value(row, "interval");
        if (file.blocks.empty() || own != number) {
            count_interval(file, row.line, whole.columns.size());
            Block& block = file.blocks.emplace_back();
            block.number = static_cast<int>(std::clamp(own, 0.0, 1e9));
            block.name = file.fact(interval_name_key(block.number));
            block.columns = whole.columns;
            block.table.file = whole.table.file;
            block.table.delimiter = whole.table.delimiter;
            block.table.header = whole.table.header;
        }
        file.blocks.back().table.rows.push_back(row);
        number = own;
    }
}

void add_to_name(std::string& test, const std::string& part) {
    if (!test.empty()) test += ", ";
    test += part;
}

/// Liquid contents of the rows of a table [1]; empty where the table does not state it.
std::vector<std::optional<double>> contents_of(const Table& table, const Columns& columns) {
    std::vector<std::optional<double>> contents;
    for (const Row& row : table.rows)
        contents.push_back(columns.value_if_any(row, "liquid_content"));
    return contents;
}

/// Appends the rows of a table of points as one block each. Rows of one name and liquid content are
/// one test. Returns a remark on columns that may tell tests apart.
std::vector<Remark> append_points(const Block& whole, BlockFile& file) {
    const Columns columns(whole.table);
    const PointTexts texts = texts_of_points(whole, file.titles);
    const std::vector<std::optional<double>> contents = contents_of(whole.table, columns);
    const bool contents_differ =
        std::ranges::adjacent_find(contents, std::not_equal_to{}) != contents.end();
    for (std::size_t i = 0; i < whole.table.rows.size(); ++i) {
        const Row& row = whole.table.rows[i];
        count_interval(file, row.line, whole.columns.size());
        Block& block = file.blocks.emplace_back();
        block.test = whole.test;
        if (!texts.tests.empty() && !texts.tests[i].empty())
            add_to_name(block.test, texts.tests[i]);
        block.group = block.test;
        block.liquid_content = contents[i];
        if (contents_differ && contents[i])
            add_to_name(block.test, fmt::format("liquid content {:.4g}", *contents[i]));
        if (!texts.roles.empty()) block.stated_role = texts.roles[i];
        const auto preshear = columns.value_if_any(row, "preshear_stress");
        // At a level of 0 there was no preshear.
        if (preshear != 0.0) block.preshear_normal_stress = preshear;
        block.preshear_shear_stress = columns.value_if_any(row, "preshear_shear_stress");
        block.bulk_density = columns.value_if_any(row, "bulk_density");
        block.number = static_cast<int>(file.blocks.size());
        block.columns = whole.columns;
        block.table = {whole.table.file, whole.table.header, {row}, whole.table.delimiter};
    }
    if (texts.doubtful.empty()) return {};
    return {{.kind = Remark::Kind::returning_load, .files = {file.file}, .names = texts.doubtful}};
}

/// Divides a table of points, or several of them, into one block per row. Returns remarks on cells
/// that were filled.
std::vector<Remark> split_points(BlockFile& file) {
    // Of several blocks, only those of tables side by side or below one another, which have names.
    const bool tables = is_own_table(file.layout);
    const bool several = file.blocks.size() > 1;
    const auto holds_points = [&](const Block& block) {
        return block.stated_role.empty() && !(several && (!tables || block.test.empty())) &&
               (is_table_of_points(block, series_of(block)) ||
                repeats_each_load(block, series_of(block)));
    };
    if (!std::ranges::all_of(file.blocks, holds_points)) return {};
    std::vector<Block> wholes = std::move(file.blocks);
    file.blocks.clear();
    file.table_of_points = true;
    std::vector<Remark> filled;
    for (Block& whole : wholes) {
        append(filled, fill_down(whole));
        append(filled, append_points(whole, file));
    }
    return filled;
}

/// Computes torques from forces on a lever and, if the file has neither, the stresses.
void convert_lever_forces(IntervalSeries& series, const AnnularCell& cell) {
    if (series.lever_force.empty() || !(cell.lever_arm > 0)) return;
    if (!series.torque.empty() || !series.shear_stress.empty()) return;
    for (const double force : series.lever_force) {
        series.torque.push_back(force * cell.lever_arm);
        series.shear_stress.push_back(shear_stress(series.torque.back(), cell));
    }
    if (series.normal_stress.empty())
        for (const double force : series.normal_force)
            series.normal_stress.push_back(normal_stress(force, cell));
}

/// Adds the saturations of steady shear at one speed and load: several levels may each be held
/// exactly. Numbers for no value that are told already are none.
void add_saturations(FileView& view) {
    const auto told = [&](const Remark& saturation) {
        return std::ranges::any_of(view.findings, [&](const Remark& finding) {
            return finding.kind == Remark::Kind::far_values && !finding.corrected &&
                   finding.quantity == saturation.quantity;
        });
    };
    for (std::size_t i = 0; i < view.series.size(); ++i) {
        if (view.roles[i].role != "steady") continue;
        auto found = saturated_shear(view.file.file, view.series[i]);
        if (found && !told(*found) && steps_of(view.series[i]).size() == 1)
            view.findings.push_back(*std::move(found));
    }
}

}  // namespace

std::vector<std::string_view> possible_quantities(const BlockColumn& candidate,
                                                  const FileView& view) {
    const std::vector<std::string_view> known = missing_quantities_of(candidate, view);
    return known.empty() ? first_missing(candidate.unit, view) : known;
}

FileView view_of_file(const std::filesystem::path& path, const FileFormat& format,
                      const std::optional<AnnularCell>& study_cell) {
    FileView view;
    view.file = read_blocks(path, format);
    if (format.columns.empty()) view.by_unit = columns_by_unit(view.file);
    std::erase_if(view.by_unit, [](const auto& each) {
        return names_factor_of_numbers(parse_header_cell(each.second).name);
    });
    if (!view.by_unit.empty()) {
        FileFormat named = format;
        named.named_columns.insert(view.by_unit.begin(), view.by_unit.end());
        view.file = read_blocks(path, named);
    }
    refuse_unused_file(view.file);
    split_by_interval(view.file);
    std::vector<Remark> filled = split_points(view.file);
    state_preshears(view.file);
    view.file.shown_wall = format.wall ? "the user" : shown_wall(view.file);
    for (const Block& block : view.file.blocks) {
        view.series.push_back(series_of(block));
        if (study_cell) convert_lever_forces(view.series.back(), *study_cell);
    }
    view.roles = roles_of(view.file, view.series, format);
    view.cell = cell_from_columns(view.series);
    view.findings = std::move(filled);
    append(view.findings, check_file(view.file, view.series, view.cell));
    append(view.findings, far_values(view.file));
    append(view.findings, cycles_in_one_interval(view.file, view.series));
    add_saturations(view);
    view.stated = stated_cell(view.file);
    if (study_cell) append(view.findings, header_against_study(view.file, *study_cell));
    view.loci = yield_loci(view.file, view.series, view.roles, format.prorate);
    view.walls = wall_loci(view.file, view.series, view.roles);
    append(view.findings, check_points(view.file, view.series, view.loci, view.walls));
    view.missing = missing_quantities(view.series);
    view.candidates = candidates(view);
    std::ranges::copy(columns_like_intervals(view.file, view.series),
                      std::back_inserter(view.candidates));
    return view;
}

}  // namespace pendular
