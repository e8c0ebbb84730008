#pragma once

#include "data/files/formats/table_parts.h"

namespace pendular {

/// Finds the tables in one of points at common loads, with the shear stress, or the torque, of each
/// material or liquid in a column of its own: "Normal stress [kPa]; Shear stress dry [kPa]; Shear
/// stress 1 % water [kPa]". The name of the stress may stand once, over the columns. Each column
/// becomes a table with the loads beside it. Its own words ("dry") become its title; those that
/// number repetitions ("2", "test 2") become "repetitions" for all. There are none where the words
/// are those of statistics ("mean") or of sensors.
SeveralTables stresses_beside(const SourceLines& source, char delimiter);

}  // namespace pendular
