#pragma once

#include <string>
#include <vector>

#include "data/input_error.h"

namespace pendular {

class StudyTable;

/// A measurement of an effect's parameter by itself, such as the torque of the empty cell, as texts
/// of study.toml. The texts are not converted yet, since the effect determines their unit.
struct StatedDirect {
    std::string effect;  ///< name of the effect
    std::string value;   ///< measured value with its unit; empty if not measured yet
    std::string error;   ///< standard error with its unit
    double cost = 1;     ///< cost of the measurement, in costs of a dry reading [1]
    /// Positions of effect, value and error in the file.
    Position effect_position = {}, value_position = {}, error_position = {};
};

/// Reads the direct measurements that were made: the tables [[direct]] of study.toml.
/// @throws InputError if a table lacks a key or has an unknown one
std::vector<StatedDirect> read_direct(const StudyTable& root);

/// Reads the direct measurements that the rig can make: the tables [[rig.direct]] of study.toml.
/// @throws InputError if a table lacks a key or has an unknown one, or if a cost is not positive
std::vector<StatedDirect> read_direct_of_rig(const StudyTable& rig);

}  // namespace pendular
