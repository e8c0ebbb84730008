#pragma once

namespace pendular {

/// Clock that continues across recordings, each of which has its own time column. Times that
/// increase are used as recorded; where they restart, the new recording follows the last one
/// without a pause.
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
