#pragma once

#include <string>
#include <vector>

#include "data/input_error.h"

namespace pendular {

class StudyTable;

/// Direct measurement of an effect's parameter without shearing grains, such as the torque of the
/// empty cell, as stated in study.toml. Value and standard error are kept as texts, since the unit
/// of the effect's parameter is not known when study.toml is read.
struct StatedDirect {
    std::string effect;  ///< name of the effect whose parameter is measured directly
    /// Measured value of the effect's parameter, with its unit, such as "0.1 mN m"; empty if the
    /// parameter is not measured yet.
    std::string value;
    std::string error;  ///< standard error of the measured value, with its unit
    double cost = 1;  ///< cost of the direct measurement, relative to the cost of a dry reading [1]
    /// Positions of the values of the keys effect, value and error in study.toml.
    Position effect_position = {}, value_position = {}, error_position = {};
};

/// Reads the tables [[direct]] of study.toml, in the order of the file. Each table states the value
/// of an effect's parameter, measured without shearing grains, by the keys effect, value and error.
/// @param root top level of study.toml
/// @throws InputError if a table lacks a key, has an unknown key or an empty value
std::vector<StatedDirect> read_direct(const StudyTable& root);

/// Reads the tables [[rig.direct]] of study.toml, in the order of the file. Each table names an
/// effect whose parameter a measuring rig can measure without shearing grains, with the keys
/// effect, error and, optionally, cost.
/// @param rig table [rig] of study.toml
/// @throws InputError if a table lacks a key or has an unknown key, or if a cost is not positive
std::vector<StatedDirect> read_direct_of_rig(const StudyTable& rig);

}  // namespace pendular
