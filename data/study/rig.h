#pragma once

#include <optional>
#include <string>
#include <vector>

#include "data/grains.h"
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

/// Range of values to which a rig can set a quantity [SI unit].
struct Span {
    double least = 0, greatest = 0;
};

/// Conditions at which a measuring rig can take further readings, and their costs: table [rig] of
/// study.toml. Costs are relative to the cost of a dry reading [1]. The rig sets either the
/// inertial number or the shear rate; the other one is empty.
struct Rig {
    Span normal_stress;                         ///< [Pa]
    std::optional<Span> inertial_number;        ///< [1]
    std::optional<Span> shear_rate;             ///< [1/s]
    std::vector<double> liquid_contents = {0};  ///< [1]; 0: dry
    /// Solid volumes of the grains with which the cell can be filled [m^3]; empty: always the
    /// volume in [cell].
    std::vector<double> bead_volumes = {};
    int repeats = 5;                  ///< most further readings at one condition
    int readings = 12;                ///< most further readings at all conditions together
    double wet_cost = 1;              ///< of a wet reading
    double filling_cost = 0;          ///< of filling the cell with a different amount of grains
    std::vector<double> waits = {0};  ///< waiting times before the next reading to choose from [s]
    double hour_cost = 1;             ///< of waiting for an hour
    std::vector<StatedDirect> direct = {};  ///< direct measurements that the rig can make
};

/// Reads the table [rig] of study.toml; empty if it is missing.
/// @param grains grains whose density converts the key bead_mass to a solid volume
/// @param has_liquid whether study.toml has [liquid], required for liquid contents above 0
/// @throws InputError at a key that is missing, unknown or has an invalid value
std::optional<Rig> read_rig(const StudyTable& root, const GrainProperties& grains, bool has_liquid);

class StudyTable;

/// Standard uncertainty of a quantity that all readings share, as the table [instrument] of
/// study.toml states it. The value is kept as text with its unit, since which unit fits depends on
/// what the name means.
struct StatedUncertainty {
    std::string
        name;  ///< effect of the instrument, such as "torque-gain", or key, such as "density"
    std::string value;       ///< such as "1 %" or "30 um"
    Position position = {};  ///< of the value
};

/// Standard uncertainties of what all readings share: table [instrument] of study.toml.
struct InstrumentTable {
    /// Class of instruments whose typical uncertainties hold for all that `stated` lacks; empty:
    /// those count as 0.
    enum class Class { none, rheometer, table } kind = Class::none;
    Position class_position = {};
    std::vector<StatedUncertainty> stated = {};  ///< in alphabetical order; names are not checked
};

/// Reads the table [instrument] of study.toml.
/// @throws InputError if the class is unknown, or a value is neither a text nor a number
InstrumentTable read_instrument(const StudyTable& root);

}  // namespace pendular
