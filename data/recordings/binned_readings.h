#pragma once

#include <cstddef>
#include <vector>

#include "data/reading.h"

namespace pendular {

/// Averages readings with similar conditions in bins, so that statistical tests take no longer for
/// many readings than for few. Returns one mean reading per bin, in the order of the first members
/// of the bins. The position of a mean reading in a file is the position of the first member of its
/// bin. If there are at most `most` readings, they are returned unchanged.
///
/// Readings are averaged only if they have equal liquid content and volume of grains, are all
/// steady shear or all points of failure after equal preshear, and share one estimate of the
/// scatter between replicates (repeated readings at one condition). Readings whose errors come only
/// from the scatter within one run are averaged only with readings of their recording, since each
/// recording has its own filling of the cell. All other readings from different files are averaged
/// only if more than `most`/2 bins would be needed otherwise. Bins whose conditions differ most are
/// divided first, until the number of bins is `most`.
///
/// Stress ratios and solid fractions are averaged at the means of 1/(normal stress) and of
/// sqrt(inertial number), in which models are nearly linear. If one of these coordinates has the
/// spread w in a bin, the mean differs from the model by about w^2/2 times the second derivative of
/// the model. Averaging reduces the independent errors of the readings, but not the errors that
/// readings have in common.
/// @param most largest number of bins. There are more bins only if the readings are of more than
///         `most` kinds that must not be averaged with each other.
std::vector<Reading> binned_readings(const std::vector<Reading>& readings, std::size_t most);

}  // namespace pendular
