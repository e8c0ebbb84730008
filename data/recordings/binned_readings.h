#pragma once

#include <cstddef>
#include <vector>

#include "data/reading.h"

namespace pendular {

/// Means of readings at neighbouring conditions, in place of many readings: tests on the means cost
/// no more for many readings than for few. Readings are averaged only if they have equal liquid
/// content, are of the same kind (steady shear or failure after the same preshear), and share the
/// estimate of their scatter; readings of different tables only where there are more than `most`/2
/// combinations of these, and readings of different recordings never, since each is of a filling of
/// its own. Bins are divided where their conditions differ most, as long as there are
/// fewer than `most`.
///
/// The mean is taken of stress ratios and solid fractions, at the means of 1/(normal stress) and of
/// sqrt(inertial number), in which models are about linear: with a spread w of these in a bin, the
/// mean deviates from the model by about its second derivative times w^2/2. Errors of single
/// readings average out; errors that readings share do not.
/// @param most largest number of bins; fewer readings are returned as they are
/// @return readings in the order of the first members of their bins; the origin of each is that of
///         its first member
std::vector<Reading> binned_readings(const std::vector<Reading>& readings, std::size_t most);

}  // namespace pendular
