#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "data/annular_cell.h"
#include "data/reading.h"
#include "data/recordings/steps.h"
#include "data/remarks/remark.h"

namespace pendular {

/// Probability [1] that chance alone causes a finding of one kind in a faultless study. With six
/// kinds, chance causes a finding in at most 3 % of faultless studies, below the intended 5 %; the
/// margin covers approximations in the distributions of the test statistics.
constexpr double finding_significance = 0.005;

/// Returns the significant findings among all N tests of one kind in a study: those with the k
/// smallest p values, where k is the largest number for which the k-th smallest is at most
/// alpha k/N, alpha = `finding_significance`. If the recordings have no fault, at least one finding
/// is significant with the probability alpha.
/// Source: Benjamini and Hochberg, J. R. Stat. Soc. B 57 (1995) 289.
std::vector<Remark> significant_findings(std::vector<Remark> tested);

/// Returns the probability [1] that Student's t is farther from zero than z, an estimate over its
/// standard error of `freedom` degrees of freedom (fewer than 1 count as 1); 1 if z is not a
/// number.
double two_sided_p(double z, double freedom);

/// Tests torque, normal force and gap in the `level_part` of each step for one or two periods per
/// turn of the lid. Returns one entry for each test, significant or not.
std::vector<Remark> wobble_tests(const std::string& file, const std::vector<RecordedStep>& steps);

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
/// Five drops or more are certain (p = 0), however few they are, if they are far beyond the noise,
/// equally large, and each as large as the slow rise before it.
///
/// The test is repeated with means of 2, 4 and 8 neighbouring values. Returns the test with the
/// smallest p value, multiplied by the number of tests; empty for fewer than 40 values.
/// @param resolution in the unit of the series
std::optional<Slips> slips(std::span<const double> samples, double resolution);

/// Tests the torque in the `level_part` of each step for stick-slip. Returns one entry for each
/// test, significant or not.
std::vector<Remark> stick_slip_tests(const std::string& file,
                                     const std::vector<RecordedStep>& steps);

/// Finds columns of a recording that are cut off at their largest magnitude, for one of three
/// reasons:
/// - More separate runs of rows reach the largest value than reach values just below it.
/// - The torque stays at the largest value from row to row, while other rows of the recording
///   differ from their neighbours.
/// - The torques of at least three steps with the largest forces agree within 0.5 %, while the
///   force increases by at least 20 % from each step to the next.
///
/// Rows are saturated if they differ from the largest value by at most half the resolution or 2e-4
/// of it; for the third reason, all rows of the steps. The first two reasons require at least three
/// saturated rows, p < 1e-4, and clearly lower rows beside them. Returns one remark for each
/// column, with its saturated lines and its largest magnitude as `size`.
std::vector<Remark> saturations(const Recording& recording, const std::vector<RecordedStep>& steps);

/// Finds rows of an interval whose torque, or shear stress, stands at its largest value, as
/// `saturations` does; with their share of the rows.
std::optional<Remark> saturated_shear(const std::string& file, const IntervalSeries& series);

/// Returns a remark for each step with at least three saturated rows.
std::vector<Remark> saturated_steps(const std::vector<Remark>& saturations,
                                    const Recording& recording,
                                    const std::vector<RecordedStep>& steps);

/// Removes saturated rows from the spikes of steps, and returns a remark on each. In
/// `RecordedStep::series`, they remain replaced by medians, as spikes are.
std::vector<Remark> separate_from_spikes(const std::vector<Remark>& saturations,
                                         const std::string& file, std::vector<RecordedStep>& steps);

/// Returns one remark for each column that is saturated in any recording of the study.
/// @param found remarks of the study
std::vector<Remark> saturated_columns(const std::vector<Remark>& found);

/// Tests torque and gap for a sudden change between two recordings, from which on readings differ
/// by a common factor or offset from earlier ones at the same condition. Returns one entry for
/// torque and one for gap with the p value of the most significant change, 1 if a steady trend
/// through the recordings fits better; none if the readings are too few.
///
/// If too few conditions are repeated, a fitted function of normal stress s22 and inertial number I
/// takes the place of the mean at each condition:
///     a + b ln s22 + c (ln s22)^2 + d ln I
/// @param readings from recordings, not from tables
std::vector<Remark> level_change_tests(const std::vector<Reading>& readings,
                                       const AnnularCell& cell);

}  // namespace pendular
