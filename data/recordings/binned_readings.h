#pragma once

#include <cstddef>
#include <vector>

#include "data/reading.h"

namespace pendular {

/// Averages readings (measured shear stress and solid fraction) with similar normal stress,
/// inertial number, height and time in bins, so that statistical tests take no longer for many
/// readings than for few. Returns one mean reading per bin, in the order of the first members of
/// the bins. A mean reading has the position in the file of the first member of its bin. If there
/// are at most `most` readings, the function returns the readings unchanged.
///
/// Readings of one bin agree in liquid content, volume of grains, state (steady shear, or failure
/// after equal preshear) and estimate of the scatter between replicates (repeated readings at one
/// condition). Readings of different files share a bin only if more than `most`/2 bins would be
/// needed otherwise. Readings whose errors come only from the scatter within one run never share a
/// bin with readings of another file. Averaging does not reduce errors that readings have in
/// common.
/// @param most maximum number of bins; exceeded only if there are more than `most` kinds of
///         readings that must not be averaged with each other
std::vector<Reading> binned_readings(const std::vector<Reading>& readings, std::size_t most);

}  // namespace pendular
