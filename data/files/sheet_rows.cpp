#include "data/files/sheet_rows.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "data/files/text_pattern.h"
#include "data/files/xml_nodes.h"
#include "data/input_error.h"
#include "data/quantities/number.h"

namespace pendular {
namespace {

/// Column, from 0, of a reference such as "AB12"; `next` if there is none. Long references end
/// before the number overflows, far beyond the columns that are read.
std::size_t column_of(std::string_view reference, std::size_t next) {
    std::size_t column = 0;
    for (const char c : reference) {
        if (c < 'A' || c > 'Z' || column > 100'000) break;
        column = 26 * column + static_cast<std::size_t>(c - 'A') + 1;
    }
    return column == 0 ? next : column - 1;
}

/// Place of a reference such as "AB12"; empty for other texts.
std::optional<CellPlace> place_of(std::string_view reference) {
    const std::size_t digits = reference.find_first_of("0123456789");
    constexpr std::size_t none = 1'000'000;
    const std::size_t column = column_of(reference, none);
    if (digits == std::string_view::npos || column == none) return std::nullopt;
    const double row = parse_number(reference.substr(digits)).value_or(0);
    if (!(row >= 1 && row < 1e9)) return std::nullopt;
    return CellPlace{static_cast<std::size_t>(row) - 1, column};
}

/// Text with the escapes of ASCII characters, such as "_x000D_" for a carriage return, replaced.
std::string unescaped(const std::string& text) {
    if (text.find("_x00") == std::string::npos) return text;
    static const TextPattern escape("_x00([0-7][0-9A-Fa-f])_");
    std::string result;
    std::size_t from = 0;
    for (const PatternMatch& each : escape.all(text)) {
        result.append(text, from, each.begin - from);
        result += static_cast<char>(std::stoi(each.parts[1], nullptr, 16));
        from = each.end;
    }
    return result.append(text, from);
}

/// Whether a node is a cell with a value, or with a formula whose value is missing; blank cells may
/// have a style alone.
bool has_value(const pugi::xml_node& node) {
    return local_name(node.name()) == "c" &&
           (child_named(node, "v") || child_named(node, "is") || child_named(node, "f"));
}

std::size_t width_of_row(const pugi::xml_node& row) {
    std::size_t next = 0, width = 0;
    for (const pugi::xml_node& cell : row.children()) {
        if (local_name(cell.name()) != "c") continue;
        next = column_of(cell.attribute("r").value(), next) + 1;
        if (has_value(cell)) width = next;
    }
    return width;
}

/// Number without zeros behind its decimals, by which texts such as "1.000" are known.
std::string without_last_zeros(std::string number) {
    const bool plain = number.find_first_not_of("+-0123456789.") == std::string::npos;
    if (!plain || number.find('.') == std::string::npos) return number;
    number.erase(number.find_last_not_of('0') + 1);
    if (number.ends_with('.')) number.pop_back();
    return number;
}

std::string text_of_cell(const pugi::xml_node& cell, const SharedParts& shared) {
    const std::string_view type = cell.attribute("t").value();
    const pugi::xml_node value = child_named(cell, "v"), formula = child_named(cell, "f");
    std::string text = value.child_value();
    if (type == "inlineStr") text = text_of_item(child_named(cell, "is"));
    if (type == "s") {
        const auto index = parse_number(text);
        const bool known =
            index && *index >= 0 && *index < static_cast<double>(shared.strings.size());
        text = known ? shared.strings[static_cast<std::size_t>(*index)] : "";
    }
    if (type == "b") text = text == "1" ? "TRUE" : "FALSE";  // no number
    if (type.empty() || type == "n")
        text = without_last_zeros(shared.formats.text_of(text, cell.attribute("s").as_uint(0)));
    // A formula without a stored result is shown as "=...". Type str without characters is a
    // result.
    if (formula && (!value || (text.empty() && type != "str")))
        text = std::string("=") + formula.child_value();
    return unescaped(text);
}

void read_merged(const pugi::xml_node& merged, SheetLines& lines) {
    for (const pugi::xml_node& each : merged.children()) {
        const std::string_view range = each.attribute("ref").value();
        const std::size_t colon = range.find(':');
        const auto first = place_of(range.substr(0, colon));
        const auto last =
            colon == std::string_view::npos ? std::nullopt : place_of(range.substr(colon + 1));
        if (first && last) lines.merge(*first, *last);
    }
}

/// Adds a row with values.
void add_row(const pugi::xml_node& row, const std::string& file, const SharedParts& shared,
             SheetLines& lines) {
    lines.begin_row(row.attribute("hidden").as_bool());
    std::size_t next = 0;
    for (const pugi::xml_node& cell : row.children()) {
        if (local_name(cell.name()) != "c") continue;
        const std::size_t column = column_of(cell.attribute("r").value(), next);
        if (column < next)
            throw InputError({file, lines.line()},
                             "the cells of this row are not in order; save the workbook anew");
        next = column + 1;
        if (!has_value(cell)) continue;
        const std::string_view type = cell.attribute("t").value();
        const bool percent = (type.empty() || type == "n") &&
                             shared.formats.shows_percent(cell.attribute("s").as_uint(0));
        lines.set(column, text_of_cell(cell, shared), percent);
    }
    lines.end_row();
}

}  // namespace

std::string text_of_item(const pugi::xml_node& item) {
    std::string text;
    for (const pugi::xml_node& each : item.children()) {
        const std::string_view name = local_name(each.name());
        if (name == "t") text += each.child_value();
        if (name == "r") text += child_named(each, "t").child_value();
    }
    return text;
}

SheetText rows_of_sheet(const pugi::xml_node& worksheet, const std::string& file,
                        const SharedParts& shared) {
    constexpr std::size_t most_rows = 1'048'576;  // 2^20, the limit of the format
    const pugi::xml_node data = child_named(worksheet, "sheetData");
    std::size_t width = 0;
    for (const pugi::xml_node& row : data.children())
        width = std::max(width, width_of_row(row));
    SheetLines lines(file, width);
    read_merged(child_named(worksheet, "mergeCells"), lines);
    for (const pugi::xml_node& row : data.children()) {
        if (local_name(row.name()) != "row") continue;
        const std::size_t number = row.attribute("r").as_uint(0);
        if (number > most_rows)
            throw InputError({file},
                             fmt::format("row {}: a sheet has at most {} rows", number, most_rows));
        if (number > 0) lines.add_empty_until(number - 1);
        if (width_of_row(row) == 0)
            lines.add_empty_until(lines.lines() + 1);
        else
            add_row(row, file, shared, lines);
    }
    return lines.take();
}

}  // namespace pendular
