#pragma once

#include <optional>
#include <span>
#include <vector>

#include "data/recordings/findings/finding.h"
#include "data/recordings/findings/recorded_step.h"

namespace pendular {

/// Sudden drops of a series that rises slowly between the drops, as the torque does in stick-slip:
/// size of the drops, number of values from drop to drop, and excess of drops over sudden rises.
struct Slips {
    double drop = 0;     ///< median size of a sudden drop, in the unit of the series
    double samples = 0;  ///< mean number of values from one sudden drop to the next
    /// p value of the excess of sudden drops over sudden rises [1]: probability of at least as
    /// large an excess in noise, in which drops and rises are equally frequent.
    double p = 1;
};

/// Finds sudden drops of a series and tests whether drops are more frequent than sudden rises. A
/// sudden change is a run of increments of one sign. Each increment of the run differs from the
/// median increment by more than three times the robust deviation of all increments and by more
/// than 2.5 times the resolution. The p value is binomial with probability 1/2, since rises and
/// drops are equally frequent in noise.
///
/// The test is repeated with means of 2, 4 and 8 neighbouring values. The result is that of the
/// test with the smallest p value, which is multiplied by the number of tests. The result is empty
/// for fewer than 40 values.
/// @param resolution resolution of the series, in the unit of the series
std::optional<Slips> slips(std::span<const double> samples, double resolution);

/// Tests the torque in each step for stick-slip. The tested part is the part of the step after the
/// transient or, if the step never becomes steady, the second half of the step. Returns one entry
/// for each test with its p value, significant or not.
/// @param file path of the recording
std::vector<RecordingFinding> stick_slip_tests(const std::string& file,
                                               const std::vector<RecordedStep>& steps);

}  // namespace pendular
