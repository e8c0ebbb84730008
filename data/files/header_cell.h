#pragma once

#include <string>
#include <string_view>

namespace pendular {

/// Parts of a header cell (first line of a table of measurements), such as "Torque_sd [mN m]".
struct HeaderCell {
    std::string name;        ///< "Torque"; a mark of standard deviations such as "_sd" is removed
    std::string unit;        ///< "mN m"; empty if none is given
    bool deviation = false;  ///< whether the column holds standard deviations
};

/// Splits a header cell `name [unit]`, `name (unit)`, `name in unit` or `name` into its parts.
HeaderCell parse_header_cell(std::string_view text);

}  // namespace pendular
