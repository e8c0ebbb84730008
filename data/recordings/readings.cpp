#include "data/recordings/measurements.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <string_view>
#include <vector>

#include "data/files/columns.h"
#include "data/files/formats/layouts.h"
#include "data/files/header_cell.h"
#include "data/input_error.h"
#include "data/quantities/number.h"

namespace pendular {
namespace {

/// Known columns of a table of readings. The columns from `sampled_seconds` on describe the origin
/// of a reading and are never required.
const std::vector<std::string_view> reading_columns = {"normal_stress",
                                                       "normal_stress_sd",
                                                       "shear_stress",
                                                       "shear_stress_sd",
                                                       "stress_ratio",
                                                       "stress_ratio_sd",
                                                       "solid_fraction",
                                                       "solid_fraction_sd",
                                                       "bulk_density",
                                                       "bulk_density_sd",
                                                       "shear_rate",
                                                       "inertial_number",
                                                       "liquid_content",
                                                       "height",
                                                       "time",
                                                       "bead_volume",
                                                       "filling",
                                                       "shear_stress_of_filling",
                                                       "solid_fraction_of_filling",
                                                       "error_correlation",
                                                       "error_assumed",
                                                       "sampled_seconds",
                                                       "interval",
                                                       "replicates",
                                                       "failure",
                                                       "gap_creep",
                                                       "preshear_stress",
                                                       "preshear_shear_stress",
                                                       "file",
                                                       "line"};

/// A table of readings with all that is needed to convert its rows.
struct Points {
    const Table& table;
    const Columns& columns;
    const Source& source;
    const Study& study;
    std::string_view stress;    ///< name of the stress column: "shear_stress" or "stress_ratio"
    std::string_view fraction;  ///< name of its column: "solid_fraction" or "bulk_density"
};

void refuse_misspelt(const Table& table, const Columns& columns) {
    std::vector<std::string> known;
    for (const std::string_view name : reading_columns)
        known.emplace_back(name);
    for (const std::size_t index : columns.unknown()) {
        const std::string name = parse_header_cell(table.header.cells[index].text).name;
        if (name.empty()) continue;
        if (const auto meant = nearest(name, known))
            throw InputError(table.at_header(index),
                             fmt::format("unknown column '{}'; did you mean '{}'?", name, *meant));
    }
}

double positive(const Points& points, const Row& row, std::string_view name) {
    const double value = points.columns.value(row, name);
    if (value < smallest_magnitude)
        throw InputError(points.columns.at(row, name),
                         fmt::format("{} must be positive", quantity(name).meaning));
    return value;
}

double liquid_content(const Points& points, const Row& row) {
    const double value = points.columns.value_if_any(row, "liquid_content")
                             .value_or(points.source.liquid_content.value_or(0));
    const Position where = points.columns.at(row, "liquid_content");
    if (value < 0) throw InputError(where, "a liquid content must not be negative");
    if (value > 0 && !points.study.liquid)
        throw InputError(where, "a wet reading, but the study has no [liquid]; add it");
    return value;
}

/// Sets the shear rate [1/s] and inertial number [1] of a reading from the columns that the row
/// has.
/// @throws InputError if both are missing, a value is invalid, or the two contradict each other
void set_rate(const Points& points, const Row& row, Reading& reading) {
    const auto rate = points.columns.value_if_any(row, "shear_rate");
    const auto number = points.columns.value_if_any(row, "inertial_number");
    if (!rate && !number)
        throw InputError(points.columns.at(row, "shear_rate"),
                         "neither shear rate nor inertial number is given; fill in one");
    if (rate && *rate <= 0)
        throw InputError(points.columns.at(row, "shear_rate"),
                         "a shear rate must be positive; write inertial_number = 0 for the "
                         "quasi-static limit");
    if (number && *number < 0)
        throw InputError(points.columns.at(row, "inertial_number"),
                         "an inertial number must not be negative");
    reading.shear_rate = rate.value_or(0);
    const double from_rate =
        inertial_number(reading.shear_rate, reading.condition.normal_stress, points.study.grains);
    reading.condition.inertial_number = number.value_or(from_rate);
    // Both are written with a few digits; the other common form of the number is
    // sqrt(6/pi) times as large.
    if (rate && number && std::abs(*number - from_rate) > 0.01 * from_rate)
        throw InputError(points.columns.at(row, "inertial_number"),
                         fmt::format("{:.4g} does not go with the shear rate, which gives {:.4g}; "
                                     "remove one of the columns, or call the form rate "
                                     "a sqrt(density/s22) 'inertial_number_diameter_density'",
                                     *number, from_rate));
}

void set_stress(const Points& points, const Row& row, Reading& reading) {
    const double normal = reading.condition.normal_stress;
    const double value = positive(points, row, points.stress);
    const auto stated = points.columns.standard_error(row, points.stress);
    const double error = stated.value_or(0);
    reading.unstated[0] = !stated;
    if (points.stress == "stress_ratio") {
        reading.value(0) = value * normal;
        reading.covariance(0, 0) = std::pow(error * normal, 2);
        return;
    }
    const double of_normal = points.columns.standard_error(row, "normal_stress").value_or(0);
    reading.value(0) = value;
    reading.covariance(0, 0) = std::pow(error, 2) + std::pow(value / normal * of_normal, 2);
}

/// Value of the column of the solid fraction that means 1: the density of the grains for a bulk
/// density [kg/m^3].
double unit_of_fraction(const Points& points) {
    return points.fraction == "bulk_density" ? points.study.grains.density : 1;
}

void set_solid_fraction(const Points& points, const Row& row, Reading& reading) {
    const double unit = unit_of_fraction(points);
    reading.value(1) = positive(points, row, points.fraction) / unit;
    const auto stated = points.columns.standard_error(row, points.fraction);
    reading.covariance(1, 1) = std::pow(stated.value_or(0) / unit, 2);
    reading.unstated[1] = !stated;
}

/// Number of the filling in a row; 0 where the table does not tell fillings apart.
std::size_t filling(const Points& points, const Row& row) {
    const auto value = points.columns.value_if_any(row, "filling");
    if (!value) return 0;
    constexpr double most = 1e6;  // beyond any table; keeps the number exact
    if (!(*value >= 1 && *value <= most) || *value != std::floor(*value))
        throw InputError(points.columns.at(row, "filling"),
                         "a filling is numbered with a whole number from 1");
    return static_cast<std::size_t>(*value);
}

/// Adds the part of the error of an observable that the readings of a filling share.
/// @throws InputError if the row names no filling, or the part is larger than the whole error
void add_error_of_filling(const Points& points, const Row& row, Eigen::Index o, Reading& reading) {
    const std::string_view name = o == 0 ? "shear_stress_of_filling" : "solid_fraction_of_filling";
    const double size = points.columns.value_if_any(row, name).value_or(0);
    if (size == 0) return;
    const Position where = points.columns.at(row, name);
    const std::size_t number = filling(points, row);
    if (number == 0)
        throw InputError(where,
                         "an error that the readings of a filling share needs the number of "
                         "the filling, in the column 'filling'");
    // The whole error of a table that import wrote may be this part alone, but for rounding.
    constexpr double rounding = 1 + 1e-9;
    if (size < 0 || size > rounding * std::sqrt(reading.covariance(o, o)))
        throw InputError(where,
                         "an error that the readings of a filling share is a part of their "
                         "standard error; it must be positive and no larger than that");
    SharedError error{.source = 2 * number + static_cast<std::size_t>(o), .known = true};
    error.size(o) = size;
    reading.shared.push_back(error);
}

void set_correlation(const Points& points, const Row& row, Reading& reading) {
    const double correlation = points.columns.value_if_any(row, "error_correlation").value_or(0);
    if (std::abs(correlation) >= 1)
        throw InputError(points.columns.at(row, "error_correlation"),
                         "a correlation must lie between -1 and 1");
    reading.covariance(0, 1) = reading.covariance(1, 0) =
        correlation * std::sqrt(reading.covariance(0, 0) * reading.covariance(1, 1));
}

/// Solid volume of the grains in the cell [m^3] from the row, else from the entry of study.toml,
/// else from [cell]; empty if none of these has it.
std::optional<double> bead_volume(const Points& points, const Row& row) {
    if (points.columns.value_if_any(row, "bead_volume"))
        return positive(points, row, "bead_volume");
    if (points.source.bead_volume || !points.study.cell) return points.source.bead_volume;
    const double of_cell = points.study.cell->bead_volume;
    return of_cell > 0 ? std::optional(of_cell) : std::nullopt;
}

/// Sets time [s], height [m] and volume of grains [m^3] of a reading, as far as they are known.
void set_cell(const Points& points, const Row& row, Reading& reading) {
    Condition& condition = reading.condition;
    condition.time = points.columns.value_if_any(row, "time").value_or(0);
    condition.bead_volume = bead_volume(points, row);
    if (points.columns.value_if_any(row, "height")) {
        condition.height = positive(points, row, "height");
    } else if (points.study.cell && condition.bead_volume) {
        AnnularCell cell = *points.study.cell;
        cell.bead_volume = *condition.bead_volume;
        condition.height = height(reading.value(1), cell);
    }
}

/// Whether a row is a point of failure, as its column `failure` says or, without one, the entry of
/// study.toml. readings.csv has points of failure and steady shear in one table.
/// @throws InputError if the row is steady shear in an entry of points of failure
bool at_failure(const Points& points, const Row& row) {
    const bool stated = points.source.at_failure;
    const bool fails = points.columns.value_if_any(row, "failure").value_or(stated ? 1 : 0) != 0;
    if (stated && !fails)
        throw InputError(points.columns.at(row, "failure"),
                         "the row is steady shear, but the entry of study.toml has state = "
                         "\"failure\"; leave that line out, or move the row to a table of its own");
    return fails;
}

Reading reading_of(const Points& points, const Row& row) {
    Reading reading;
    reading.origin = {points.table.file, row.line, 0};
    reading.step = static_cast<int>(points.columns.value_if_any(row, "interval").value_or(0));
    reading.condition.normal_stress = positive(points, row, "normal_stress");
    reading.condition.liquid_content = liquid_content(points, row);
    reading.condition.at_failure = at_failure(points, row);
    reading.condition.gap_creep = points.columns.value_if_any(row, "gap_creep").value_or(0);
    if (points.columns.value_if_any(row, "preshear_stress"))
        reading.condition.preshear_stress = positive(points, row, "preshear_stress");
    set_rate(points, row, reading);
    set_stress(points, row, reading);
    set_solid_fraction(points, row, reading);
    set_correlation(points, row, reading);
    for (const Eigen::Index o : {0, 1})
        add_error_of_filling(points, row, o, reading);
    set_cell(points, row, reading);
    if (!reading.value.allFinite() || !reading.covariance.allFinite())
        throw InputError(reading.origin, "a value or its deviation is too large to compute with");
    reading.sampled_seconds = points.columns.value_if_any(row, "sampled_seconds").value_or(0);
    reading.error_assumed = points.columns.value_if_any(row, "error_assumed").value_or(0) != 0;
    return reading;
}

/// Sets the rounding step of each reading from the digits of the numbers in the table.
void set_resolutions(const Points& points, std::vector<Reading>& readings) {
    const auto stress = points.columns.resolutions(points.stress);
    const auto fraction = points.columns.resolutions(points.fraction);
    for (std::size_t k = 0; k < readings.size(); ++k) {
        const double unit =
            points.stress == "stress_ratio" ? readings[k].condition.normal_stress : 1;
        readings[k].resolution = {unit * stress[k], fraction[k] / unit_of_fraction(points)};
    }
}

/// Columns of a table of readings for which an empty cell is no default of a reading's condition.
bool is_origin(std::string_view name) {
    constexpr std::array<std::string_view, 6> names = {
        "sampled_seconds", "error_assumed", "interval", "replicates", "file", "line"};
    return std::ranges::find(names, name) != names.end();
}

/// Refuses a cell such as "NaN" of a value, which as an empty cell would stand for a default: 0 for
/// a liquid content. Errors may be unknown, and so may one of shear rate and inertial number.
/// @throws InputError at the first such cell
void refuse_cleared(const Points& points, const std::vector<ClearedCell>& cleared) {
    const auto& [table, columns, source, study, stress, fraction] = points;
    for (const ClearedCell& cell : cleared) {
        const std::string& header = table.header.cells[cell.column].text;
        const HeaderCell parts = parse_header_cell(header);
        const Quantity* const quantity = find_quantity(parts.name);
        if (!quantity || parts.deviation() || is_origin(quantity->name)) continue;
        if (std::ranges::find(reading_columns, quantity->name) == reading_columns.end() &&
            quantity->name != "inertial_number_diameter_density")
            continue;
        const Row& row = table.rows[cell.row];
        const bool rate = quantity->name == "shear_rate",
                   number = quantity->unit == "1" && quantity->name.starts_with("inertial_number");
        if ((rate && columns.value_if_any(row, "inertial_number")) ||
            (number && columns.value_if_any(row, "shear_rate")))
            continue;
        throw InputError(
            table.at(row, cell.column),
            fmt::format("column '{}': \"{}\" states no value; fill it in or remove the "
                        "line",
                        header, cell.text));
    }
}

/// Checks that the liquid content is given in the table or in the entry of study.toml, not in both.
/// @throws InputError if it is given in both, or in neither although the study has a liquid
void check_liquid_content(const Table& table, const Columns& columns, const Source& source,
                          const Study& study) {
    if (source.liquid_content && columns.has("liquid_content"))
        throw InputError(source.position, fmt::format("'liquid_content': {} has a column of that "
                                                      "name too; remove one",
                                                      table.file));
    if (study.liquid && !source.liquid_content) columns.require("liquid_content");
}

/// Whether a table was written by `write_readings`, whose columns NAME_sd are standard errors.
bool written_by_import(const Columns& columns) {
    return columns.has("error_assumed") && columns.has("sampled_seconds");
}

/// Says of columns NAME_sd that they are read as standard errors, since many tables mean the
/// standard deviation of single values by that name.
void note_deviations(const Table& table, const Columns& columns, std::vector<Remark>& remarks) {
    if (written_by_import(columns)) return;
    if (const auto names = columns.deviations_without_number(); !names.empty())
        remarks.push_back({.kind = Remark::Kind::sd_read_as_standard_error,
                           .files = {table.file},
                           .names = names});
}

/// Asks about a table in which nothing flows at the rates of a rheometer: the unit of the shear
/// rate may be wrong, or the zeros of a column that was never filled in may count as measurements.
void note_quasi_static(const Table& table, const Columns& columns, const Source& source,
                       Measurements& result) {
    // Chosen: 500 um glass at 1 kPa has it under a lid that turns once in ten minutes.
    constexpr double slow = 1e-5;
    double fastest = 0;
    for (const Reading& reading : result.readings)
        fastest = std::max(fastest, reading.condition.inertial_number);
    if (source.at_failure || result.readings.empty() || fastest > slow) return;
    const auto name = columns.has("shear_rate") ? "shear_rate" : "inertial_number";
    result.remarks.push_back({.kind = Remark::Kind::quasi_static_table,
                              .files = {table.file},
                              .size = fastest,
                              .names = {name}});
}

/// Refuses an error of a form of the reading that the table lacks, such as `shear_stress_se` beside
/// `stress_ratio`, which nothing would use.
void refuse_errors_of_absent(const Table& table, const Columns& columns, const Points& points) {
    for (const std::string_view name :
         {"shear_stress", "stress_ratio", "solid_fraction", "bulk_density"}) {
        if (name == points.stress || name == points.fraction) continue;
        if (const auto index = columns.place_of_error(name))
            throw InputError(
                table.at_header(*index),
                fmt::format("column '{}' is an error of a quantity that the table lacks; write "
                            "that of '{}', or remove it",
                            table.header.cells[*index].text,
                            name == "shear_stress" || name == "stress_ratio" ? points.stress
                                                                             : points.fraction));
    }
}

}  // namespace

Measurements read_points(const std::filesystem::path& path, const Source& source,
                         const Study& study) {
    FileFormat format = source.format;
    format.layout = "plain";
    std::vector<ClearedCell> cleared;
    const BlockFile file = read_blocks(path, format, &cleared);
    if (file.blocks.size() > 1)
        throw InputError({path.string(), file.blocks[1].table.header.line},
                         fmt::format("holds {} tables; a table of readings must be one: write each "
                                     "into a file of its own",
                                     file.blocks.size()));
    if (!file.skipped.empty())  // each reading counts
        throw InputError({path.string(), file.skipped.front().first_line()},
                         file.skipped.front().kind == Remark::Kind::cut_short
                             ? "this row is cut short: complete or remove it"
                             : "this line is no reading: remove it, or begin it with '#'");
    const Table& table = file.blocks.front().table;
    const Columns columns(table);
    refuse_misspelt(table, columns);
    columns.require("normal_stress");
    const Points points{table,
                        columns,
                        source,
                        study,
                        columns.require_one_of("shear_stress", "stress_ratio"),
                        columns.require_one_of("solid_fraction", "bulk_density")};
    if (!columns.has("shear_rate")) columns.require("inertial_number");
    check_liquid_content(table, columns, source, study);
    columns.check_numbers_of_values();
    refuse_errors_of_absent(table, columns, points);
    refuse_cleared(points, cleared);

    Measurements result;
    for (const Row& row : table.rows)
        result.readings.push_back(reading_of(points, row));
    set_resolutions(points, result.readings);
    note_deviations(table, columns, result.remarks);
    note_quasi_static(table, columns, source, result);
    if (const auto unused = columns.others(reading_columns); !unused.empty())
        result.remarks.push_back(
            {.kind = Remark::Kind::unused_columns, .files = {table.file}, .names = unused});
    result.remarks = decide(std::move(result.remarks), false);
    return result;
}

}  // namespace pendular
