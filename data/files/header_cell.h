#pragma once

#include <string>
#include <string_view>

namespace pendular {

/// Content of a header cell such as "Torque_sd [mN m]": name and unit.
struct HeaderCell {
    std::string name;        ///< "Torque", without the mark of a standard deviation
    std::string unit;        ///< "mN m"; empty if none is given
    bool deviation = false;  ///< whether the column holds standard deviations
};

/// Takes apart `name [unit]`, `name (unit)`, `name in unit` or a bare `name`.
HeaderCell parse_header_cell(std::string_view text);

}  // namespace pendular
