#pragma once

#include <optional>
#include <span>
#include <vector>

#include "data/recordings/findings/finding.h"
#include "data/recordings/findings/recorded_step.h"

namespace pendular {

/// Course of a series: its trend and the bend of the trend, with errors that take autocorrelation
/// into account. The series is fitted by a + change x/2 + bend (3 x^2 - 1)/2, with x from -1 to 1.
struct Course {
    double mean = 0;    ///< mean of the series, in its unit
    double change = 0;  ///< change from the first to the last sample, in the unit of the series
    double change_error = 0;  ///< standard error of `change`, in the unit of the series
    double bend = 0;          ///< second Legendre coefficient, in the unit of the series
    double bend_error = 0;    ///< standard error of `bend`, in the unit of the series
    double freedom = 1;       ///< degrees of freedom of the errors: independent samples less three

    /// Distance from the level that the series approaches, at its last sample, in its unit: for an
    /// exponential approach with the fitted means of the three thirds. 0 if it does not approach
    /// one.
    double distance_at_end() const;
};

/// Course of evenly spaced samples. Empty for less than `shortest_step` samples, and for samples
/// without noise.
std::optional<Course> course_of(std::span<const double> samples);

/// Tests whether torque and gap still approach their levels at the end of each step: a trend over
/// the second half of the step that bends towards a level at least 0.5 % away. One entry for each
/// test.
std::vector<RecordingFinding> run_in_tests(const std::string& file,
                                           const std::vector<RecordedStep>& steps);

/// Change of torque or gap over the second half of one step.
struct StepTrend {
    std::string quantity;  ///< "torque" or "height"
    std::string file;
    int step = 0;
    Course course;
};

/// Trends of torque and gap over the second half of each step that turns the lid.
std::vector<StepTrend> step_trends(const std::string& file, const std::vector<RecordedStep>& steps);

/// Tests of torque and gap for a drift in one direction through at least three steps of a study:
/// the weighted mean of the relative changes over the second halves of the steps, with the larger
/// of the errors from within and from between steps. Steps whose run-in is among `unfinished` are
/// left out. A drift has the same direction in at least three of four steps.
std::vector<RecordingFinding> drift_tests(const std::vector<StepTrend>& trends,
                                          const std::vector<RecordingFinding>& unfinished);

}  // namespace pendular
