#pragma once

#include <string>
#include <string_view>

namespace pendular {

/// Parts of a header cell such as "Torque_sd [mN m]".
struct HeaderCell {
    std::string name;        ///< without a mark of standard deviations: "Torque"
    std::string unit;        ///< "mN m"; empty if the cell gives none
    bool deviation = false;  ///< whether there is a mark of standard deviations, such as "_sd"
};

/// Splits a header cell, which reads `name [unit]`, `name (unit)`, `name in unit` or `name`.
HeaderCell parse_header_cell(std::string_view text);

}  // namespace pendular
