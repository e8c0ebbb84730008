#pragma once

#include "data/files/formats/block_file.h"

namespace pendular {

/// Takes the stresses of the preshear of each block from the column that an instrument writes its
/// normal stress in or, for a table of points of one test, from lines above it such as "Preshear
/// normal stress: 5000 Pa".
void state_preshears(BlockFile& file);

}  // namespace pendular
