#pragma once

namespace pendular {

/// Converts the recorded times of successive recordings to times on the clock of the study's first
/// recording [s]. Times that keep increasing from recording to recording are used as recorded. A
/// recording in which the times restart is assumed to follow the preceding recording without a
/// pause.
class RunClock {
  public:
    /// Returns the offset [s] to add to the recorded times of the next step. The function must be
    /// called once for each step, in the order of measurement.
    /// @param first,last first and last recorded time of the step [s]
    double shift(double first, double last) {
        if (first < last_) shift_ += last_;
        last_ = last;
        return shift_;
    }

  private:
    double shift_ = 0, last_ = 0;
};

}  // namespace pendular
