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
    std::string quantity;  ///< name of the saturated column: "torque" or "normal_force"
    double limit = 0;  ///< largest magnitude of the column that the instrument records [N m or N]
    std::set<int> lines;  ///< line numbers of the saturated rows in the file
    /// p value of the saturation [1]: probability that an unlimited column appears as clearly
    /// saturated by chance.
    double p = 1;
};

/// Finds the columns of a recording (torque, normal force) that are cut off at their largest
/// magnitude, for one of three reasons:
/// - More separate runs of rows reach the largest value than reach values just below it.
/// - The torque stays at the largest value from row to row, while other rows of the recording
///   differ from their neighbours.
/// - The torques of at least three steps with the largest forces agree within 0.5 %, while the
///   force increases by at least 20 % from each step to the next.
///
/// Rows are saturated if they differ from the largest value by at most half the resolution or at
/// most 2e-4 of the largest value. For the third reason, all rows of the steps are saturated. The
/// first two reasons require at least three saturated rows, p < 1e-4, and clearly lower rows beside
/// the saturated rows.
std::vector<Saturation> saturations(const Recording& recording,
                                    const std::vector<RecordedStep>& steps);

/// Reports spikes in saturated rows as saturation: removes the data points from the lists of spikes
/// (`RecordedStep::spikes`) and adds them to `result.excluded` as saturated. In
/// `RecordedStep::series`, the values of the data points remain replaced by medians, as for spikes.
/// @param saturated saturated columns of the recording
/// @param file path of the recording
void separate_from_spikes(const std::vector<Saturation>& saturated, const std::string& file,
                          std::vector<RecordedStep>& steps, Measurements& result);

/// Adds a finding to `part.findings` for each step with at least three saturated rows. Unless
/// `choice.keep_implausible` is set, readings of which more than 1 in 100 rows are saturated are
/// moved to `part.excluded`.
/// @param saturated saturated columns of the recording
/// @param part readings that were made from the recording
void set_aside_saturated(const std::vector<Saturation>& saturated, const Recording& recording,
                         const std::vector<RecordedStep>& steps, const ImportSettings& choice,
                         Measurements& part);

/// Adds one message to `measurements.doubts` for each column (torque, normal force) that is
/// saturated in any recording of the study.
void doubt_saturated(Measurements& measurements, const ImportSettings& choice);

}  // namespace pendular
