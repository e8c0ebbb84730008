#pragma once

#include <optional>
#include <span>
#include <vector>

#include "data/recordings/findings/finding.h"
#include "data/recordings/findings/recorded_step.h"

namespace pendular {

/// Sudden drops in a series that rises slowly in between.
struct Slips {
    double drop = 0;     ///< median size of a drop, in the unit of the series
    double samples = 0;  ///< mean number of samples from one drop to the next
    /// Probability that a series whose noise looks alike forwards and backwards in time has as many
    /// more sudden drops than sudden rises [1].
    double p = 1;
};

/// Sudden drops of a series. A sudden change is a run of increments of one sign that exceed three
/// times the robust deviation of all increments from their median, and 2.5 times the resolution.
/// Noise of any correlation has as many sudden rises as drops; the p value is that of the binomial
/// law with probability 1/2. The series is examined row by row and as means of 2, 4 and 8 rows, and
/// p is multiplied by the number of these tests. Empty for less than 40 samples.
/// @param resolution resolution of the series, in its unit
std::optional<Slips> slips(std::span<const double> samples, double resolution);

/// Tests for stick-slip of the torque in the steady part of each step, one entry for each test.
std::vector<RecordingFinding> stick_slip_tests(const std::string& file,
                                               const std::vector<RecordedStep>& steps);

}  // namespace pendular
