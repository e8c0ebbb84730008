#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace pendular {

// Factors that a column is off by where its unit was taken for another. Every check that asks
// whether a column is in a wrong unit takes them from here; conversions of units that a file states
// are in units.h.

/// Two units whose numbers may be taken for one another.
struct UnitMixUp {
    std::string_view unit;       ///< in which the numbers are, such as "rpm"
    std::string_view taken_for;  ///< in which they were read, such as "rad/s"
    double factor;               ///< by which the column as read must be multiplied [1]

    /// Returns "numbers in rpm were read as rad/s".
    std::string meaning() const;
};

/// Returns the mix-ups of units of a recorded or stated quantity, such as "torque", each in both
/// directions if both occur; none for quantities of which only prefixes are mixed up.
std::span<const UnitMixUp> unit_mix_ups(std::string_view quantity);

/// Returns the mix-up of units by which a column of a quantity is off by a factor, to within a
/// relative tolerance; null if there is none.
const UnitMixUp* find_mix_up(std::string_view quantity, double factor, double tolerance);

/// Returns the exponent of the power of ten that equals a factor to within a relative tolerance, as
/// a wrong prefix or a lost decimal mark leaves it; 0 for a factor of 1, empty for any other.
/// @param factor its sign does not count
std::optional<int> power_of_ten(double factor, double tolerance);

}  // namespace pendular
