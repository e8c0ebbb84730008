#pragma once

#include <string>
#include <string_view>

namespace pendular {

/// Name and unit in a cell of the header of a table, such as "Torque_sd [mN m]".
struct HeaderCell {
    /// Name in the header cell, such as "Torque", without a mark of standard deviations such as
    /// "_sd".
    std::string name;
    std::string unit;  ///< unit in the header cell, such as "mN m"; empty if the cell gives none
    /// Whether the column under the header cell contains standard deviations.
    bool deviation = false;
};

/// Splits a cell in the header of a table into name and unit. The cell reads `name [unit]`, `name
/// (unit)`, `name in unit` or `name`.
HeaderCell parse_header_cell(std::string_view text);

}  // namespace pendular
