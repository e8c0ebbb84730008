#pragma once

#include <string>
#include <vector>

#include "data/input_error.h"

namespace pendular {

class StudyTable;

/// Direct measurement as stated in study.toml. Value and standard error are kept as texts with
/// units, since the unit of the effect's parameter is not known when study.toml is read.
struct StatedDirect {
    std::string effect;
    std::string value;  ///< such as "0.1 mN m"; empty: not measured yet
    std::string error;
    double cost = 1;  ///< relative to the cost of a dry reading [1]
    Position effect_position = {}, value_position = {}, error_position = {};
};

/// Reads the tables [[direct]] of study.toml (keys effect, value, error), in the order of the file.
/// @throws InputError if a table lacks a key, has an unknown key or an empty value
std::vector<StatedDirect> read_direct(const StudyTable& root);

/// Reads the tables [[rig.direct]] of study.toml (keys effect, error and, optionally, cost), in the
/// order of the file: direct measurements that the rig can make.
/// @param rig table [rig]
/// @throws InputError if a table lacks a key or has an unknown key, or if a cost is not positive
std::vector<StatedDirect> read_direct_of_rig(const StudyTable& rig);

}  // namespace pendular
