#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "data/recordings/step_series.h"

namespace pendular {

/// Indices of the samples that are spikes in a series, in ascending order. A spike is one to three
/// neighbouring samples, each of which differs from the median of the 11 samples around it by more
/// than 20 times the noise (`sample_noise`) and by more than 5 % of the median. The first and last
/// five samples are never spikes. Empty if more than one sample in twenty would be a spike.
std::vector<std::size_t> spikes(std::span<const double> series);

/// Replaces each spike in torque, normal force and height of a step by the median of the 11 samples
/// around it.
/// @return indices of the samples that changed, in ascending order
std::vector<std::size_t> take_out_spikes(StepSeries& series);

}  // namespace pendular
