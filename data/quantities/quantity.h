#pragma once

#include <span>
#include <string_view>
#include <vector>

namespace pendular {

/// Quantity that the program reads, computes or shows. JSON keys, CSV headers, axis labels and the
/// manual use its name, symbol, unit and meaning.
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

/// Quantity that a table's header names, regardless of case and separators: "Normal force", "F_N",
/// "normalForce"; null if none.
const Quantity* find_quantity(std::string_view spelling);

}  // namespace pendular
