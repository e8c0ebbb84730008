#pragma once

#include <span>
#include <string_view>
#include <vector>

namespace pendular {

/// A number this program reads, computes or shows. JSON keys, CSV headers, axis labels and manual
/// all take their words from here.
struct Quantity {
    std::string_view name;                    ///< JSON key and CSV header
    std::string_view symbol;                  ///< on axes
    std::string_view unit;                    ///< SI; "1": dimensionless
    std::string_view meaning;                 ///< one line
    std::vector<std::string_view> also = {};  ///< other names in the headers of tables
};

/// All quantities, each name once.
std::span<const Quantity> quantities();

/// The quantity of that name; aborts if there is none, since names in the program are constants.
const Quantity& quantity(std::string_view name);

/// The quantity a table's header calls so, whatever case and separators: "Normal force", "F_N",
/// "normalForce"; null if none.
const Quantity* find_quantity(std::string_view spelling);

}  // namespace pendular
