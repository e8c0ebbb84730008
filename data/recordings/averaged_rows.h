#pragma once

#include <cstddef>
#include <vector>

#include "data/recordings/recording.h"

namespace pendular {

/// Adds the rows of a file to a recording and limits its memory: whenever the recording has `most`
/// rows, neighbouring rows of one interval are averaged in pairs, and each further row is the mean
/// of twice as many rows of the file (`Recording::averaged_rows`).
class AveragedRows {
  public:
    /// @param recording empty; must outlive this object
    /// @param columns columns of the recording, in the order of the values passed to `add`
    /// @param most at least 2
    AveragedRows(Recording& recording, std::vector<std::vector<double> Recording::*> columns,
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
    std::vector<std::vector<double> Recording::*> columns_;
    std::size_t most_;
    std::ptrdiff_t interval_ = -1;  ///< index in `columns_` of the interval numbers; -1: none
    int first_line_ = 0;            ///< line of the first row that is not averaged yet
    int count_ = 0;                 ///< number of rows that are not averaged yet
    std::vector<double> sums_;      ///< sums of these rows
};

}  // namespace pendular
