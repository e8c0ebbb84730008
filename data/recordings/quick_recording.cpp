#include "data/recordings/quick_recording.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <functional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "data/files/columns.h"
#include "data/files/file_bytes.h"
#include "data/files/formats/column_names.h"
#include "data/files/formats/layouts.h"
#include "data/files/printable.h"
#include "data/files/text_file.h"
#include "data/quantities/number.h"

namespace pendular {
namespace {

/// Adds the rows of a file to a recording and limits its memory: whenever the recording has `most`
/// rows, neighbouring rows of one interval are averaged in pairs, and each further row is the mean
/// of twice as many rows of the file (`Recording::averaged_rows`).
class AveragedRows {
  public:
    /// @param recording empty; must outlive this object
    /// @param columns columns of the recording, in the order of the values passed to `add`
    /// @param most at least 2
    AveragedRows(Recording& recording, std::vector<std::vector<double> IntervalSeries::*> columns,
                 std::size_t most);

    /// Adds a row of the file, with one value in SI units for each column. Returns false if
    /// averaging cannot make the recording shorter, since each row has an interval of its own.
    bool add(int line, const std::vector<double>& values);
    /// Adds the mean of the last rows of the file, too few for a mean of the usual number; must be
    /// called after the last row.
    void finish();

  private:
    bool append_mean();
    void halve();
    bool same_interval(std::size_t row) const;

    Recording& recording_;
    std::vector<std::vector<double> IntervalSeries::*> columns_;
    std::size_t most_;
    std::ptrdiff_t interval_ = -1;  ///< index in `columns_` of the interval numbers; -1: none
    int first_line_ = 0;            ///< line of the first row that is not averaged yet
    int count_ = 0;                 ///< number of rows that are not averaged yet
    std::vector<double> sums_;      ///< sums of these rows
};

AveragedRows::AveragedRows(Recording& recording,
                           std::vector<std::vector<double> IntervalSeries::*> columns,
                           std::size_t most)
    : recording_(recording), columns_(std::move(columns)), most_(most), sums_(columns_.size()) {
    const auto found = std::ranges::find(columns_, &Recording::interval);
    if (found != columns_.end()) interval_ = found - columns_.begin();
}

bool AveragedRows::add(int line, const std::vector<double>& values) {
    if (count_ > 0 && interval_ >= 0) {
        const auto i = static_cast<std::size_t>(interval_);
        if (values[i] != sums_[i] / count_ && !append_mean()) return false;
    }
    if (count_ == 0) {
        first_line_ = line;
        sums_ = values;
    } else {
        std::ranges::transform(sums_, values, sums_.begin(), std::plus());
    }
    return ++count_ < recording_.averaged_rows || append_mean();
}

void AveragedRows::finish() {
    if (count_ > 0) append_mean();
}

bool AveragedRows::append_mean() {
    recording_.line.push_back(first_line_);
    for (std::size_t k = 0; k < columns_.size(); ++k) {
        (recording_.*columns_[k]).push_back(sums_[k] / count_);
    }
    count_ = 0;
    if (recording_.line.size() < most_) return true;
    halve();
    return recording_.line.size() < most_;
}

bool AveragedRows::same_interval(std::size_t row) const {
    return interval_ < 0 || recording_.interval[row] == recording_.interval[row + 1];
}

void AveragedRows::halve() {
    const std::size_t rows = recording_.line.size();
    std::vector<std::size_t> first;  // row of each mean, of this row alone or with the next
    for (std::size_t row = 0; row < rows; ++row) {
        first.push_back(row);
        if (row + 1 < rows && same_interval(row)) ++row;
    }
    for (const auto member : columns_) {
        std::vector<double>& column = recording_.*member;
        for (std::size_t k = 0; k < first.size(); ++k) {
            // A row alone is both the first and the last of its mean.
            const std::size_t next = k + 1 < first.size() ? first[k + 1] : rows;
            column[k] = (column[first[k]] + column[next - 1]) / 2;
        }
        column.resize(first.size());
    }
    for (std::size_t k = 0; k < first.size(); ++k) {
        recording_.line[k] = recording_.line[first[k]];
    }
    recording_.line.resize(first.size());
    recording_.averaged_rows *= 2;
}

/// Column of the file that a column of the recording is read from.
struct ReadColumn {
    std::vector<double> IntervalSeries::*member;
    Columns::Conversion from;
};

bool states_nothing(const FileFormat& format) {
    return (format.layout.empty() || format.layout == "plain") && format.encoding.empty() &&
           (format.decimal.empty() || format.decimal == ".") && format.sheet.empty() &&
           format.columns.empty() && format.roles.empty() && !format.repair;
}

/// Reads the rows of one file. Every function returns false where the file needs the general
/// reader.
class QuickReader {
  public:
    QuickReader(const std::filesystem::path& path, const FileFormat& format, std::size_t most_rows)
        : format_(format), most_rows_(most_rows) {
        recording_.file = path.string();
    }

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
        rest_ = std::string(text.substr(from));
        return rest_.size() < longest_line;
    }

