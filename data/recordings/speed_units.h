#pragma once

#include "data/reading.h"

namespace pendular {

/// Finds recordings whose angular velocities differ from those of most others by the factor between
/// two units. It must hold within 0.2 % at all steps, at least two, that two recordings took at
/// equal normal stress and liquid content. Returns one remark for each factor; none for more than
/// 500 recordings, since the time grows with the square of their number.
std::vector<Remark> other_speed_units(const std::vector<Reading>& readings);

}  // namespace pendular
