#pragma once

#include <cstddef>
#include <vector>

#include "data/recordings/recording.h"

namespace pendular {

/// Adds the rows of a file to a recording (raw time series) and limits the memory that the
/// recording takes. Whenever the recording has `most` rows, neighbouring rows of one interval (step
/// of constant set points) are averaged in pairs. From then on, each further row is the mean of
/// twice as many rows of the file (`Recording::averaged_rows`).
class AveragedRows {
  public:
    /// Prepares to add rows to an empty recording. The recording must outlive the AveragedRows
    /// object.
    /// @param columns columns of the recording, in the order of the values passed to `add`
    /// @param most number of rows at which rows are averaged in pairs, at least 2
    AveragedRows(Recording& recording, std::vector<std::vector<double> Recording::*> columns,
                 std::size_t most);

    /// Adds a row of the file to the recording: either as a row of its own or as a contribution to
    /// the mean of several rows of the file, which becomes one row of the recording.
    /// @param line number of the row's line in the file, from 1
    /// @param values value of each column in the row, in SI units
    /// @return false if averaging cannot make the recording shorter, because every row belongs to
    ///         an interval that differs from the interval of the preceding row
    bool add(int line, const std::vector<double>& values);
    /// Adds the mean of the rows that remain at the end of the file, which are too few for a mean
    /// of the usual number of rows. The function must be called after the last row.
    void finish();

  private:
    bool append_mean();
    void halve();
    bool same_interval(std::size_t row) const;

    Recording& recording_;
    std::vector<std::vector<double> Recording::*> columns_;
    std::size_t most_;
    /// Index of the column with interval numbers in `columns_`; -1: no column has interval numbers.
    std::ptrdiff_t interval_ = -1;
    int first_line_ = 0;  ///< line in the file of the first row that is not averaged yet
    int count_ = 0;       ///< number of rows of the file that are not averaged yet
    /// Sum of the values of the rows that are not averaged yet, for each column.
    std::vector<double> sums_;
};

}  // namespace pendular
