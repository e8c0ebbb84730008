#pragma once

namespace pendular {

/// Time since the first recording began, where each recording has a Time column of its own: while
/// times go on they count as they stand, and where they restart, the new stretch follows the last.
class RunClock {
  public:
    /// Offset for the times of the next stretch, given its first and last time [s].
    double shift(double first, double last) {
        if (first < last_) shift_ += last_;
        last_ = last;
        return shift_;
    }

  private:
    double shift_ = 0, last_ = 0;
};

}  // namespace pendular
