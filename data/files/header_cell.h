#pragma once

#include <string>
#include <string_view>

namespace pendular {

/// Parts of a cell in the header of a table, such as "Torque_sd [mN m]".
struct HeaderCell {
    std::string name;        ///< "Torque"; without a mark of standard deviations such as "_sd"
    std::string unit;        ///< "mN m"; empty if none is given
    bool deviation = false;  ///< whether the column contains standard deviations
};

/// Splits a cell in the header of a table into name and unit. The cell reads `name [unit]`, `name
/// (unit)`, `name in unit` or `name`.
HeaderCell parse_header_cell(std::string_view text);

}  // namespace pendular
