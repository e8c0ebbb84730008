#pragma once

#include <set>
#include <string>
#include <vector>

#include "data/reading.h"
#include "data/recordings/findings/recorded_step.h"
#include "data/study/study.h"

namespace pendular {

/// Rows of one column of a recording that stand at the largest value that the instrument gives.
struct Saturation {
    std::string quantity;  ///< "torque" or "normal_force"
    double limit = 0;      ///< largest value, as magnitude [N m or N]
    std::set<int> lines;   ///< lines of the saturated rows in the file
    double p = 1;          ///< probability that an unsaturated recording has such rows [1]
};

/// Finds columns of a recording that are cut off at their largest value (torque by magnitude,
/// normal force). Rows count as saturated if they are within half the resolution or within 2e-4 of
/// the largest value. A column is saturated in any of these cases, the first two at p < 1e-4:
/// - More separate runs of rows reach the largest value than reach values just below it. Ordinary
///   noise has fewer, since values become rarer towards the largest one; the p value is binomial.
/// - The torque stays at the largest value from row to row, while other rows of the recording
///   differ from their neighbours.
/// - The torques of at least three steps with the largest forces agree within 0.5 %, while the
///   force increases by at least 20 % from each to the next.
/// Smooth peaks are no saturation: rows beside a saturated run must lie clearly lower.
std::vector<Saturation> saturations(const Recording& recording,
                                    const std::vector<RecordedStep>& steps);

/// Removes saturated samples from the spikes of steps, so that they are not reported as spikes, and
/// lists them in `result.excluded`: their values were replaced.
void separate_from_spikes(const std::vector<Saturation>& saturated, const std::string& file,
                          std::vector<RecordedStep>& steps, Measurements& result);

/// Adds one finding for each step with at least three saturated rows, and moves readings of which
/// more than 1 in 100 rows are saturated to `part.excluded`, unless `choice` keeps implausible
/// readings.
void set_aside_saturated(const std::vector<Saturation>& saturated, const Recording& recording,
                         const std::vector<RecordedStep>& steps, const ImportSettings& choice,
                         Measurements& part);

/// Adds a doubt (reason not to believe values) for each column that is saturated in a study.
void doubt_saturated(Measurements& measurements, const ImportSettings& choice);

}  // namespace pendular