    bool finish() {
        const std::string last = std::exchange(rest_, "");
        if (!last.empty() && !read_line(last)) return false;
        if (rows_) rows_->finish();
        return recording_.size() > 1;
    }

    Recording take() { return std::move(recording_); }

  private:
    /// Bytes of a line from which on the file is left to the general reader, so that a file without
    /// line ends is not kept in `rest_`.
    static constexpr std::size_t longest_line = 1 << 20;

    /// Takes the columns from the header, once the first lines show a plain table.
    bool begin(std::string_view text) {
        std::vector<std::string_view> lines = split_lines(text.substr(0, text.rfind('\n') + 1));
        if (lines.size() > 1000) lines.resize(1000);
        if (lines.size() < 2 || lines[0].starts_with('#')) return false;
        if (printable(lines[0]) != lines[0]) return false;  // perhaps of another encoding
        const SourceLines source{recording_.file, lines};
        if (format_.layout.empty())
            for (const Layout& layout : layouts())
                if (layout.recognise(source) && layout.name != "plain") return false;
        try {
            const Table table = table_of(recording_.file, {lines[0], lines[1]});
            cells_ = table.header.cells.size();
            delimiter_ = table.delimiter;
            return begin_columns(table, Columns(table));
        } catch (const InputError&) {
            return false;
        }
    }

    bool begin_columns(const Table& table, const Columns& columns) {
        for (const Cell& cell : table.header.cells) {
            const HeaderCell parts = parse_header_cell(cell.text);
            if (!set_point_of(parts.name, parts.unit).empty()) return false;
        }
        std::vector<std::string_view> names;
        for (const auto& [name, values] : series_columns()) {
            names.push_back(name);
            if (const auto from = columns.conversion(name)) columns_.push_back({values, *from});
        }
        recording_.unused_columns = columns.others(names);
        numbers_.resize(cells_);
        std::vector<std::vector<double> IntervalSeries::*> members;
        for (const ReadColumn& column : columns_)
            members.push_back(column.member);
        values_.resize(members.size());
        rows_.emplace(recording_, std::move(members), most_rows_);
        const bool shear = columns.has("torque") || columns.has("shear_stress");
        const bool normal = columns.has("normal_force") || columns.has("normal_stress");
        return shear && normal && columns.has("time") && columns.has("height") &&
               columns.has("angular_velocity");
    }

    bool read_line(std::string_view line) {
        ++line_;
        if (line.ends_with('\r')) line.remove_suffix(1);
        if (line_ == 1) return true;  // the header
        if (line.empty()) return true;
        return split(line) && add_row();
    }

    bool split(std::string_view line) {
        const char *at = line.data(), *const end = at + line.size();
        for (std::size_t i = 0; i < cells_; ++i) {
            while (at < end && *at == ' ')
                ++at;
            const auto [after, error] = std::from_chars(at, end, numbers_[i]);
            if (error != std::errc() || !std::isfinite(numbers_[i])) return false;
            at = after;
            while (at < end && *at == ' ')
                ++at;
            const bool last = i + 1 == cells_;
            if (last != (at == end) || (!last && *at != delimiter_)) return false;
            ++at;
        }
        return true;
    }

    bool add_row() {
        double time = 0, interval = 0;
        for (std::size_t k = 0; k < columns_.size(); ++k) {
            const ReadColumn& column = columns_[k];
            const double value =
                column.from.factor * numbers_[column.from.index] + column.from.offset;
            if (!(std::abs(value) <= largest_magnitude)) return false;
            if (column.member == &Recording::height && value <= 0) return false;
            if (column.member == &Recording::time) time = value;
            if (column.member == &Recording::interval) interval = value;
            values_[k] = value;
        }
        if (interval != std::floor(interval)) return false;
        if (time < time_ && interval == interval_) return false;
        time_ = time;
        interval_ = interval;
        return rows_->add(line_, values_);
    }

    const FileFormat& format_;
    Recording recording_;
    std::string rest_;  ///< begin of a line whose end is in the next part
    int line_ = 0;
    char delimiter_ = ',';
    std::size_t cells_ = 0;
    std::vector<ReadColumn> columns_;
    std::vector<double> numbers_;             ///< of the present row
    std::vector<double> values_;              ///< of its columns, in SI units
    double time_ = -INFINITY, interval_ = 0;  ///< of the row before; 0 without intervals
    std::size_t most_rows_;
    std::optional<AveragedRows> rows_;
};

}  // namespace

std::optional<Recording> quick_recording(const std::filesystem::path& path,
                                         const FileFormat& format, std::size_t most_rows) {
    if (!states_nothing(format)) return std::nullopt;
    QuickReader reader(path, format, most_rows);
    const bool all = read_in_parts(path, largest_quick_recording,
                                   [&](std::string_view part) { return reader.read_part(part); });
    if (!all || !reader.finish()) return std::nullopt;
    return reader.take();
}

}  // namespace pendular
