#pragma once

#include <string>
#include <vector>

#include "data/input_error.h"

namespace pendular {

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
