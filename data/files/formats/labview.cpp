#include "data/files/formats/labview.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <optional>
#include <string_view>

#include "data/files/folded_name.h"
#include "data/files/header_cell.h"
#include "data/input_error.h"
#include "data/quantities/number.h"

namespace pendular {
namespace {

constexpr std::string_view end_of_header = "***End_of_Header***";

/// Number of a cell, with a decimal point or comma.
std::optional<double> number_of(std::string text) {
    std::ranges::replace(text, ',', '.');
    return parse_number(text);
}

/// Reads the lines of a file in their order: keys with a value for each channel, a line of names,
/// and rows.
class SegmentReader {
  public:
    SegmentReader(const SourceLines& source, BlockFile& file)
        : source_(source),
          file_(file),
          delimiter_(consistent_delimiter(source, 0, source.lines.size())) {}

    SeveralTables read() {
        bool special = false;  // data of a device, of no documented form
        for (std::size_t i = 0; i < source_.lines.size(); ++i) {
            const std::string_view line = trimmed(source_.lines[i]);
            special = special || line.starts_with("***Start_Special");
            if (!special && !line.empty()) take(i);
            if (line.starts_with("***End_Special")) special = false;
        }
        if (found_.parts.size() == 1) found_.parts.front().title.clear();
        return std::move(found_);
    }

  private:
    void take(std::size_t line) {
        if (source_.lines[line].starts_with("***")) {
            names_next_ = source_.lines[line].starts_with(end_of_header);
            in_rows_ = false;
            return;
        }
        const Row row = source_.row(line, delimiter_);
        const std::string& key = row.cells.front().text;
        if (in_rows_ && key != "Channels") {
            append(line, row);
        } else if (names_next_ && key != "Channels") {
            begin_part(line, row);
        } else {
            keys_[key] = row;
            in_rows_ = false;
            if (found_.parts.empty() && row.cells.size() > 1)
                file_.add_fact({key, row.cells[1].text, row.line});
        }
        names_next_ = false;
    }

    /// Text that a key has for a channel; empty if there is none.
    std::string of_channel(const char* key, std::size_t channel) const {
        const auto found = keys_.find(key);
        return found == keys_.end() || channel >= found->second.cells.size()
                   ? ""
                   : found->second.cells[channel].text;
    }

    /// Name of a column with its unit. LabVIEW counts times in seconds.
    std::string name_of(const Row& names, std::size_t channel) const {
        const std::string& name = names.cells[channel].text;
        if (!parse_header_cell(name).unit.empty()) return name;
        const std::string unit = channel == 0 ? "" : of_channel("Y_Unit_Label", channel);
        if (!unit.empty()) return fmt::format("{} [{}]", name, bare_unit(unit));
        const std::string dimension = lower_case(of_channel("X_Dimension", 1));
        const bool time = name == "X_Value" && (dimension.empty() || dimension == "time");
        return time && channel == 0 ? "Time [s]" : name;
    }

    void begin_part(std::size_t line, const Row& names) {
        // Each part has a place for each line: a small file could use much memory.
        constexpr std::size_t most_lines_of_parts = 20'000'000;
        if (source_.lines.size() > most_lines_of_parts / (found_.parts.size() + 1))
            throw InputError({source_.file, names.line},
                             fmt::format("{} segments of {} lines are more than are read; export "
                                         "the segments into several files",
                                         found_.parts.size() + 1, source_.lines.size()));
        std::string text;
        cells_ = names.cells.size();
        for (std::size_t i = 0; i < cells_; ++i) {
            if (i > 0) text += delimiter_;
            text += name_of(names, i);
        }
        found_.parts.push_back(
            {fmt::format("segment {}", found_.parts.size() + 1),
             {source_.file, std::vector<std::string_view>(source_.lines.size()), false}});
        found_.parts.back().source.lines[line] = found_.texts.emplace_back(std::move(text));
        in_rows_ = true;
        rows_ = 0;
    }

    /// Adds a row, which lacks its last cell where it has no comment, and perhaps its time.
    void append(std::size_t line, const Row& row) {
        std::string_view& kept = found_.parts.back().source.lines[line];
        kept = source_.lines[line];
        ++rows_;
        const bool lacks_comment = row.cells.size() + 1 == cells_;
        if (!row.cells.front().text.empty() && !lacks_comment) return;
        std::string text(kept);
        const auto begin = number_of(of_channel("X0", 1));
        const auto distance = number_of(of_channel("Delta_X", 1));
        if (row.cells.front().text.empty() && begin && distance) {
            std::string time =
                fmt::format("{:.12g}", *begin + static_cast<double>(rows_ - 1) * *distance);
            if (of_channel("Decimal_Separator", 1) == ",") std::ranges::replace(time, '.', ',');
            text = time + text.substr(std::min(text.find(delimiter_), text.size()));
        }
        if (lacks_comment) text += delimiter_;
        kept = found_.texts.emplace_back(std::move(text));
    }

    const SourceLines& source_;
    BlockFile& file_;
    char delimiter_;
    SeveralTables found_;
    std::map<std::string, Row> keys_;  ///< lines of the headers so far
    bool names_next_ = false, in_rows_ = false;
    std::size_t rows_ = 0, cells_ = 0;  ///< of the segment so far, and of its names
};

}  // namespace

bool is_labview(const SourceLines& source) {
    return !source.lines.empty() && source.lines.front().starts_with("LabVIEW Measurement");
}

SeveralTables labview_segments(const SourceLines& source, BlockFile& file) {
    return SegmentReader(source, file).read();
}

}  // namespace pendular
