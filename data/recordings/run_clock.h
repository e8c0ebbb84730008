#pragma once

namespace pendular {

/// Clock of the study's first recording [s]. Times that keep increasing from recording to recording
/// are used as recorded; a recording in which they restart is assumed to follow without a pause.
class RunClock {
  public:
    /// Returns the offset [s] to add to the recorded times of the next step, which run from `first`
    /// to `last` [s]. To be called once for each step, in the order of measurement.
    double shift(double first, double last) {
        if (first < last_) shift_ += last_;
        last_ = last;
        return shift_;
    }

  private:
    double shift_ = 0, last_ = 0;
};

}  // namespace pendular
