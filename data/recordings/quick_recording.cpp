#include "data/recordings/recording.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "data/files/column_names.h"
#include "data/files/columns.h"
#include "data/files/file_access.h"
#include "data/files/formats/cut_row.h"
#include "data/files/formats/layouts.h"
#include "data/files/formats/missing_values.h"
#include "data/files/formats/number_style.h"
#include "data/files/header_cell.h"
#include "data/files/header_names.h"
#include "data/files/sheet_path.h"
#include "data/files/text_file.h"
#include "data/quantities/number.h"
#include "data/recordings/column_kinds.h"
#include "data/recordings/recording_rows.h"

namespace pendular {
namespace {

bool states_nothing(const FileFormat& format) {
    return (format.layout.empty() || format.layout == "plain") && format.encoding.empty() &&
           (format.decimal.empty() || format.decimal == ".") && format.sheet.empty() &&
           format.columns.empty() && format.named_columns.empty() && format.roles.empty() &&
           format.missing.empty() && !format.repair;
}

/// Reads the rows of one file. Every function returns false where the file needs the general
/// reader.
class QuickReader {
  public:
    /// @param too_large whether the general reader refuses the file for its size, so that what is
    ///        wrong with it has to be said here
    QuickReader(const std::filesystem::path& path, const FileFormat& format, std::size_t most_rows,
                bool too_large)
        : format_(format), file_(path.string()), most_rows_(most_rows), too_large_(too_large) {}

    /// Reads the whole lines of a part of the file and keeps what follows the last line end.
    bool read_part(std::string_view part) {
        std::string_view text = part;
        if (!rest_.empty()) {
            rest_ += part;
            text = rest_;
        }
        if (line_ == 0) {
            if (text.starts_with("\xEF\xBB\xBF")) text.remove_prefix(3);
            if (!begin(text)) return false;
        }
        std::size_t from = 0;
        for (std::size_t end = text.find('\n', from); end != std::string_view::npos;
             end = text.find('\n', from)) {
            if (!read_line(text.substr(from, end - from))) return false;
            from = end + 1;
        }
        row_before_ = std::string(row_);
        row_ = row_before_;
        rest_ = std::string(text.substr(from));
        return rest_.size() < longest_line;
    }

    std::optional<Recording> finish() {
        if (!rest_.empty() && (may_end_within_row() || !read_line(rest_, true)))
            return std::nullopt;
        if (!rows_) return std::nullopt;
        if (point_open_ && !point_known_) {
            if (too_large_)
                throw InputError({file_},
                                 "no number shows whether its point is a decimal point; "
                                 "write decimal = \".\" in [[recording]]");
            return std::nullopt;
        }
        Recording recording{rows_->finish(), file_, rows_->averaged_rows(),
                            rows_->unused_columns()};
        return recording.size() > 1 ? std::optional(std::move(recording)) : std::nullopt;
    }

  private:
    /// Whether the last line, which no line end follows, may end within a number, on which the
    /// general reader has its say: by the row before it. One more or less of the millions of rows
    /// that only this reader reads changes nothing.
    bool may_end_within_row() const {
        const auto last_cell = [&](std::string_view row) {
            return trimmed(row.substr(row.find_last_of(table_.delimiter) + 1));
        };
        return !too_large_ && may_be_cut(last_cell(rest_), last_cell(row_));
    }

    /// Bytes of a line from which on the file is left to the general reader, so that a file without
    /// line ends is not kept in `rest_`.
    static constexpr std::size_t longest_line = 1 << 20;

    /// Whether the general reader has its say: a file has another layout than "plain", or a quoted
    /// cell of several lines.
    bool has_other_layout(const SourceLines& source) const {
        try {
            return std::ranges::any_of(layouts(), [&](const Layout& layout) {
                return layout.recognise(source) && layout.name != "plain";
            });
        } catch (const InputError&) {
            if (too_large_) throw;
            return true;
        }
    }

    /// Takes the columns from the header, once the first lines show a plain table.
    bool begin(std::string_view text) {
        std::vector<std::string_view> lines = split_lines(text.substr(0, text.rfind('\n') + 1));
        if (lines.size() > 1000) lines.resize(1000);
        if (lines.empty() || lines[0].starts_with('#')) return false;
        if (printable(lines[0]) != lines[0]) return false;  // perhaps of another encoding
        if (format_.layout.empty() && has_other_layout({file_, lines})) return false;
        const auto row = std::find_if_not(lines.begin() + 1, lines.end(), holds_no_row);
        if (row == lines.end()) return false;
        try {
            table_ = table_of(file_, {lines[0], *row});
            use_names_of_quantities(table_.header);
            rows_.emplace(columns_.emplace(table_), most_rows_);
        } catch (const InputError&) {
            if (too_large_) throw;
            return false;
        }
        if (!too_large_ && may_show_other_test()) return false;
        numbers_.resize(table_.header.cells.size());
        point_known_ = table_.delimiter == ',' || !format_.decimal.empty();
        return std::ranges::none_of(table_.header.cells, [](const Cell& cell) {
            const HeaderCell parts = parse_header_cell(cell.text);
            return !set_point_of(parts.name, parts.unit).empty();
        });
    }

