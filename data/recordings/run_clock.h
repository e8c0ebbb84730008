#pragma once

namespace pendular {

/// Clock that converts the time columns of successive recordings to the time since the first
/// recording began [s]. Times that keep increasing are used as recorded. If the times restart, the
/// recording is taken to follow the previous recording without a pause.
class RunClock {
  public:
    /// Offset [s] to add to the recorded times of the next step, from its first and last recorded
    /// time [s]. To be called once for each step, in the order of measurement.
    double shift(double first, double last) {
        if (first < last_) shift_ += last_;
        last_ = last;
        return shift_;
    }

  private:
    double shift_ = 0, last_ = 0;
};

}  // namespace pendular
