#pragma once

#include <cstddef>
#include <vector>

#include "data/recordings/recording.h"

namespace pendular {

/// Fills a recording with rows in bounded memory. As soon as it holds `most` rows, each row and the
/// next of the same interval become their mean, and from then on each new row is the mean of twice
/// as many rows of the file (`Recording::averaged_rows`).
class AveragedRows {
  public:
    /// @param columns columns of the recording, in the order of the values of a row
    /// @param most number of rows at which they are averaged, at least 2
    AveragedRows(Recording& recording, std::vector<std::vector<double> Recording::*> columns,
                 std::size_t most);

    /// Adds a row of the file, its values in SI units.
    /// @return false if averages make the recording no shorter, since nearly every row has another
    ///         interval than the row before
    bool add(int line, const std::vector<double>& values);
    /// Adds the rows that are not averaged yet.
    void finish();

  private:
    bool append_mean();
    void halve();
    bool same_interval(std::size_t row) const;

    Recording& recording_;
    std::vector<std::vector<double> Recording::*> columns_;
    std::size_t most_;
    std::ptrdiff_t interval_ = -1;  ///< place of the interval among the columns; -1: none
    int first_line_ = 0;            ///< line of the first row of the mean
    int count_ = 0;                 ///< number of rows in the mean
    std::vector<double> sums_;      ///< sum of these rows for each column
};

}  // namespace pendular
