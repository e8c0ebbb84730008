#include "data/files/sheet_lines.h"

#include <fmt/format.h>

#include <algorithm>

#include "data/files/csv.h"
#include "data/input_error.h"
#include "data/quantities/number.h"

namespace pendular {

void SheetLines::add_line() {
    result_.text += '\n';
    ++lines_;
}

void SheetLines::add_empty_until(std::size_t lines) {
    while (lines_ < lines)
        add_line();
}

void SheetLines::begin_row(bool hidden) {
    check_cell_count(cell_count_ += cells_.size(), file_, line());
    std::ranges::fill(cells_, std::string());
    percents_.clear();
    if (!hidden) return;
    auto& all = result_.hidden;
    if (!all.empty() && all.back().second + 1 == line())
        all.back().second = line();
    else
        all.emplace_back(line(), line());
}

void SheetLines::count(const std::string& text) {
    text_size_ += text.size();
    if (text_size_ > largest_unpacked)
        throw InputError({file_, line()},
                         fmt::format("more than {} MB of text in the cells up to this row; leave "
                                     "out columns that are not needed, or split the sheet into "
                                     "several files",
                                     largest_unpacked >> 20));
}

void SheetLines::set(std::size_t column, std::string text, bool percent) {
    count(text);
    for (char& c : text)
        if (c == '\t' || c == '\n' || c == '\r') c = ' ';
    cells_[column] = trimmed(text);
    if (percent) percents_.insert(column);
    if (!merged_.empty()) hold(column);
}

/// Keeps a number in a merged cell for the rows below, and a text such as the name of a column
/// beside which others have a second line.
void SheetLines::hold(std::size_t column) {
    const std::string& text = cells_[column];
    const auto merged = merged_.find({lines_, column});
    if (merged == merged_.end()) return;
    const CellPlace& last = merged->second;
    if (last.column > column && !parse_number(text)) return;  // a title
    if (last.column > column) {
        result_.wide.push_back(
            {line(), static_cast<int>(column) + 1, static_cast<int>(last.column) + 1, text});
        return;
    }
    held_[column] = {text, last.row, percents_.contains(column)};
}

void SheetLines::end_row() {
    std::erase_if(held_, [&](const auto& each) { return each.second.last < lines_; });
    for (const auto& [column, held] : held_) {
        if (!cells_[column].empty()) continue;
        count(held.text);
        cells_[column] = held.text;
        if (held.percent) percents_.insert(column);
    }
    for (const std::size_t column : percents_)
        result_.percents.push_back({lines_, column});
    for (std::size_t i = 0; i < cells_.size(); ++i) {
        if (i > 0) result_.text += '\t';
        const std::string text = csv_cell(cells_[i]);  // delimiters and quotes within are none
        result_.text += text.starts_with('#') ? '"' + text + '"' : text;  // no comment
    }
    add_line();
}

}  // namespace pendular
