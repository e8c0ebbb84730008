#pragma once

#include "data/reading.h"

namespace pendular {

/// Adds a doubt to `all` for each pair of recordings whose angular velocities differ by the factor
/// between two units: 60/(2 pi), between 1/min and rad/s, or 2 pi, between turn/s and rad/s. The
/// factor must hold within 2 % at all steps that both recordings took at equal normal stress and
/// liquid content, at least two. The recordings keep their readings.
void doubt_speed_units(Measurements& all);

}  // namespace pendular
