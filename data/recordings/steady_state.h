#pragma once

#include <string>
#include <vector>

#include "data/annular_cell.h"
#include "data/reading.h"
#include "data/recordings/recording.h"
#include "data/recordings/steps.h"
#include "data/study/study.h"

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

/// Finds the steps of a recording whose gap creeps while the torque is steady, and takes the steady
/// part of their torque for that of the step. One short step tells little, and one in a hundred
/// steady gaps counts as not steady by chance. A gap that is not steady therefore creeps if it
/// changes by more than 4 standard errors, if it and the gap of another such step change by more
/// than 2 in one sense, or if it changes in the sense in which the gaps of the whole recording
/// drift (`drift_tests`, p < 0.005).
void find_creep(const std::string& file, std::vector<RecordedStep>& steps);

/// Returns one reading for each step of a recording, the mean over its steady part, in the order of
/// the steps. Remarks list spikes, transients and unusable steps, such as those whose steady part
/// covers less strain than `choice.least_strain`, and further treatment, such as interpolation. If
/// a wobble would bias the mean, it is taken over whole turns (`whole_turns_begin`).
///
/// The covariance of a reading includes the autocorrelation within the run, the correlation between
/// torque T and gap, and the error of the mean normal force F_N: the variance of T is that of the
/// mean of T - r F_N, r: mean torque over mean normal force. For a cohesive material, r exceeds the
/// slope dT/dF_N, and the standard error of the shear stress is slightly overestimated.
///
/// @param steps `recorded_steps` of the recording
/// @param liquid_content [1]
Measurements reduce_steps(const std::vector<RecordedStep>& steps, const Recording& recording,
                          const AnnularCell& cell, const GrainProperties& grains,
                          double liquid_content, RunClock& clock, const ImportSettings& choice);

}  // namespace pendular
