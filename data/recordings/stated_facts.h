#pragma once

#include <optional>
#include <string>
#include <vector>

#include "data/files/formats/block_file.h"

namespace pendular {

/// Number in the header of a file.
struct StatedValue {
    double value = 0;  ///< in SI units
    int line = 0;      ///< from 1
    std::string key;   ///< as in the file, such as "Inner radius"
    std::string text;  ///< number and unit as in the file, such as "21 mm"
};

/// Statement of one line above a table, taken apart.
struct StatedFact {
    std::string name;  ///< `folded_name`, without a unit
    std::string unit;  ///< in brackets behind the name, as in "Radius (mm);20"; empty: none
    std::string key;   ///< as in the file
    std::string text;  ///< number and unit as in the file, or words
    int line = 0;      ///< from 1
};

/// Facts above the table of a file. "Inner diameter / outer diameter: 40 / 80 mm" is two, and so is
/// "r_i 20 mm" behind "Cell:", or alone in a line.
std::vector<StatedFact> stated_facts(const BlockFile& file);

/// Value of a fact in SI units; empty if it is no positive number with a unit of this dimension.
std::optional<double> positive_value(const StatedFact& fact, const char* unit,
                                     const NumberStyle& style);

}  // namespace pendular
