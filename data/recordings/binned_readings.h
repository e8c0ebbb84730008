#pragma once

#include <cstddef>
#include <vector>

#include "data/reading.h"

namespace pendular {

/// Averages readings with similar conditions in bins, so that statistical tests take no longer for
/// many readings than for few. Returns one mean reading per bin, in the order of the first members
/// of the bins. A mean reading has the position in the file of the first member of its bin. If
/// there are at most `most` readings, the function returns the readings unchanged.
///
/// Readings of one bin agree in liquid content, volume of grains, state (steady shear, or failure
/// after equal preshear) and estimate of the scatter between replicates (repeated readings at one
/// condition). A bin joins different files only if too many bins would be needed otherwise, and
/// never if the errors come only from the scatter within one run. Averaging does not reduce errors
/// that readings have in common.
/// @param most maximum number of bins; exceeded only if more kinds of readings must not be averaged
///         with each other
std::vector<Reading> binned_readings(const std::vector<Reading>& readings, std::size_t most);

}  // namespace pendular
