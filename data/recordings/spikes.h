#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "data/recordings/step_series.h"

namespace pendular {

/// Places of spikes in a series: one to three samples that leave the median of the 11 around them
/// by more than 20 times the noise from sample to sample and more than 5 % of its size, in any
/// unit. None where more than one sample in twenty would be one, which then are no spikes.
std::vector<std::size_t> spikes(std::span<const double> series);

/// Replaces spikes of torque, normal force and height by the medians of the samples around them.
/// @returns the places that changed, in rising order
std::vector<std::size_t> take_out_spikes(StepSeries& series);

}  // namespace pendular
