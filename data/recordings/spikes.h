#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace pendular {

/// Longest spike [rows]: too few of 11 to move their median far.
constexpr std::size_t longest_spike = 3;

/// Returns the indices of spikes in ascending order: of one to three neighbouring values that
/// differ from the median of the 11 values around each by more than 20 times the noise
/// (`sample_noise`) and by more than `least_share` of the median. The first and last five values
/// are never spikes. Empty if more than 5 % of the values would be spikes.
std::vector<std::size_t> spikes(std::span<const double> series, double least_share = 0.05);

/// Replaces each spike by the median of the 11 values around it. Returns the indices of the spikes.
std::vector<std::size_t> replace_spikes(std::vector<double>& series, double least_share = 0.05);

}  // namespace pendular
