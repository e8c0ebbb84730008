#pragma once

#include <span>
#include <string_view>
#include <vector>

namespace pendular {

/// Physical quantity that the program reads, computes or displays. Its name, symbol, unit and
/// meaning appear in JSON keys, CSV headers, axis labels and the manual.
struct Quantity {
    std::string_view name;    ///< name of the quantity, its JSON key and CSV header
    std::string_view symbol;  ///< symbol of the quantity in labels of axes, such as "σ22"
    /// SI unit of the quantity; "1": dimensionless; "": the quantity is a text.
    std::string_view unit;
    std::string_view meaning;  ///< explanation of the quantity in one line
    /// Other accepted names of the quantity in headers of tables.
    std::vector<std::string_view> also = {};
};

/// All physical quantities that the program reads, computes or displays; each name occurs once.
std::span<const Quantity> quantities();

/// Returns the quantity with a given `Quantity::name`. The program aborts if no quantity has this
/// name: names are constants of the program, so that a wrong one is a programming error.
const Quantity& quantity(std::string_view name);

/// Returns the quantity that a header cell of a table names, or null if the name is unknown. Case
/// and separators are ignored: "Normal force", "F_N" and "normalForce" are one quantity.
const Quantity* find_quantity(std::string_view spelling);

}  // namespace pendular
