#pragma once

#include "data/reading.h"

namespace pendular {

/// Adds a doubt if the angular velocities of some recordings differ from those of most others by
/// the factor between two units: 60/(2 pi) (1/min and rad/s) or 2 pi (turn/s and rad/s). It must
/// hold within 0.2 % at all steps, at least two, that two recordings took at equal normal stress
/// and liquid content. The readings stay. Does nothing for more than 500 recordings, since the time
/// grows with the square of their number.
void doubt_speed_units(Measurements& all);

}  // namespace pendular
