#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "data/recordings/step_series.h"

namespace pendular {

/// Returns the indices of spikes in ascending order: of one to three neighbouring values that
/// differ from the median of the 11 values around each by more than 20 times the noise
/// (`sample_noise`) and by more than 5 %. The first and last five values are never spikes. Empty if
/// more than 5 % of the values would be spikes.
std::vector<std::size_t> spikes(std::span<const double> series);

/// Replaces each spike in torque, normal force and height by the median of the 11 values around it.
/// Returns the indices of the data points that changed, in ascending order.
std::vector<std::size_t> take_out_spikes(StepSeries& series);

}  // namespace pendular
