#include <fmt/format.h>

#include <algorithm>

#include "data/files/formats/layouts.h"
#include "data/quantities/number.h"

namespace pendular {
namespace {

/// Cells of a line without the empty cells at its end.
std::vector<std::string> filled_cells(const SourceLines& source, std::size_t line, char delimiter) {
    std::vector<std::string> cells;
    for (const Cell& cell : source.row(line, delimiter).cells)
        cells.push_back(cell.text);
    while (!cells.empty() && cells.back().empty())
        cells.pop_back();
    return cells;
}

bool is_count(const std::string& text) {
    return !text.empty() && text.size() < 9 &&
           std::all_of(text.begin(), text.end(), [](char c) { return c >= '0' && c <= '9'; });
}

/// Whether a line begins an interval, in any language: `Interval and data points: | 4 | 300`.
bool begins_interval(const std::vector<std::string>& cells) {
    return cells.size() == 3 && cells[0].ends_with(':') && is_count(cells[1]) && is_count(cells[2]);
}

/// Delimiter after the first text with a colon that two numbers follow; 0 if there is none.
char interval_delimiter(const SourceLines& source) {
    for (std::size_t i = 0; i < std::min<std::size_t>(source.lines.size(), 200); ++i) {
        const std::size_t colon = source.lines[i].find(':');
        if (colon == std::string_view::npos || colon + 1 == source.lines[i].size()) continue;
        const char delimiter = source.lines[i][colon + 1];
        if (delimiter != '\t' && delimiter != ';' && delimiter != ',') continue;
        if (begins_interval(filled_cells(source, i, delimiter))) return delimiter;
    }
    return 0;
}

/// Reads a RheoCompass export from its first to its last line.
class RheoCompassReader {
  public:
    RheoCompassReader(const SourceLines& source, BlockFile& file)
        : source_(source), file_(file), delimiter_(interval_delimiter(source)) {}

    void read() {
        file_.delimiter = delimiter_;
        while (line_ < source_.lines.size()) {
            const auto cells = filled_cells(source_, line_, delimiter_);
            if (begins_interval(cells)) {
                read_interval(cells);
            } else {
                if (cells.size() == 2 && cells[0].ends_with(':')) add_fact(cells);
                // Values whose interval has ended, by a blank line within it for example.
                if (!file_.blocks.empty() && !cells.empty() && cells[0].empty())
                    skip_line(file_, static_cast<int>(line_) + 1, Remark::Kind::after_interval);
                ++line_;
            }
        }
    }

  private:
    /// Largest number of facts of a test, and largest number of characters of its name, which
    /// consists of them and is kept with every interval: 300,000 keys took all memory or time.
    static constexpr std::size_t most_facts = 100, longest_test = 10'000;

    /// Keeps a fact such as `Result: | Flow Curve 1`. Facts from a repeated key on begin a new
    /// test.
    void add_fact(const std::vector<std::string>& cells) {
        const std::string key = cells[0].substr(0, cells[0].size() - 1);
        const auto known =
            std::ranges::find(group_, key, &std::pair<std::string, std::string>::first);
        group_.erase(known, group_.end());
        if (group_.size() == most_facts)
            throw InputError({source_.file, static_cast<int>(line_) + 1},
                             fmt::format("more than {} lines of keys and values belong to one "
                                         "test; leave out those that are not needed",
                                         most_facts));
        group_.emplace_back(key, cells[1]);
        file_.add_fact({key, cells[1], static_cast<int>(line_) + 1});
    }

    /// Name of the test: all facts but the first, which names the project. It is kept with every
    /// interval.
    std::string test() const {
        std::string result;
        for (std::size_t i = 1; i < group_.size(); ++i)
            result += (result.empty() ? "" : ", ") + group_[i].second;
        if (result.size() > longest_test)
            throw InputError({source_.file, static_cast<int>(line_) + 1},
                             fmt::format("the keys and values before this interval have more than "
                                         "{} characters; shorten them",
                                         longest_test));
        return result;
    }