    /// Whether the names of the columns are those of another kind of test, which their values
    /// decide.
    bool may_show_other_test() const {
        Block block;
        Row row;
        for (const Cell& cell : table_.header.cells) {
            const HeaderCell parts = parse_header_cell(cell.text);
            const Quantity* const known = quantity_of_cell(parts.name, parts.unit);
            block.columns.push_back(
                {parts.name, parts.unit, known ? std::string(known->name) : ""});
            row.cells.push_back({"1", 0});
        }
        block.table.rows.push_back(std::move(row));
        return kind_shown_by_columns(block).has_value();
    }

    bool read_line(std::string_view line, bool last = false) {
        ++line_;
        if (line.ends_with('\r')) line.remove_suffix(1);
        if (line_ == 1 || line.empty()) return true;  // the header, or a blank line
        if (split(line) && rows_->add(line_, numbers_)) {
            row_ = line;
            return true;
        }
        if (printable(line) != line) return false;
        if (holds_no_row(line)) return true;
        if (too_large_) add_text_row(row_of(table_, line, line_, last));
        return too_large_;
    }

    /// Adds a row of a file that is too long to be read as text, where no row is left out.
    void add_text_row(const Row& row) {
        for (std::size_t i = 0; i < row.cells.size(); ++i)
            if (rows_->needs(i) &&
                is_usual_missing_value(parse_number(row.cells[i].text).value_or(0)))
                throw InputError(table_.at(row, i), "the value is missing; remove the line");
        rows_->add(row);
    }

    /// Takes a number off the begin of a text, as `take_number` does, but without a call and an
    /// optional for each of a hundred million cells, which took a tenth of the time.
    static bool take(std::string_view& text, double& number) {
        if (text.starts_with('+') && !text.starts_with("+-")) text.remove_prefix(1);
        const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
        if (error != std::errc() || !std::isfinite(number)) return false;
        text.remove_prefix(static_cast<std::size_t>(end - text.data()));
        return true;
    }

    /// Sets `numbers_` from a line that has nothing but numbers.
    bool split(std::string_view line) {
        const auto pass = [&](char c) {
            const bool there = line.starts_with(c);
            if (there) line.remove_prefix(1);
            return there;
        };
        for (std::size_t i = 0; i < numbers_.size(); ++i) {
            if (i > 0 && !pass(table_.delimiter)) return false;
            while (pass(' '))
                continue;
            const std::string_view begin = line;
            double number = 0;
            if (!take(line, number)) return false;
            if (number < -900 && is_usual_missing_value(number) && rows_->needs(i)) return false;
            if (!point_known_) look_at_point(begin.substr(0, begin.size() - line.size()));
            numbers_[i] = number;
            while (pass(' '))
                continue;
        }
        return line.empty();
    }

    /// Notes whether a number shows that its point is a decimal point: "2.8", but not "2.800".
    void look_at_point(std::string_view number) {
        if (number.find('.') == std::string_view::npos) return;
        (point_may_group(number) ? point_open_ : point_known_) = true;
    }

    const FileFormat& format_;
    std::string file_;
    std::size_t most_rows_;
    bool too_large_;
    std::string rest_;        ///< begin of a line whose end is in the next part
    std::string_view row_;    ///< last row that was read, in the present part or `row_before_`
    std::string row_before_;  ///< copy of the last row of the part before
    int line_ = 0;
    bool point_known_ = false, point_open_ = false;
    Table table_;  ///< of the header and the first row
    std::optional<Columns> columns_;
    std::optional<RecordingRows> rows_;
    std::vector<double> numbers_;  ///< of the present row
};

}  // namespace

std::optional<Recording> quick_recording(const std::filesystem::path& path,
                                         const FileFormat& format, std::size_t most_rows) {
    if (!states_nothing(format) || as_sheet(path)) return std::nullopt;
    std::error_code unknown;
    const std::uintmax_t size = std::filesystem::file_size(path, unknown);
    QuickReader reader(path, format, most_rows, !unknown && size > largest_table);
    const bool all = read_in_parts(path, largest_quick_recording,
                                   [&](std::string_view part) { return reader.read_part(part); });
    return all ? reader.finish() : std::nullopt;
}

}  // namespace pendular
