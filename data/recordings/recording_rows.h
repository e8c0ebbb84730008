#pragma once

#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "data/files/columns.h"
#include "data/recordings/interval_series.h"

namespace pendular {

/// Makes a recording of the rows of a table: the one place that knows which columns it takes, what
/// is wrong with a row, and how the memory of a long recording is limited.
///
/// Rows come from two sources. Layout, encoding and decimal mark of a file can be told from the
/// whole of it alone, so `recording_of` takes them from a table of texts in memory; a file that is
/// too long for that has to be a plain table, which `quick_recording` reads in parts.
///
/// Whenever the recording has `most` rows, neighbouring rows of one interval are averaged in pairs,
/// and each further row is the mean of twice as many rows of the file (`averaged_rows`).
class RecordingRows {
  public:
    /// Takes the columns that the table has, or those from which `fill_from_stresses` computes
    /// them.
    /// @param columns must outlive this object
    /// @param most at least 2
    /// @throws InputError at the header if a column is missing, and at a header cell of a needed
    ///         column whose unit is missing or wrong
    explicit RecordingRows(const Columns& columns,
                           std::size_t most = std::numeric_limits<std::size_t>::max());

    /// Returns the needed quantities.
    std::vector<std::string_view> needed() const;
    /// Lets empty cells of a needed quantity other than time and interval be NaN, since the
    /// instrument records it less often.
    void allow_missing(std::string_view quantity);
    /// Whether `allow_missing` was called for a quantity that is read.
    bool may_lack(std::string_view quantity) const;
    /// Returns a needed quantity whose cell is empty in a row of the table; empty if there is none.
    std::string_view missing(const Row& row) const;
    /// Whether a column of the table is read as a needed quantity.
    bool needs(std::size_t column) const;
    /// Adds a row of the table.
    /// @throws InputError at a cell without a number, a gap that is not positive, an interval that
    ///         is not a whole number, and a time that goes back within an interval; at the interval
    ///         if the recording has `most` rows and none of them can be averaged
    void add(const Row& row);
    /// Adds a row by the numbers in its cells. Returns false, and adds nothing, for a row that
    /// `add` would refuse.
    bool add(int line, const std::vector<double>& numbers);
    /// Returns the columns of the recording; must be called after the last row.
    IntervalSeries finish();
    /// Returns the number of rows of the table whose mean is one row of the recording.
    int averaged_rows() const { return averaged_rows_; }
    /// Returns the header cells of the columns that are not read.
    std::vector<std::string> unused_columns() const;

  private:
    struct ReadColumn {
        SeriesColumn series;
        Columns::Conversion from;
        bool needed;            ///< in every row; other cells without a number are NaN
        bool may_lack = false;  ///< although needed
    };
    struct Fault {
        std::string_view quantity;
        std::string text;
    };

    double value(const Row& row, const ReadColumn& column) const;
    std::optional<Fault> fault() const;
    std::optional<Fault> add_values(int line);
    void append_mean();
    void halve();
    bool same_interval(std::size_t row) const;

    const Columns& columns_;
    std::size_t most_;
    IntervalSeries series_;
    int averaged_rows_ = 1;
    std::vector<ReadColumn> read_;
    std::size_t time_ = 0, height_ = 0;    ///< indices in `read_`
    std::optional<std::size_t> interval_;  ///< index in `read_`; empty: none
    std::vector<double> values_;           ///< of the present row, in SI units
    double time_before_ = -std::numeric_limits<double>::infinity();  ///< of the row before
    double interval_before_ = 0;
    int first_line_ = 0;        ///< line of the first row that is not averaged yet
    int count_ = 0;             ///< number of rows that are not averaged yet
    std::vector<double> sums_;  ///< sums of these rows
};

}  // namespace pendular
