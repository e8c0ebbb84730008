#pragma once

#include <optional>
#include <span>
#include <vector>

#include "data/recordings/findings/finding.h"
#include "data/recordings/findings/recorded_step.h"

namespace pendular {

/// Trend of a series and curvature of the trend, with standard errors that include autocorrelation.
/// The series is fitted by
///     mean + change x/2 + bend (3 x^2 - 1)/2,   x from -1 (first value) to 1 (last value)
struct Course {
    double mean = 0;  ///< fitted mean of the series, in the unit of the series
    /// Change of the fitted trend from the first to the last value, in the unit of the series.
    double change = 0;
    /// Standard error of the change of the fitted trend from the first to the last value, in the
    /// unit of the series.
    double change_error = 0;
    /// Coefficient of the curvature (3 x^2 - 1)/2 of the trend, in the unit of the series; x
    /// increases from -1 at the first value to 1 at the last value.
    double bend = 0;
    /// Standard error of the coefficient of the curvature (3 x^2 - 1)/2, in the unit of the series.
    double bend_error = 0;
    /// Degrees of freedom of the standard errors of the trend: number of independent values minus
    /// three.
    double freedom = 1;

    /// Returns the distance, in the unit of the series, between the last value and the constant
    /// value that the series approaches exponentially. The distance follows from the fitted means
    /// of the three thirds of the series. The distance is 0 if the series approaches no constant
    /// value.
    double distance_at_end() const;
};

/// Fits the trend and the curvature of the trend to evenly spaced values. The result is empty for
/// less than `shortest_step` values, and for values without noise.
std::optional<Course> course_of(std::span<const double> samples);

/// Tests for each step whether torque or gap still approaches a steady value at the end of the
/// step. Returns one entry for each test, significant or not. The p value tests the change over the
/// second half of the step. The p value is 1 if the trend does not clearly bend towards a constant
/// value, or if the constant value is less than 0.5 % away at the end of the step.
/// @param file path of the recording
std::vector<RecordingFinding> run_in_tests(const std::string& file,
                                           const std::vector<RecordedStep>& steps);

/// Trend of torque or gap over the second half of one step.
struct StepTrend {
    std::string quantity;  ///< name of the column with the trend: "torque" or "height"
    std::string file;      ///< path of the recording that contains the step
    int step = 0;          ///< number of the step in its file, from 1
    Course course;
};

/// Returns the trends of torque and gap over the second half of each step in which the lid turns
/// and that has at least 40 data points.
/// @param file path of the recording
std::vector<StepTrend> step_trends(const std::string& file, const std::vector<RecordedStep>& steps);

/// Tests whether torque or gap drifts in one direction through the steps of a study. Returns at
/// most one test for each column, and no test of a column with fewer than three steps. The test
/// compares the weighted mean of the relative changes (change divided by mean) over the second
/// halves of the steps with the standard error of this mean. The p value is 1 if fewer than three
/// quarters of the steps change in the direction of the mean.
/// @param trends trends of torque and gap in the steps, from `step_trends`
/// @param unfinished findings on steps in which torque or gap still approaches its steady value;
///         these steps are left out
std::vector<RecordingFinding> drift_tests(const std::vector<StepTrend>& trends,
                                          const std::vector<RecordingFinding>& unfinished);

}  // namespace pendular