    void read_interval(const std::vector<std::string>& cells) {
        Block block;
        block.test = test();
        block.number = std::stoi(cells[1]);
        block.declared_rows = std::stoul(cells[2]);
        block.table.file = source_.file;
        block.table.delimiter = delimiter_;
        ++line_;
        pass_blank_lines_before_names();
        if (line_ >= source_.lines.size()) return;
        read_header(block);
        bool any_value = false;
        for (; line_ < source_.lines.size(); ++line_) {
            const Row row = source_.row(line_, delimiter_);
            if (is_blank(row) || !row.cells[0].text.empty()) break;
            add_value_row(block, row);
            any_value = true;
        }
        if (any_value || *block.declared_rows > 0) file_.blocks.push_back(std::move(block));
    }

    /// Some versions leave a line empty between that which begins an interval and the names.
    void pass_blank_lines_before_names() {
        std::size_t next = line_;
        while (next < source_.lines.size() && is_blank(source_.row(next, delimiter_)))
            ++next;
        if (next == line_ || next == source_.lines.size()) return;
        const auto cells = filled_cells(source_, next, delimiter_);
        // A fact has two cells, and the begin of an interval without rows is followed by another.
        if (cells.size() > 2 && cells[0].ends_with(':') && !begins_interval(cells)) line_ = next;
    }

    /// Reads names, sub-names and units: the units are the first row with brackets after the names.
    void read_header(Block& block) {
        const Row header = source_.row(line_++, delimiter_);
        std::vector<std::string> names, units, details(header.cells.size());
        for (std::size_t i = 0; i < header.cells.size(); ++i)
            names.push_back(i == 0 ? "" : header.cells[i].text);
        for (int extra = 0; extra < 2 && line_ < source_.lines.size(); ++extra) {
            const Row row = source_.row(line_, delimiter_);
            const bool unit_row = std::ranges::any_of(
                row.cells, [](const Cell& cell) { return cell.text.starts_with('['); });
            const bool values = std::ranges::any_of(
                row.cells, [](const Cell& cell) { return parse_number(cell.text).has_value(); });
            if (values && !unit_row) break;
            ++line_;
            for (std::size_t i = 0; i < row.cells.size(); ++i)
                if (unit_row)
                    units.push_back(bare_unit(row.cells[i].text));
                else if (i < details.size())
                    details[i] = row.cells[i].text;
            if (unit_row) break;
        }
        if (units.empty())
            throw InputError({source_.file, header.line},
                             "no row of units such as [Pa] follows these names; export the file "
                             "with units");
        set_columns(file_, block, header, names, units, details);
    }

    void add_value_row(Block& block, const Row& row) {
        const bool empty = row.cells.size() <= 2 ||
                           std::all_of(row.cells.begin() + 2, row.cells.end(),
                                       [](const Cell& cell) { return cell.text.empty(); });
        const bool marked =
            row.cells.size() > 1 && row.cells[1].text.find('(') != std::string::npos;
        if (!empty && !marked) return add_row(file_, block, row);
        skip_line(file_, row.line,
                  marked ? Remark::Kind::marked_invalid : Remark::Kind::without_values);
    }

    const SourceLines& source_;
    BlockFile& file_;
    char delimiter_;
    std::size_t line_ = 0;
    std::vector<std::pair<std::string, std::string>> group_;
};

}  // namespace

/// Export of Anton Paar's RheoCompass as text or CSV, in any language: blocks of a line with the
/// number of the interval and of its points, names, sub-names, units, and values after an empty
/// first column.
Layout rheocompass_layout() {
    return {"rheocompass", "Anton Paar RheoCompass export",
            [](const SourceLines& source) { return interval_delimiter(source) != 0; },
            [](const SourceLines& source, const FileFormat&, BlockFile& file) {
                RheoCompassReader(source, file).read();
            }};
}

}  // namespace pendular
