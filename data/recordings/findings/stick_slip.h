#pragma once

#include <optional>
#include <span>
#include <vector>

#include "data/recordings/findings/recorded_step.h"
#include "data/remarks/remark.h"

namespace pendular {

/// Sudden drops of a series that rises slowly between them, as the torque does in stick-slip.
struct Slips {
    double drop = 0;     ///< median size of a drop, in the unit of the series
    double samples = 0;  ///< mean number of values from drop to drop
    double p = 1;  ///< probability of at least as many drops among sudden changes of noise [1]
};

/// Finds sudden drops of a series and tests whether they are more frequent than sudden rises. In
/// noise, both are equally frequent, and p is binomial with probability 1/2. A sudden change is a
/// run of increments of one sign that each differ from the median increment by more than three
/// times the robust deviation of all increments and by more than 2.5 times the resolution.
///
/// The test is repeated with means of 2, 4 and 8 neighbouring values. Returns the test with the
/// smallest p value, multiplied by the number of tests; empty for fewer than 40 values.
/// @param resolution in the unit of the series
std::optional<Slips> slips(std::span<const double> samples, double resolution);

/// Tests the torque in the `level_part` of each step for stick-slip. Returns one entry for each
/// test, significant or not.
std::vector<Remark> stick_slip_tests(const std::string& file,
                                     const std::vector<RecordedStep>& steps);

}  // namespace pendular
