#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace pendular {

/// Unit of measurement, which converts values to SI units. A value x in the unit equals factor x +
/// offset in SI units.
class Unit {
  public:
    /// Makes a unit from any common spelling, such as "mN m", "mNm", "N·m", "kPa", "1/s", "deg",
    /// "rpm" or "%". The texts "", "-" and "1" mean dimensionless.
    /// @throws std::invalid_argument if the text is no unit, or if wrong upper or lower case makes
    ///         it an unlikely unit ("pa" would be a pico-are). The message quotes the text.
    /// @throws std::runtime_error if the unit database of UDUNITS-2 is not installed
    explicit Unit(std::string_view spelling);

    /// Converts a value in the unit to the value in SI units.
    double to_si(double value) const { return factor_ * value + offset_; }
    /// Whether two units have equal dimensions, such as mN m and kgf cm. The radian counts as a
    /// dimension of its own, so that an angle is not accepted in place of a stress ratio.
    bool same_dimension(const Unit& other) const { return dimension_ == other.dimension_; }
    /// Returns the text from which the unit was made, without blanks at the beginning and end.
    const std::string& spelling() const { return spelling_; }
    /// Returns the dimension of the unit as a product of SI base units, such as "kg m^2 s^-2". The
    /// text is empty if the unit is dimensionless.
    const std::string& dimension() const { return dimension_; }

  private:
    std::string spelling_;
    std::string dimension_;
    double factor_ = 1;
    double offset_ = 0;
};

/// Returns an error message for a unit whose dimension differs from the dimension of `expected`. If
/// grams or kilograms were probably written for gram-force or kilogram-force, the message suggests
/// the unit of force:
///     'g cm' measures kg m, not kg m^2 s^-2 as 'N m' does; did you mean 'gf cm'?
std::string wrong_dimension(const Unit& unit, const Unit& expected);

/// Returns an error message for a number that lacks its unit, with examples of what to write:
///     has no unit; write "500 m", "500 mm" or another unit of the same kind
/// @param number number as the user wrote it
std::string missing_unit(std::string_view number, const Unit& expected);

/// Returns the common spelling of the SI unit with the dimension of `unit`, such as "Pa" for "kPa".
/// The result is "1" if `unit` is dimensionless. If the dimension has no common spelling, the
/// result is the spelling of `unit` without prefixes: "N m s/rad" for "mN m s/rad". If `unit`
/// without prefixes is no SI unit, the result is a product of SI base units.
std::string si_spelling(const Unit& unit);

/// Returns the value in SI units of a text such as "500 um". The text needs no unit if the expected
/// unit is dimensionless.
/// @throws std::invalid_argument if the text is no number with a unit, or if its unit and
///         `expected` differ in dimension. The message says what to write.
double quantity_in_si(std::string_view text, const Unit& expected);

/// Returns the values in SI units of a comma-separated list such as "0.3, 1, 3 kPa", in the order
/// of the list. A number without a unit has the unit of the next number that has a unit.
/// @throws std::invalid_argument if an item is no number with a unit, or if its unit and `expected`
///         differ in dimension. The message says what to write.
std::vector<double> quantities_in_si(std::string_view list, const Unit& expected);

}  // namespace pendular
