#pragma once

#include <string>
#include <vector>

#include "data/input_error.h"

namespace pendular {

class StudyTable;

/// A direct measurement of an effect's parameter, such as the torque of the empty cell, as opposed
/// to a fit of the parameter. Value and error are texts of study.toml. The texts are not converted
/// yet, since the effect determines their unit.
struct StatedDirect {
    std::string effect;  ///< name of the effect
    std::string value;   ///< measured value with its unit; empty if not measured yet
    std::string error;   ///< standard error with its unit
    double cost = 1;     ///< cost of the measurement over the cost of a dry reading [1]
    /// Positions of effect, value and error in study.toml.
    Position effect_position = {}, value_position = {}, error_position = {};
};

/// Reads the direct measurements of effect parameters that were made: tables [[direct]] of
/// study.toml, with the keys effect, value and error.
/// @throws InputError if a table lacks a key, has an unknown one or an empty value
std::vector<StatedDirect> read_direct(const StudyTable& root);

/// Reads the direct measurements of effect parameters that a measuring rig can make: tables
/// [[rig.direct]] of study.toml, with the keys effect, error and, optionally, cost.
/// @param rig table [rig] of study.toml
/// @throws InputError if a table lacks a key or has an unknown one, or if a cost is not positive
std::vector<StatedDirect> read_direct_of_rig(const StudyTable& rig);

}  // namespace pendular
