#pragma once

#include <string>
#include <vector>

#include "data/input_error.h"

namespace pendular {

class StudyTable;

/// A direct measurement of an effect as the study states it, not yet interpreted: its unit is that
/// of the effect's parameter.
struct StatedDirect {
    std::string effect;
    std::string value;  ///< empty where it has not been measured yet
    std::string error;  ///< standard error
    double cost = 1;    ///< in dry readings
    Position effect_position = {}, value_position = {}, error_position = {};
};

/// Reads the direct measurements that were made: [[direct]] of a study.
/// @throws InputError for anything missing or unknown
std::vector<StatedDirect> read_direct(const StudyTable& root);

/// Reads the direct measurements that the rig can make: [[rig.direct]].
/// @throws InputError for anything missing, unknown or impossible
std::vector<StatedDirect> read_direct_of_rig(const StudyTable& rig);

}  // namespace pendular
