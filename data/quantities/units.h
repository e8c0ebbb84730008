#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace pendular {

/// Unit of measurement. A value x in the unit equals factor x + offset in SI units. Thread-safe:
/// calls of UDUNITS-2 are serialized.
class Unit {
  public:
    /// Makes a unit from any common spelling, such as "mN m", "mNm", "N·m", "kPa", "10³ Pa", "1/s",
    /// "deg", "rpm" or "%". The texts "", "-" and "1" mean dimensionless.
    /// @throws std::invalid_argument if the text is no unit, if wrong upper or lower case makes it
    ///         an unlikely unit ("pa" would be a pico-are), or for a factor that may be another
    ///         power of ten ("103 Pa"). The message quotes the text.
    /// @throws std::runtime_error if the unit database of UDUNITS-2 is not installed
    explicit Unit(std::string_view spelling);

    double to_si(double value) const { return factor_ * value + offset_; }
    /// Whether two units have equal dimensions, such as mN m and kgf cm. The radian counts as a
    /// dimension, so that an angle is not accepted in place of a stress ratio.
    bool same_dimension(const Unit& other) const { return dimension_ == other.dimension_; }
    /// Returns the text from which the unit was made, without blanks around it.
    const std::string& spelling() const { return spelling_; }
    /// Returns the dimension as a product of SI base units, such as "kg m^2 s^-2"; empty:
    /// dimensionless.
    const std::string& dimension() const { return dimension_; }

  private:
    /// Takes dimension, factor and offset from a text of UDUNITS; whether it is one.
    bool read(const std::string& text);

    std::string spelling_;
    std::string dimension_;
    double factor_ = 1;
    double offset_ = 0;
};

/// Returns an error message for a unit whose dimension differs from that of `expected`. If grams
/// were probably written for gram-force, the message suggests the unit of force:
///     'g cm' measures kg m, not kg m^2 s^-2 as 'N m' does; did you mean 'gf cm'?
std::string wrong_dimension(const Unit& unit, const Unit& expected);

/// Returns a spelling with units of force in place of those of mass, "in lbf" for "inlb", as people
/// mean it where a force is wanted; empty if that is no unit, or has no word for a mass.
std::string weight_meant(std::string_view spelling);

/// Returns an error message for a number, as the user wrote it, that lacks its unit:
///     has no unit; write "500 m", "500 mm" or another unit of the same kind
std::string missing_unit(std::string_view number, const Unit& expected);

/// Returns the SI unit with the dimension of `unit`, such as "Pa" for "kPa", or "1" if
/// dimensionless. A dimension without a common spelling gets the spelling of `unit` without
/// prefixes, "N m s/rad" for "mN m s/rad", or a product of SI base units if that is no SI unit.
std::string si_spelling(const Unit& unit);

/// Returns the value in SI units of a text such as "500 um", or "0.3" if `expected` is
/// dimensionless.
/// @throws std::invalid_argument, with advice, if the text is no number with a unit, or if its unit
///         and `expected` differ in dimension
double quantity_in_si(std::string_view text, const Unit& expected);

/// Returns the values in SI units of a comma-separated list such as "0.3, 1, 3 kPa", in the order
/// of the list. A number without a unit has the unit of the next number that has a unit.
/// @throws std::invalid_argument as `quantity_in_si`
std::vector<double> quantities_in_si(std::string_view list, const Unit& expected);

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
