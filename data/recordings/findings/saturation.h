#pragma once

#include <string>
#include <vector>

#include "data/recordings/findings/recorded_step.h"

namespace pendular {

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

}  // namespace pendular
