#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "data/files/folded_name.h"
#include "data/files/formats/layouts.h"
#include "data/files/header_cell.h"
#include "data/quantities/number.h"

namespace pendular {
namespace {

constexpr std::string_view first_words = "LabVIEW Measurement";

bool is_labview(const SourceLines& source) {
    return !source.lines.empty() && trimmed(source.lines.front()).starts_with(first_words);
}

/// Reads the segments of a file: keys with a value for each channel, such as `Y_Unit_Label`, the
/// line `X_Value` with the names of the channels, and rows.
class SegmentReader {
  public:
    SegmentReader(const SourceLines& source, BlockFile& file) : source_(source), file_(file) {
        file_.delimiter = '\t';
        // The key and its value stand before any row.
        constexpr std::size_t most_lines = 50;
        for (std::size_t i = 0; i < std::min(source.lines.size(), most_lines); ++i)
            if (source.lines[i].starts_with("Separator") &&
                source.lines[i].find("Comma") != std::string_view::npos)
                file_.delimiter = ',';
    }

    void read() {
        bool special = false;  // data of a device, of no documented form
        for (std::size_t i = 0; i < source_.lines.size(); ++i) {
            const std::string_view line = trimmed(source_.lines[i]);
            if (line.starts_with("***Start_Special")) special = true;
            if (!special && !line.empty()) take(source_.row(i, file_.delimiter));
            if (line.starts_with("***End_Special")) special = false;
        }
    }

  private:
    void take(const Row& row) {
        const std::string& key = row.cells.front().text;
        if (key == "X_Value") {
            begin_block(row);
        } else if (key.starts_with("***")) {
            in_rows_ = false;
        } else if (in_rows_ && (key.empty() || parse_number(with_point(key)))) {
            append(row);
        } else if (!is_blank(row)) {
            in_rows_ = false;
            keys_[key] = row;
            if (file_.blocks.empty() && row.cells.size() > 1)
                file_.add_fact({key, row.cells[1].text, row.line});
        }
    }

    /// Text that a key has for a channel, or for the first one; empty if there is none.
    std::string of_channel(const char* key, std::size_t channel) const {
        const auto found = keys_.find(key);
        return found == keys_.end() || channel >= found->second.cells.size()
                   ? ""
                   : found->second.cells[channel].text;
    }

    void begin_block(const Row& header) {
        std::vector<std::string> names, units;
        for (std::size_t i = 0; i < header.cells.size(); ++i) {
            const HeaderCell parts = parse_header_cell(header.cells[i].text);
            names.push_back(parts.name);
            const std::string stated = of_channel("Y_Unit_Label", i);
            units.push_back(i > 0 && !stated.empty() ? bare_unit(stated) : parts.unit);
        }
        // LabVIEW counts times in seconds.
        const std::string dimension = lower_case(of_channel("X_Dimension", 1));
        if (dimension.empty() || dimension == "time") names[0] = "Time", units[0] = "s";
        Block block;
        block.number = static_cast<int>(file_.blocks.size()) + 1;
        block.table.file = source_.file;
        block.table.delimiter = file_.delimiter;
        set_columns(file_, block, header, names, units);
        file_.blocks.push_back(std::move(block));
        in_rows_ = true;
    }

    /// Adds a row; without its time (`X_Columns No`), the one that begin and distance give.
    void append(Row row) {
        const auto begin = parse_number(with_point(of_channel("X0", 1)));
        const auto distance = parse_number(with_point(of_channel("Delta_X", 1)));
        if (row.cells[0].text.empty() && begin && distance) {
            const std::size_t index = file_.blocks.back().table.rows.size();
            row.cells[0].text =
                fmt::format("{:.12g}", *begin + static_cast<double>(index) * *distance);
            if (of_channel("Decimal_Separator", 1) == ",")
                std::ranges::replace(row.cells[0].text, '.', ',');
        }
        add_row(file_, file_.blocks.back(), std::move(row));
    }

    static std::string with_point(std::string text) {
        std::ranges::replace(text, ',', '.');
        return text;
    }

    const SourceLines& source_;
    BlockFile& file_;
    std::map<std::string, Row> keys_;  ///< lines of the header so far
    bool in_rows_ = false;
};

}  // namespace

/// Text file of measurements of LabVIEW (.lvm): a header for each segment, with names and units of
/// the channels in different lines.
Layout labview_layout() {
    return {"labview", "LabVIEW measurement file (.lvm)", is_labview,
            [](const SourceLines& source, const FileFormat&, BlockFile& file) {
                SegmentReader(source, file).read();
            }};
}

}  // namespace pendular
