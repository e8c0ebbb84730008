#pragma once

#include <span>
#include <string_view>
#include <vector>

namespace pendular {

/// Quantity that the program reads, computes or shows. The name, symbol, unit and meaning are used
/// in JSON keys, CSV headers, axis labels and the manual.
struct Quantity {
    std::string_view name;                    ///< JSON key and CSV header
    std::string_view symbol;                  ///< symbol in labels of axes, such as "σ22"
    std::string_view unit;                    ///< SI unit; "1": dimensionless; "": a text
    std::string_view meaning;                 ///< explanation in one line
    std::vector<std::string_view> also = {};  ///< other accepted names in headers of tables
};

/// All quantities that the program reads, computes or shows; each name occurs once.
std::span<const Quantity> quantities();

/// Quantity whose `Quantity::name` is `name`. Aborts the program if there is none, since names are
/// written in its source code.
const Quantity& quantity(std::string_view name);

/// Quantity that a header cell of a table names, regardless of case and separators: "Normal force",
/// "F_N" and "normalForce" are one quantity. Null if the name is unknown.
const Quantity* find_quantity(std::string_view spelling);

}  // namespace pendular
