#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace pendular {

/// Unit of measurement with its conversion of a value x to SI units: factor x + offset.
class Unit {
  public:
    /// Reads a unit in any common spelling: "mN m", "mNm", "N·m", "kPa", "1/s", "deg", "rpm", "%".
    /// "", "-" and "1" are dimensionless.
    /// @throws std::invalid_argument naming the text if it is no unit, or if its case makes it a
    ///         different unit from the likely one ("pa" would be a pico-are)
    explicit Unit(std::string_view spelling);

    /// Converts a value in this unit to SI units.
    double to_si(double value) const { return factor_ * value + offset_; }
    /// Whether two units have the same dimension, such as mN m and kgf cm. The radian counts as a
    /// dimension, so that an angle is never read as a stress ratio.
    bool same_dimension(const Unit& other) const { return dimension_ == other.dimension_; }
    /// Text that the unit was read from, without blanks around it.
    const std::string& spelling() const { return spelling_; }
    /// Product of SI base units with the same dimension, such as "kg m^2 s^-2"; empty if
    /// dimensionless.
    const std::string& dimension() const { return dimension_; }

  private:
    std::string spelling_;
    std::string dimension_;
    double factor_ = 1;
    double offset_ = 0;
};

/// Error message for a unit whose dimension is not the expected one, with a suggestion if grams
/// were written for gram-force:
///     'g cm' measures kg m, not kg m^2 s^-2 as 'N m' does; did you mean 'gf cm'?
std::string wrong_dimension(const Unit& unit, const Unit& expected);

/// Common spelling of the SI unit with the dimension of `unit`: "N m" for "mNm", "Pa" for "kPa",
/// "1" if dimensionless. A unit without a common SI spelling keeps its own spelling, without
/// prefixes: "N m s/rad" for "mN m s/rad".
std::string si_spelling(const Unit& unit);

/// Value in SI units of a text such as "500 um". The unit may be left out if the expected unit is
/// dimensionless.
/// @throws std::invalid_argument if the text is no number with a unit, or the unit has another
///         dimension than the expected unit; the message says what to write
double quantity_in_si(std::string_view text, const Unit& expected);

/// Values in SI units of a comma-separated list such as "0.3, 1, 3 kPa". A number without a unit
/// has the unit of the next number that has one.
/// @throws std::invalid_argument if an item is no number with a unit, or its unit has another
///         dimension than the expected unit; the message says what to write
std::vector<double> quantities_in_si(std::string_view list, const Unit& expected);

}  // namespace pendular
