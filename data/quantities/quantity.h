#pragma once

#include <span>
#include <string_view>
#include <vector>

namespace pendular {

/// Quantity that the program reads, computes or displays, such as a shear stress. The name, symbol,
/// unit and meaning of the quantity appear in JSON keys, CSV headers, axis labels and the manual.
struct Quantity {
    std::string_view name;    ///< name of the quantity, which is also the JSON key and CSV header
    std::string_view symbol;  ///< symbol of the quantity in labels of axes, such as "σ22"
    /// SI unit of the quantity; "turn/s" for the rotational speed. The unit is "1" if the quantity
    /// is dimensionless, and "" if the quantity is a text.
    std::string_view unit;
    std::string_view meaning;  ///< explanation of the quantity in one line
    /// Further names of the quantity that are accepted in headers of tables.
    std::vector<std::string_view> also = {};
};

/// Returns all quantities that the program reads, computes or displays, each once.
std::span<const Quantity> quantities();

/// Returns the quantity with a given `Quantity::name`, such as "shear_stress". The program aborts
/// if no quantity has the name, which is a programming error.
const Quantity& quantity(std::string_view name);

/// Returns the quantity that has a given name in the header of a table, or null if the name is
/// unknown. Blanks, '_', '-' and '.' are ignored, and so is the case of names of more than one
/// letter: "Normal force", "F_N" and "normalForce" name one quantity.
const Quantity* find_quantity(std::string_view spelling);

}  // namespace pendular
