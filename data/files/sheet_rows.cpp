#include "data/files/sheet_rows.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <optional>
#include <regex>

#include "data/files/csv.h"
#include "data/files/xml_nodes.h"
#include "data/input_error.h"
#include "data/quantities/number.h"

namespace pendular {
namespace {

/// Place of a cell, from 0.
struct CellPlace {
    std::size_t row = 0, column = 0;
    auto operator<=>(const CellPlace&) const = default;
};

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
    static const std::regex escape("_x00([0-7][0-9A-Fa-f])_");
    std::string result;
    auto from = text.begin();
    for (std::sregex_iterator each(text.begin(), text.end(), escape), end; each != end; ++each) {
        result.append(from, text.begin() + each->position());
        result += static_cast<char>(std::stoi((*each)[1].str(), nullptr, 16));
        from = text.begin() + each->position() + each->length();
    }
    return result.append(from, text.end());
}

/// Whether a node is a cell with a value, or with a formula whose value is missing; blank cells may
/// have a style alone.
bool has_value(const pugi::xml_node& node) {
    return local_name(node.name()) == "c" &&
           (child_named(node, "v") || child_named(node, "is") || child_named(node, "f"));
}

/// Writes the rows of a sheet as lines.
class SheetWriter {
  public:
    SheetWriter(const std::string& file, const SharedParts& shared)
        : file_(file), shared_(shared) {}

    void read_merged(const pugi::xml_node& merged) {
        for (const pugi::xml_node& each : merged.children()) {
            const std::string_view range = each.attribute("ref").value();
            const std::size_t colon = range.find(':');
            const auto first = place_of(range.substr(0, colon));
            const auto last =
                colon == std::string_view::npos ? std::nullopt : place_of(range.substr(colon + 1));
            if (first && last) merged_[*first] = *last;
        }
    }

    SheetText rows_of(const pugi::xml_node& data) {
        std::size_t width = 0;
        for (const pugi::xml_node& row : data.children())
            width = std::max(width, width_of(row));
        cells_.resize(width);
        std::size_t cells = 0;
        for (const pugi::xml_node& row : data.children()) {
            if (local_name(row.name()) != "row") continue;
            const std::size_t number = row.attribute("r").as_uint(0);
            if (number > most_rows) refuse_rows(number);
            while (lines_ + 1 < number)
                add_line("");
            if (width_of(row) == 0) {
                add_line("");
                continue;
            }
            check_cell_count(cells += width, file_, line());
            if (row.attribute("hidden").as_bool()) add_hidden();
            add_row(row);
        }
        return std::move(result_);
    }

  private:
    static constexpr std::size_t most_rows = 1'048'576;  // 2^20, the limit of the format

    /// Number in a merged cell, which stands in the rows up to `last`.
    struct Held {
        std::string text;
        std::size_t last;
    };

    int line() const { return static_cast<int>(lines_) + 1; }

    [[noreturn]] void refuse_rows(std::size_t number) const {
        throw InputError({file_},
                         fmt::format("row {}: a sheet has at most {} rows", number, most_rows));
    }

    static std::size_t width_of(const pugi::xml_node& row) {
        std::size_t next = 0, width = 0;
        for (const pugi::xml_node& cell : row.children()) {
            if (local_name(cell.name()) != "c") continue;
            next = column_of(cell.attribute("r").value(), next) + 1;
            if (has_value(cell)) width = next;
        }
        return width;
    }

    void add_line(std::string_view text) {
        result_.text += text;
        result_.text += '\n';
        ++lines_;
    }

    void add_hidden() {
        auto& hidden = result_.hidden;
        if (!hidden.empty() && hidden.back().second + 1 == line())
            hidden.back().second = line();
        else
            hidden.emplace_back(line(), line());
    }

    /// Text of a cell, without tabs and line ends.
    std::string text_of_cell(const pugi::xml_node& cell) const {
        const std::string_view type = cell.attribute("t").value();
        const pugi::xml_node value = child_named(cell, "v"), formula = child_named(cell, "f");
        std::string text = value.child_value();
        if (type == "inlineStr") text = text_of_item(child_named(cell, "is"));
        if (type == "s") {
            const auto index = parse_number(text);
            const bool known =
                index && *index >= 0 && *index < static_cast<double>(shared_.strings.size());
            text = known ? shared_.strings[static_cast<std::size_t>(*index)] : "";
        }
        if (type == "b") text = text == "1" ? "TRUE" : "FALSE";  // no number
        if (type.empty() || type == "n")
            text = shared_.formats.text_of(text, cell.attribute("s").as_uint(0));
        // A formula that gives a text without characters has an empty result.
        if (formula && (!value || (text.empty() && type != "str")))
            text = std::string("=") + formula.child_value();
        text = unescaped(text);
        for (char& c : text)
            if (c == '\t' || c == '\n' || c == '\r') c = ' ';
        return std::string(trimmed(text));
    }

    /// Keeps a number in a merged cell for the rows below.
    void hold(std::size_t column, const std::string& text) {
        const auto merged = merged_.find({lines_, column});
        if (merged == merged_.end() || !parse_number(text)) return;
        const CellPlace& last = merged->second;
        if (last.column > column) {
            result_.wide.push_back(
                {line(), static_cast<int>(column) + 1, static_cast<int>(last.column) + 1, text});
            return;
        }
        held_[column] = {text, last.row};
    }

    void add_row(const pugi::xml_node& row) {
        std::ranges::fill(cells_, std::string());
        std::size_t next = 0;
        for (const pugi::xml_node& cell : row.children()) {
            if (local_name(cell.name()) != "c") continue;
            const std::size_t column = column_of(cell.attribute("r").value(), next);
            if (column < next)
                throw InputError({file_, line()},
                                 "the cells of this row are not in order; save the workbook anew");
            next = column + 1;
            if (!has_value(cell)) continue;
            cells_[column] = text_of_cell(cell);
            if (!merged_.empty()) hold(column, cells_[column]);
        }
        std::erase_if(held_, [&](const auto& each) { return each.second.last < lines_; });
        for (const auto& [column, held] : held_)
            if (cells_[column].empty()) cells_[column] = held.text;
        write_cells();
    }

    void write_cells() {
        for (std::size_t i = 0; i < cells_.size(); ++i) {
            if (i > 0) result_.text += '\t';
            const std::string text = csv_cell(cells_[i]);  // delimiters and quotes within are none
            result_.text += text.starts_with('#') ? '"' + text + '"' : text;  // no comment
        }
        add_line("");
    }

    const std::string& file_;
    const SharedParts& shared_;
    SheetText result_;
    std::size_t lines_ = 0;
    std::vector<std::string> cells_;         ///< of the present row
    std::map<CellPlace, CellPlace> merged_;  ///< last place of merged cells, by the first
    std::map<std::size_t, Held> held_;       ///< by column
};

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
    SheetWriter writer(file, shared);
    writer.read_merged(child_named(worksheet, "mergeCells"));
    return writer.rows_of(child_named(worksheet, "sheetData"));
}

}  // namespace pendular
