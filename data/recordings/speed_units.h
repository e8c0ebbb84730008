#pragma once

#include "data/reading.h"

namespace pendular {

/// Adds a doubt to `all` if the angular velocities of some recordings differ from those of most
/// others by the factor between two units: 60/(2 pi), between 1/min and rad/s, or 2 pi, between
/// turn/s and rad/s. The factor must hold within 0.2 % at all steps, at least two, that two
/// recordings took at equal normal stress and liquid content. The recordings keep their readings.
/// Does nothing for more than 500 recordings, since the time grows with the square of their number.
void doubt_speed_units(Measurements& all);

}  // namespace pendular
