#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "data/recordings/step_series.h"

namespace pendular {

/// Returns the indices of the values that are spikes in a series, in ascending order. A spike is
/// one to three neighbouring values. Each value of a spike differs from the median of the 11 values
/// centred on the value by more than 20 times the noise (`sample_noise`) and by more than 5 % of
/// the median. The first and last five values are never spikes. The result is empty if more than
/// one value in twenty would be a spike.
std::vector<std::size_t> spikes(std::span<const double> series);

/// Removes spikes from torque, normal force and height of a step: replaces each value in a spike by
/// the median of the 11 data points centred on the value.
/// @return indices of the data points that changed, in ascending order
std::vector<std::size_t> take_out_spikes(StepSeries& series);

}  // namespace pendular
