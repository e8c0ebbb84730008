#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace pendular {

/// Unit of measurement. A value x in this unit is factor x + offset in SI units.
class Unit {
  public:
    /// Reads a unit in any common spelling: "mN m", "mNm", "N·m", "kPa", "1/s", "deg", "rpm", "%".
    /// The texts "", "-" and "1" mean dimensionless.
    /// @throws std::invalid_argument naming the text if it is no unit, or if its upper and lower
    ///         case letters make it an unlikely unit ("pa" would be a pico-are)
    explicit Unit(std::string_view spelling);

    /// Converts a value in this unit to SI units.
    double to_si(double value) const { return factor_ * value + offset_; }
    /// Whether two units have the same dimension, such as mN m and kgf cm. The radian counts as a
    /// dimension of its own, so that an angle is not accepted in place of a stress ratio.
    bool same_dimension(const Unit& other) const { return dimension_ == other.dimension_; }
    /// Text that the unit was read from, without blanks around it.
    const std::string& spelling() const { return spelling_; }
    /// Dimension of the unit as a product of SI base units, such as "kg m^2 s^-2"; empty if it is
    /// dimensionless.
    const std::string& dimension() const { return dimension_; }

  private:
    std::string spelling_;
    std::string dimension_;
    double factor_ = 1;
    double offset_ = 0;
};

/// Returns an error message for a unit whose dimension is not the expected one. If grams were
/// written for gram-force, the message suggests the unit that was meant:
///     'g cm' measures kg m, not kg m^2 s^-2 as 'N m' does; did you mean 'gf cm'?
std::string wrong_dimension(const Unit& unit, const Unit& expected);

/// Returns the common spelling of the SI unit with the dimension of `unit`: "N m" for "mNm", "Pa"
/// for "kPa", "1" if dimensionless. For a dimension without a common spelling, the prefixes of the
/// unit's own spelling are left out, "N m s/rad" for "mN m s/rad"; if this gives no SI unit, the
/// result is a product of SI base units.
std::string si_spelling(const Unit& unit);

/// Returns the value in SI units of a text such as "500 um". The text needs no unit if the expected
/// unit is dimensionless.
/// @throws std::invalid_argument if the text is no number with a unit, or its unit has another
///         dimension than `expected`; the message says what to write
double quantity_in_si(std::string_view text, const Unit& expected);

/// Returns the values in SI units, in the order of the text, of a comma-separated list such as
/// "0.3, 1, 3 kPa". A number without a unit has the unit of the next number that has one.
/// @throws std::invalid_argument if an item is no number with a unit, or its unit has another
///         dimension than `expected`; the message says what to write
std::vector<double> quantities_in_si(std::string_view list, const Unit& expected);

}  // namespace pendular
