#include "data/files/columns.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>
#include <map>
#include <numbers>
#include <set>
#include <stdexcept>

#include "data/files/header_names.h"
#include "data/quantities/number.h"
#include "data/quantities/units.h"

namespace pendular {
namespace {

/// Exponent of ten behind the 'e' of a number; 0 where there is none.
int exponent_of(std::string_view number) {
    const std::size_t e = number.find_first_of("eE");
    if (e == std::string_view::npos) return 0;
    std::string_view digits = number.substr(e + 1);
    if (digits.starts_with('+')) digits.remove_prefix(1);
    int exponent = 0;
    std::from_chars(digits.data(), digits.data() + digits.size(), exponent);
    return exponent;
}

Digits digits_of(std::string_view cell) {
    Digits result;
    bool started = false, point = false;
    for (const char c : cell.substr(0, cell.find_first_of("eE"))) {
        if (c == '.' || c == ',') {
            point = true;
        } else if (std::isdigit(static_cast<unsigned char>(c))) {
            started |= c != '0';
            result.significant += started;
            result.decimals += point;
        }
    }
    result.decimals = std::max(0, result.decimals - exponent_of(cell));
    return result;
}

}  // namespace

Digits digits_of(const std::vector<std::string_view>& cells) {
    Digits most;
    for (const std::string_view cell : cells) {
        const Digits own = digits_of(cell);
        most.significant = std::max(most.significant, own.significant);
        most.decimals = std::max(most.decimals, own.decimals);
    }
    return most;
}

double resolution_of(double value, const Digits& digits) {
    if (value == 0 || digits.significant == 0) return 0;
    const double by_digit =
        std::pow(10, std::floor(std::log10(std::abs(value))) - digits.significant + 1);
    return std::max(by_digit, std::pow(10.0, -digits.decimals));
}

namespace {

/// Ratio of the two definitions of the inertial number, rate a sqrt(rho/s22) over rate sqrt(m/(a
/// s22)) [1], with m = rho pi a^3/6.
const double diameter_density_convention = std::sqrt(6 / std::numbers::pi);

/// Factor that converts an angular velocity in a unit without an angle to rad/s, besides the factor
/// of the unit: 2 pi for a rotational speed and for frequencies in Hz, which count revolutions; 1
/// for 1/s, which is rad/s in SI.
/// @throws std::invalid_argument for other units, such as 1/min, which may count turns or radians
double angle_left_out(const Quantity& quantity, const Unit& unit) {
    const bool frequency = unit.spelling().ends_with("Hz");
    if (quantity.name == "rotational_speed" || frequency) return 2 * std::numbers::pi;
    if (unit.to_si(1) == 1) return 1;
    throw std::invalid_argument(
        fmt::format("'{}' leaves open whether it counts turns or radians; write 'rpm' or 'rad/min'",
                    unit.spelling()));
}

/// Factor, besides that of the unit, that converts numbers of a column to the quantity that the
/// column is read as (`read_as`).
/// @throws std::invalid_argument for a unit of the wrong dimension
double further_factor(const Quantity& quantity, const Unit& unit) {
    const bool angular = quantity.unit == "rad/s" || quantity.unit == "turn/s";
    if (angular && unit.same_dimension(Unit("1/s"))) return angle_left_out(quantity, unit);
    const Unit expected(quantity.unit);
    if (angular && unit.same_dimension(Unit("m/s")))
        throw std::invalid_argument(
            fmt::format("{}; write 'shear_velocity [{}]' if it is the speed at the mean radius",
                        wrong_dimension(unit, expected), unit.spelling()));
    if (!unit.same_dimension(expected))
        throw std::invalid_argument(wrong_dimension(unit, expected));
    return quantity.name == "inertial_number_diameter_density" ? 1 / diameter_density_convention
                                                               : 1;
}

/// Half the width of an interval that covers 95 % of a normal distribution, over its standard
/// deviation [1].
constexpr double normal_quantile_95 = 1.959964;

/// Quantity of whose values a column `NAME_n` has the number; null for other columns. The n must be
/// a small one: "normal_force_N" is a force in newtons.
const Quantity* quantity_with_number(std::string_view name) {
    constexpr std::string_view mark = "_n";
    if (!name.ends_with(mark)) return nullptr;
    return find_quantity(name.substr(0, name.size() - mark.size()));
}

}  // namespace

Columns::Columns(const Table& table) : table_(table) {
    for (const Cell& cell : table.header.cells)
        cells_.push_back(parse_header_cell(cell.text));
    for (std::size_t i = 0; i < cells_.size(); ++i)
        add(i);
}

void Columns::add(std::size_t index) {
    const HeaderCell& cell = cells_[index];
    const Quantity* const quantity = quantity_of_cell(cell.name, cell.unit);
    // "Shear velocity [1/s]" is a shear rate that nobody asked for, not a speed in a wrong unit.
    const bool other_velocity = quantity && quantity->name == "shear_velocity" &&
                                !cell.unit.empty() && !unit_fits(cell.unit, quantity->name);
    if (!quantity || other_velocity) {
        const Quantity* const counted = quantity_with_number(cell.name);
        counted ? numbers_.push_back({read_as(*counted), index}) : unknown_.push_back(index);
        return;
    }
    Column column{.name = read_as(*quantity), .mark = cell.mark, .index = index};
    if (!quantity->unit.empty()) {  // else a column of text
        try {
            const Unit unit(unit_of(cell, *quantity));
            column.relative = is_relative_error(cell, *quantity);
            const double further = column.relative ? 1 : further_factor(*quantity, unit);
            column.offset = cell.deviation() ? 0 : further * unit.to_si(0);
            column.factor = further * (unit.to_si(1) - unit.to_si(0));
        } catch (const std::invalid_argument& error) {
            column.wrong =
                fmt::format("column '{}': {}", table_.header.cells[index].text, error.what());
        }
    }
    columns_.push_back(column);
}

std::string Columns::unit_of(const HeaderCell& cell, const Quantity& quantity) const {
    if (!cell.unit.empty() || quantity.unit == "1") return cell.unit;
    if (cell.deviation()) {
        for (const HeaderCell& value : cells_)
            if (!value.deviation() && find_quantity(value.name) == &quantity) return value.unit;
    }
    const std::string_view usual = usual_unit(quantity.name);
    std::string advice = fmt::format("as in '{} [{}]'", cell.name, usual);
    if (usual != quantity.unit) advice += fmt::format(" or '{} [{}]'", cell.name, quantity.unit);
    throw std::invalid_argument(
        fmt::format("has no unit; add the one of its numbers, {}{}", advice, advice_on_units()));
}

std::string Columns::advice_on_units() const {
    std::vector<std::string> all;
    int lacking = 0;
    for (const HeaderCell& cell : cells_) {
        const Quantity* const quantity = find_quantity(cell.name);
        const bool lacks = quantity && !quantity->unit.empty() && quantity->unit != "1" &&
                           cell.unit.empty() && !cell.deviation();
        lacking += lacks;
        if (cell.deviation()) return "";
        all.push_back(fmt::format("\"{}{}\"", cell.name,
                                  lacks ? fmt::format(" [{}]", usual_unit(quantity->name))
                                  : cell.unit.empty() ? ""
                                                      : fmt::format(" [{}]", cell.unit)));
    }
    return lacking < 2 ? ""
                       : fmt::format(
                             "; or state all columns in study.toml, or for one file by "
                             "--columns, corrected where these guesses are wrong: columns = "
                             "[{}]",
                             fmt::join(all, ", "));
}

namespace {

/// Advice to name the column that is to be read as a quantity.
std::string or_name(std::string_view quantity, const Cell& header) {
    return fmt::format(", or name the one to be read: columns = {{ {} = \"{}\" }}", quantity,
                       header.text);
}

}  // namespace

const Columns::Column* Columns::find(std::string_view name, bool deviation) const {
    const Column* found = nullptr;
    for (const Column& column : columns_) {
        if (column.name != name || column.deviation() != deviation) continue;
        if (!column.wrong.empty()) throw InputError(table_.at_header(column.index), column.wrong);
        if (found)
            throw InputError(
                table_.at_header(column.index),
                fmt::format("'{0}' and '{1}' are the {2}; remove one{3}",
                            table_.header.cells[found->index].text,
                            table_.header.cells[column.index].text,
                            deviation ? "error of one quantity" : "same quantity",
                            deviation ? "" : or_name(name, table_.header.cells[found->index])));
        found = &column;
    }
    return found;
}

std::string Columns::advice_on_unused(std::string_view name) const {
    std::string advice;
    for (const std::size_t i : unknown_) {
        const HeaderCell& cell = cells_[i];
        if (cell.deviation() || cell.unit.empty() || !unit_fits(cell.unit, name)) continue;
        advice += fmt::format("; if it is '{}', write columns = {{ {} = \"{} [{}]\" }}",
                              table_.header.cells[i].text, name, cell.name, cell.unit);
    }
    return advice;
}

void Columns::require(std::string_view name) const {
    if (has(name)) return;
    const std::string wanted = fmt::format("'{} [{}]'", name, quantity(name).unit);
    refuse_missing(name == "height" ? wanted +
                                          " (the gap; without a gap sensor, enter the solid "
                                          "fractions in a table [[readings]])"
                                    : wanted,
                   advice_on_unused(name));
}

std::string_view Columns::require_one_of(std::string_view first, std::string_view second) const {
    if (has(first) && has(second))
        throw InputError(table_.at_header(find(second, false)->index),
                         fmt::format("both '{}' and '{}' are given; remove one", first, second));
    if (!has(first) && !has(second))
        refuse_missing(fmt::format("'{} [{}]' or '{} [{}]'", first, quantity(first).unit, second,
                                   quantity(second).unit),
                       advice_on_unused(first) + advice_on_unused(second));
    return has(first) ? first : second;
}

void Columns::refuse_missing(std::string_view wanted, const std::string& advice) const {
    std::vector<std::string> found;
    for (const Cell& cell : table_.header.cells)
        found.push_back(cell.text);
    throw InputError({table_.file, table_.header.line},
                     fmt::format("column {} is missing; the header has '{}'{}", wanted,
                                 fmt::join(found, "', '"), advice));
}

namespace {

/// Says why a text is no number.
std::string no_number(std::string_view text) {
    std::string_view rest = text;
    if (take_number(rest) && !rest.empty()) {
        if (trimmed(rest).starts_with("±") || trimmed(rest).starts_with("+/-"))
            return fmt::format(
                "\"{}\" holds a number and its error; write the errors into a column "
                "of their own, behind this one, with the name '±'",
                text);
        if (is_unit(trimmed(rest)) && !Unit(trimmed(rest)).dimension().empty())
            return fmt::format(
                "\"{}\" holds a number and its unit; write the unit into the name "
                "of the column, as '[{}]', and numbers alone into the cells",
                text, trimmed(rest));
    }
    return fmt::format("\"{}\" is not a finite number; correct it or remove the line", text);
}

}  // namespace

double Columns::number(const Row& row, const Column& column) const {
    const std::string& text = row.cells[column.index].text;
    if (const auto value = parse_number(text)) {
        const double number = column.factor * *value + column.offset;
        if (const auto why = beyond_measure(number))
            throw InputError(table_.at(row, column.index),
                             fmt::format("column '{}': \"{}\" {}",
                                         table_.header.cells[column.index].text, text, *why));
        return number;
    }
    std::string wrong = no_number(text);
    if (text.empty()) wrong = "the cell is empty; fill it in or remove the line";
    if (text.starts_with('='))
        wrong = fmt::format(
            "the formula \"{}\" has no stored result; open the workbook in a spreadsheet program "
            "and "
            "save it",
            text);
    if (text.starts_with('#'))
        wrong =
            fmt::format("the formula gives the error \"{}\"; correct it or remove the row", text);
    if (has_decimal_comma(text)) {
        std::ptrdiff_t others = -1;
        for (const Row& each : table_.rows)
            others += std::count_if(each.cells.begin(), each.cells.end(),
                                    [](const Cell& cell) { return has_decimal_comma(cell.text); });
        wrong = fmt::format(
            "\"{}\" is not a number with decimal point '.'; this file uses ',' in "
            "{} other cells: export it with decimal points",
            text, others);
    }
    throw InputError(table_.at(row, column.index),
                     fmt::format("column '{}': {}", table_.header.cells[column.index].text, wrong));
}

double Columns::value(const Row& row, std::string_view name) const {
    return number(row, *find(name, false));
}

std::optional<double> Columns::value_if_any(const Row& row, std::string_view name) const {
    const Column* const column = find(name, false);
    if (!column || row.cells[column->index].text.empty()) return std::nullopt;
    return number(row, *column);
}

std::optional<Columns::Conversion> Columns::conversion(std::string_view name) const {
    const Column* const column = find(name, false);
    if (!column) return std::nullopt;
    return Conversion{column->index, column->factor, column->offset};
}

std::optional<double> Columns::standard_error(const Row& row, std::string_view name) const {
    const Column* const column = find(name, true);
    if (!column || row.cells[column->index].text.empty()) return std::nullopt;
    const double stated = number(row, *column);
    if (stated < smallest_magnitude)
        throw InputError(
            table_.at(row, column->index),
            fmt::format("column '{}': {} must be positive; leave the cell empty where "
                        "it is not known",
                        table_.header.cells[column->index].text,
                        column->mark == ErrorMark::standard_deviation ? "a standard deviation"
                                                                      : "an error"));
    const double size = column->relative ? std::abs(value_if_any(row, name).value_or(0)) : 1;
    if (column->mark == ErrorMark::half_width) return size * stated / normal_quantile_95;
    const NumberOfValues* const values = number_of_values(name);
    return size * (values ? stated / std::sqrt(values_in(row, *values)) : stated);
}

const Columns::NumberOfValues* Columns::number_of_values(std::string_view name) const {
    const auto found = std::ranges::find(numbers_, name, &NumberOfValues::name);
    return found == numbers_.end() ? nullptr : &*found;
}

double Columns::values_in(const Row& row, const NumberOfValues& column) const {
    const auto count = parse_number(row.cells[column.index].text);
    if (!count || !(*count >= 2) || *count != std::floor(*count))
        throw InputError(
            table_.at(row, column.index),
            fmt::format("column '{}': \"{}\" is not the number of values of a standard deviation; "
                        "write a whole number of at least 2",
                        table_.header.cells[column.index].text, row.cells[column.index].text));
    return *count;
}

std::optional<std::size_t> Columns::place_of_error(std::string_view name) const {
    const Column* const column = find(name, true);
    return column ? std::optional(column->index) : std::nullopt;
}

void Columns::check_numbers_of_values() const {
    for (const NumberOfValues& values : numbers_) {
        const Column* const column = find(values.name, true);
        if (column && column->mark == ErrorMark::standard_deviation &&
            number_of_values(values.name) == &values)
            continue;
        throw InputError(
            table_.at_header(values.index),
            fmt::format("column '{}' is the number of values of a standard deviation; write that "
                        "into one column '{}_sd', or remove this one",
                        table_.header.cells[values.index].text, values.name));
    }
}

std::vector<std::string> Columns::deviations_without_number() const {
    std::vector<std::string> result;
    for (const Column& column : columns_)
        if (column.mark == ErrorMark::standard_deviation && !number_of_values(column.name))
            result.push_back(table_.header.cells[column.index].text);
    return result;
}

std::vector<double> Columns::resolutions(std::string_view name) const {
    std::vector<double> result(table_.rows.size(), 0.0);
    const Column* column = find(name, false);
    if (!column) return result;
    std::vector<std::string_view> cells;
    for (const Row& row : table_.rows)
        cells.push_back(row.cells[column->index].text);
    const Digits digits = digits_of(cells);
    for (std::size_t k = 0; k < result.size(); ++k) {
        if (cells[k].empty()) continue;
        const double written = (number(table_.rows[k], *column) - column->offset) / column->factor;
        result[k] = resolution_of(written, digits) * column->factor;
    }
    return result;
}

Position Columns::at(const Row& row, std::string_view name) const {
    const Column* const column = find(name, false);
    return column ? table_.at(row, column->index) : Position{table_.file, row.line, 0};
}

std::vector<std::string> Columns::others(const std::vector<std::string_view>& used) const {
    std::vector<std::string> result;
    for (std::size_t i = 0; i < table_.header.cells.size(); ++i) {
        const std::string& text = table_.header.cells[i].text;
        const auto is_used = [&](std::string_view name, bool error) {
            return std::ranges::count(used, fmt::format("{}{}", name, error ? "_sd" : "")) > 0;
        };
        const bool known = std::ranges::any_of(columns_,
                                               [&](const Column& column) {
                                                   return column.index == i &&
                                                          is_used(column.name, column.deviation());
                                               }) ||
                           std::ranges::any_of(numbers_, [&](const NumberOfValues& column) {
                               return column.index == i && is_used(column.name, true);
                           });
        if (!known && !text.empty()) result.push_back(text);
    }
    return result;
}

}  // namespace pendular
