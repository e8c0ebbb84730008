#pragma once

#include <set>
#include <string>
#include <vector>

#include "data/reading.h"
#include "data/recordings/findings/recorded_step.h"
#include "data/study/study.h"

namespace pendular {

/// Rows of a recording in which torque or normal force is limited by the largest value that the
/// instrument records.
struct Saturation {
    std::string quantity;  ///< "torque" or "normal_force"
    double limit = 0;      ///< largest magnitude of the column [N m or N]
    std::set<int> lines;   ///< of the saturated rows
    double p = 1;  ///< probability that an unlimited column looks as saturated by chance [1]
};

/// Returns the columns of a recording that are cut off at their largest magnitude, for one of three
/// reasons:
/// - More separate runs of rows reach the largest value than reach values just below it.
/// - The torque stays at the largest value from row to row, while other rows of the recording
///   differ from their neighbours.
/// - The torques of at least three steps with the largest forces agree within 0.5 %, while the
///   force increases by at least 20 % from each step to the next.
///
/// Rows are saturated if they differ from the largest value by at most half the resolution or 2e-4
/// of it; for the third reason, all rows of the steps. The first two reasons require at least three
/// saturated rows, p < 1e-4, and clearly lower rows beside them.
std::vector<Saturation> saturations(const Recording& recording,
                                    const std::vector<RecordedStep>& steps);

/// Moves saturated rows from `RecordedStep::spikes` to `result.excluded`. In
/// `RecordedStep::series`, they remain replaced by medians, as spikes are.
void separate_from_spikes(const std::vector<Saturation>& saturated, const std::string& file,
                          std::vector<RecordedStep>& steps, Measurements& result);

/// Adds a finding for each step with at least three saturated rows. Unless
/// `choice.keep_implausible`, moves readings of which more than 1 in 100 rows are saturated to
/// `part.excluded`.
/// @param part readings of the recording
void set_aside_saturated(const std::vector<Saturation>& saturated, const Recording& recording,
                         const std::vector<RecordedStep>& steps, const ImportSettings& choice,
                         Measurements& part);

/// Adds one doubt for each column that is saturated in any recording of the study.
void doubt_saturated(Measurements& measurements, const ImportSettings& choice);

}  // namespace pendular
