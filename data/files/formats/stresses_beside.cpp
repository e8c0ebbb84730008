#include "data/files/formats/stresses_beside.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <optional>
#include <set>
#include <string_view>

#include "data/files/column_names.h"
#include "data/files/folded_name.h"
#include "data/files/formats/cell_bytes.h"
#include "data/files/header_cell.h"
#include "data/files/text_pattern.h"
#include "data/quantities/number.h"

namespace pendular {
namespace {

/// Lines among which the first numbers are sought, as in preamble.cpp; lines that name the columns;
/// columns that are looked at; bytes of all tables, so that a small file cannot use much memory.
constexpr std::size_t lines_before_numbers = 200, most_lines_of_names = 3,
                      most_columns_of_stresses = 100, most_bytes_of_parts = std::size_t(1) << 26;

/// Cells above a column, taken apart.
struct Heading {
    std::string name, unit;  ///< of the quantity, or all that is said of another column
    std::string quantity;    ///< "shear_stress", "torque", another, or none
    std::string label;       ///< further words of a stress
    bool of_errors = false;
};

bool is_stress(const Heading& heading) {
    return !heading.of_errors &&
           (heading.quantity == "shear_stress" || heading.quantity == "torque");
}

bool is_load(const Heading& heading) {
    return !heading.of_errors &&
           (heading.quantity == "normal_stress" || heading.quantity == "normal_force");
}

std::string quantity_of(std::string_view name, std::string_view unit) {
    if (const Quantity* const own = quantity_of_cell(name, unit)) return std::string(own->name);
    const ColumnMeaning meaning = meaning_of_column(name, unit);
    return meaning.shared ? "" : std::string(meaning.quantity);
}

std::string bare_label(std::string_view text) {
    constexpr std::string_view around = " \t_-,:;()[]";
    const std::size_t begin = text.find_first_not_of(around);
    if (begin == std::string_view::npos) return "";
    const std::size_t end = text.find_last_not_of(around);
    std::string label(text.substr(begin, end - begin + 1));
    for (const std::string_view dash : {"– ", "— "})
        if (label.starts_with(dash)) label.erase(0, dash.size());
    return label;
}

/// A name such as "Shear stress dry" or "Dry τ", taken apart; its quantity is empty if it names no
/// stress.
Heading apart(const std::string& name, const std::string& unit) {
    const auto named = [&](std::string_view part) {
        Heading heading{std::string(trimmed(part)), unit, "", "", false};
        heading.quantity = quantity_of(heading.name, unit);
        return heading;
    };
    constexpr std::string_view between = " _,-:([";
    for (std::size_t at = name.find_last_of(between); at != std::string::npos && at > 0;
         at = name.find_last_of(between, at - 1))
        if (Heading heading = named(name.substr(0, at)); is_stress(heading)) {
            heading.label = bare_label(std::string_view(name).substr(at));
            return heading;
        }
    for (std::size_t at = name.find_first_of(between); at != std::string::npos;
         at = name.find_first_of(between, at + 1))
        if (Heading heading = named(name.substr(at + 1)); is_stress(heading)) {
            heading.label = bare_label(std::string_view(name).substr(0, at));
            return heading;
        }
    return {};
}

Heading heading_of(const std::string& text) {
    const HeaderCell cell = parse_header_cell(text);
    Heading whole{cell.name, cell.unit, quantity_of(cell.name, cell.unit), "", false};
    whole.of_errors = cell.deviation() || bare_mark(cell) != ErrorMark::none;
    if (whole.of_errors || !whole.quantity.empty()) return whole;
    // "Contrainte de cisaillement (kPa) - sec"
    static const TextPattern unit_within(R"(^([^()\[\]]+)[\[(]([^()\[\]]+)[\])](.+)$)");
    constexpr std::size_t longest = 200;  // bytes; longer texts are no names
    if (text.size() > longest) return whole;
    std::string name = cell.name, unit = cell.unit;
    if (const auto found = unit_within.whole(text); unit.empty() && found)
        if (unit_fits(found->parts[2], "shear_stress") || unit_fits(found->parts[2], "torque")) {
            name = found->parts[1] + " " + found->parts[3];
            unit = found->parts[2];
        }
    Heading stress = apart(name, unit);
    return stress.quantity.empty() ? whole : stress;
}

/// Joins what several lines say of a column.
void add(Heading& heading, const std::string& text) {
    if (text.empty()) return;
    const std::string unit = bare_unit(text);
    const bool named = !heading.quantity.empty();
    if (named && heading.unit.empty() && is_unit(unit) && unit_fits(unit, heading.quantity)) {
        heading.unit = unit;
        return;
    }
    Heading own = heading_of(text);
    if (named && own.quantity.empty() && !own.of_errors) {
        heading.label += (heading.label.empty() ? "" : " ") + bare_label(text);
    } else if (heading.name.empty() || !own.quantity.empty() || own.of_errors) {
        own.label = bare_label(heading.quantity.empty() ? heading.name + " " + own.label
                                                        : heading.label + " " + own.label);
        if (own.unit.empty()) own.unit = heading.unit;
        heading = std::move(own);
    } else {
        heading.name += " " + text;
    }
}

/// Lines that name the columns: those above the first row of numbers.
struct Names {
    std::size_t begin = 0, end = 0;  ///< indices of the first line, and of the one behind the last
    std::vector<Heading> headings;
};

/// Index of the first line that may be a row; the number of lines if there is none.
std::size_t first_row(const SourceLines& source, char delimiter) {
    constexpr int fewest = 3;  // a load and two stresses
    for (std::size_t i = 0; i < std::min(source.lines.size(), lines_before_numbers); ++i)
        if (const Row row = source.row(i, delimiter);
            std::ranges::count_if(row.cells,
                                  [](const Cell& cell) { return is_number(cell.text); }) >= fewest)
            return i;
    return source.lines.size();
}

/// Fills the cells right of the name of a stress that stands over several columns, of which each
/// has words of its own in the last line.
void spread_stress(Row& row, const Row& last) {
    for (std::size_t i = 1; i < std::min(row.cells.size(), last.cells.size()); ++i)
        if (row.cells[i].text.empty() && !last.cells[i].text.empty() &&
            is_stress(heading_of(row.cells[i - 1].text)))
            row.cells[i].text = row.cells[i - 1].text;
}

Names names_above(const SourceLines& source, std::size_t row, char delimiter) {
    Names names{row, row, {}};
    std::vector<Row> lines;
    while (names.begin > 0 && lines.size() < most_lines_of_names) {
        Row line = source.row(names.begin - 1, delimiter);
        const auto filled =
            std::ranges::find_if(line.cells, [](const Cell& c) { return !c.text.empty(); });
        if (filled == line.cells.end() || line.cells.size() > most_columns_of_stresses) break;
        // A text in the first cell alone is a title.
        if (filled == line.cells.begin() && filled_cells(line) == 1) break;
        --names.begin;
        lines.insert(lines.begin(), std::move(line));
    }
    for (Row& line : lines) {
        if (lines.size() > 1) spread_stress(line, lines.back());
        names.headings.resize(std::max(names.headings.size(), line.cells.size()));
        for (std::size_t i = 0; i < line.cells.size(); ++i)
            add(names.headings[i], line.cells[i].text);
    }
    return names;
}

/// Whether words number repetitions: "2", "test 2".
bool numbers_repetition(std::string_view label) {
    static const TextPattern numbered(
        "(?:(?:run|test|repeat|replicate|essai|versuch|messung|mesure|prova|ensayo|prueba|"
        "wiederholung|lauf|n|no|nr)[ .°_]*)?[0-9]{1,2}");
    return numbered.whole(lower_case(label)).has_value();
}

/// Whether words may be those of a material, a liquid or a load.
bool may_tell_apart(std::string_view label) {
    static constexpr std::array others = {
        "mean",       "average",   "avg",       "moyenne",    "moyen",        "mittel",
        "mittelwert", "media",     "medio",     "median",     "max",          "maximum",
        "maximal",    "maximale",  "maxi",      "massimo",    "massima",      "maximo",
        "maxima",     "min",       "minimum",   "minimal",    "minimale",     "mini",
        "minimo",     "minima",    "peak",      "pic",        "picco",        "pico",
        "spitze",     "residual",  "residuel",  "residuelle", "residuo",      "residua",
        "residuale",  "rest",      "steady",    "final",      "initial",      "start",
        "end",        "raw",       "roh",       "brut",       "brute",        "crudo",
        "grezzo",     "corrected", "corr",      "korrigiert", "corrige",      "corrigee",
        "corregido",  "corretto",  "smoothed",  "filtered",   "gefiltert",    "filtre",
        "set",        "soll",      "target",    "error",      "err",          "sd",
        "std",        "se",        "cv",        "sensor",     "channel",      "kanal",
        "left",       "right",     "links",     "rechts",     "before",       "after",
        "preshear",   "model",     "fit",       "predicted",  "calculated",   "run",
        "test",       "repeat",    "replicate", "essai",      "versuch",      "messung",
        "mesure",     "prova",     "ensayo",    "prueba",     "wiederholung", "lauf",
        "n"};
    static const TextPattern word(R"([^\s_,;:()\[\]]+)");
    bool any_word = false;
    for (const PatternMatch& each : word.all(label)) {
        const std::string& text = each.parts[0];
        if (std::ranges::find(others, folded_name(text)) != others.end()) return false;
        any_word = any_word || !is_number(text);
    }
    return any_word;
}

/// Columns of the stresses that make tables of their own; none if this is no such table.
std::vector<std::size_t> stresses_of(const std::vector<Heading>& headings) {
    std::vector<std::size_t> columns;
    std::set<std::string> labels;
    std::size_t loads = 0, repetitions = 0;
    for (std::size_t i = 0; i < headings.size(); ++i) {
        const Heading& heading = headings[i];
        loads += is_load(heading);
        if (heading.quantity == "time") return {};
        if (!is_stress(heading)) continue;
        if (heading.quantity != headings[columns.empty() ? i : columns.front()].quantity ||
            !(may_tell_apart(heading.label) || numbers_repetition(heading.label)) ||
            !labels.insert(folded_name(heading.label)).second)
            return {};
        columns.push_back(i);
        repetitions += numbers_repetition(heading.label);
    }
    if (repetitions != 0 && repetitions != columns.size()) return {};
    return loads == 1 && columns.size() > 1 ? columns : std::vector<std::size_t>();
}

/// Line whose cells are replaced by texts, of which those without a value stay as they are. Blanks
/// keep the places of the cells behind; in a sheet a cell's place is its number.
std::string with_cells(const SourceLines& source, std::size_t line, char delimiter,
                       const std::vector<std::optional<std::string>>& texts) {
    const std::string_view whole = source.lines[line];
    const std::vector<std::size_t> bytes = bytes_of_cells(whole, delimiter);
    std::string result;
    for (std::size_t i = 0; i + 1 < bytes.size(); ++i) {
        const std::string_view old = whole.substr(bytes[i], bytes[i + 1] - 1 - bytes[i]);
        if (i > 0) result += delimiter;
        const bool kept = i >= texts.size() || !texts[i];
        const std::string text(kept ? old : *texts[i]);
        result += text;
        const std::size_t width = characters_in(old), own = characters_in(text);
        if (!source.of_sheet && own < width) result.append(width - own, ' ');
    }
    return result;
}

std::string header_text(const Heading& heading) {
    const std::string unit = heading.unit.empty() ? "" : fmt::format(" [{}]", heading.unit);
    return heading.name + unit;
}

/// Table with the stresses of one column; their errors may stand in the next.
TablePart table_of_stress(const SourceLines& source, char delimiter, const Names& names,
                          const std::vector<std::size_t>& stresses, std::size_t column,
                          std::deque<std::string>& texts) {
    std::vector<std::optional<std::string>> header, cells(names.headings.size());
    for (std::size_t i = 0; i < names.headings.size(); ++i) {
        const auto next = std::ranges::upper_bound(stresses, i);
        const bool is_other = (is_stress(names.headings[i]) || names.headings[i].of_errors) &&
                              next != stresses.begin() && *std::prev(next) != column;
        if (is_other) cells[i] = "";
        header.emplace_back(is_other ? "" : header_text(names.headings[i]));
    }
    const std::string& label = names.headings[column].label;
    TablePart part{numbers_repetition(label) ? "repetitions" : label, source};
    for (std::size_t i = names.begin; i < source.lines.size(); ++i) {
        const bool is_header = i + 1 == names.end;
        if (i + 1 < names.end)
            part.source.lines[i] = {};
        else
            part.source.lines[i] =
                texts.emplace_back(with_cells(source, i, delimiter, is_header ? header : cells));
    }
    return part;
}

}  // namespace

SeveralTables stresses_beside(const SourceLines& source, char delimiter) {
    const std::size_t row = first_row(source, delimiter);
    if (row == source.lines.size()) return {};
    const Names names = names_above(source, row, delimiter);
    const std::vector<std::size_t> stresses = stresses_of(names.headings);
    std::size_t bytes = 0;
    for (const std::string_view line : source.lines)
        bytes += line.size() + names.headings.size();
    SeveralTables found;
    if (stresses.empty() || bytes > most_bytes_of_parts / stresses.size()) return found;
    for (const std::size_t column : stresses)
        found.parts.push_back(
            table_of_stress(source, delimiter, names, stresses, column, found.texts));
    return found;
}

}  // namespace pendular
