#pragma once

#include <span>
#include <string_view>
#include <vector>

namespace pendular {

/// Quantity that the program reads, computes or displays, such as a shear stress.
struct Quantity {
    std::string_view name;    ///< also the JSON key and CSV header
    std::string_view symbol;  ///< in labels of axes, such as "σ22"
    /// SI unit, but "turn/s" for the rotational speed; "1": dimensionless; "": a text.
    std::string_view unit;
    std::string_view meaning;                 ///< explanation in one line, for the manual
    std::vector<std::string_view> also = {};  ///< further names in headers of tables
};

/// Returns all quantities, each once.
std::span<const Quantity> quantities();

/// Returns the quantity with a given `Quantity::name`. Aborts if there is none, which is a
/// programming error.
const Quantity& quantity(std::string_view name);

/// Returns the quantity that has a given name in the header of a table; null if unknown. Blanks,
/// '_', '-' and '.' are ignored, and so is the case of names of more than one letter: "Normal
/// force", "F_N" and "normalForce" name one quantity.
const Quantity* find_quantity(std::string_view spelling);

}  // namespace pendular
