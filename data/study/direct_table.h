#pragma once

#include <string>
#include <vector>

#include "data/input_error.h"

namespace pendular {

class StudyTable;

/// A direct measurement of an effect as a study states it. What it means is not known here: the
/// unit is the effect's.
struct StatedDirect {
    std::string effect;
    std::string value;  ///< empty where it has not been measured yet
    std::string error;  ///< standard error
    double cost = 1;    ///< in dry readings
    Position effect_position = {}, value_position = {}, error_position = {};
};

/// [[direct]] of a study: what was measured.
/// @throws InputError for anything missing or unknown
std::vector<StatedDirect> read_direct(const StudyTable& root);

/// [[rig.direct]]: what can be measured.
/// @throws InputError for anything missing, unknown or impossible
std::vector<StatedDirect> read_direct_of_rig(const StudyTable& rig);

}  // namespace pendular
