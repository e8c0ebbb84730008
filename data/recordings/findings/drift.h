#pragma once

#include <optional>
#include <span>
#include <vector>

#include "data/recordings/steps.h"
#include "data/remarks/remark.h"

namespace pendular {

/// Trend and curvature of a series, in its unit, with standard errors that include autocorrelation.
/// The series is fitted by
///     mean + change x/2 + bend (3 x^2 - 1)/2,   x from -1 (first value) to 1 (last value)
struct Course {
    double mean = 0;
    double change = 0;  ///< from the first to the last value
    double change_error = 0;
    double bend = 0;
    double bend_error = 0;
    double freedom = 1;  ///< of the standard errors: number of independent values minus three

    /// Returns the distance, in the unit of the series, of its last value from the constant value
    /// that it approaches exponentially, by the fitted means of its thirds; 0 if it approaches
    /// none.
    double distance_at_end() const;
};

/// Returns the fit to evenly spaced values; empty for less than `shortest_step` values, and for
/// values without noise.
std::optional<Course> course_of(std::span<const double> samples);

/// Tests for each step whether torque or gap still approaches a steady value at its end, by the
/// change over its second half. Returns one entry for each test, significant or not. The p value is
/// 1 if the trend does not clearly bend towards a constant value, or ends less than 0.5 % from it.
std::vector<Remark> run_in_tests(const std::string& file, const std::vector<RecordedStep>& steps);

/// Trend of torque or gap over the second half of one step.
struct StepTrend {
    std::string quantity;  ///< "torque" or "height"
    std::string file;
    int step = 0;  ///< number in its file, from 1
    Course course;
};

/// Returns the trends of torque and gap over the second half of each step in which the lid turns
/// and that has at least 40 data points.
std::vector<StepTrend> step_trends(const std::string& file, const std::vector<RecordedStep>& steps);

/// Tests whether torque or gap drifts in one direction through the steps of a study: compares the
/// weighted mean of the relative changes over the second halves with its standard error. Returns at
/// most one test for each column, none for fewer than three steps. The p value is 1 if fewer than
/// three quarters of the steps change in the direction of the mean.
/// @param unfinished findings of `run_in_tests`, whose steps are left out
std::vector<Remark> drift_tests(const std::vector<StepTrend>& trends,
                                const std::vector<Remark>& unfinished);

}  // namespace pendular
