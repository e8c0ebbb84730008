#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "data/recordings/step_series.h"

namespace pendular {

/// Returns the indices of the values that are spikes in a series, in ascending order. A spike has
/// one to three neighbouring values. Each value differs from the median of the 11 values around it
/// by more than 20 times the noise (`sample_noise`) and by more than 5 %. The first and last five
/// values are never spikes. The result is empty if more than 5 % of the values would be spikes.
std::vector<std::size_t> spikes(std::span<const double> series);

/// Removes spikes from torque, normal force and height of a step: replaces each value in a spike by
/// the median of the 11 data points centred on the value.
/// @return indices of the data points that changed, in ascending order
std::vector<std::size_t> take_out_spikes(StepSeries& series);

}  // namespace pendular
