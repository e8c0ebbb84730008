#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace pendular {

/// Unit with its conversion to SI units: si = factor x + offset.
class Unit {
  public:
    /// Reads a unit in any common spelling: "mN m", "mNm", "N·m", "kPa", "1/s", "deg", "rpm", "%".
    /// "", "-" and "1" are dimensionless.
    /// @throws std::invalid_argument naming the unit when it is not one, or when its case makes it
    ///         another one ("pa" would be a pico-are)
    explicit Unit(std::string_view spelling);

    /// Value in SI units.
    double to_si(double value) const { return factor_ * value + offset_; }
    /// Whether two units have the same dimension, such as mN m and kgf cm. "1" is dimensionless;
    /// the radian counts as a dimension, so that degrees are not taken for a stress ratio.
    bool same_dimension(const Unit& other) const { return dimension_ == other.dimension_; }
    const std::string& spelling() const { return spelling_; }
    /// Formula in SI base units, such as "kg m^2 s^-2"; empty if dimensionless.
    const std::string& dimension() const { return dimension_; }

  private:
    std::string spelling_;
    std::string dimension_;
    double factor_ = 1;
    double offset_ = 0;
};

/// Why a unit cannot measure what `expected` measures, and what may have been meant:
/// "'g cm' measures kg m, not kg m^2 s^-2 as 'N m' does; did you mean 'gf cm'?"
std::string wrong_dimension(const Unit& unit, const Unit& expected);

/// SI unit of the same dimension, in its common spelling: "N m" for "mNm", "1/s" for "rpm".
std::string si_spelling(const Unit& unit);

/// Value in SI units of a number with its unit, such as "500 um", that measures what `expected`
/// does. The unit may be left out where `expected` is dimensionless.
/// @throws std::invalid_argument saying what is wrong and what to do
double quantity_in_si(std::string_view text, const Unit& expected);

/// Values in SI units of a list such as "0.3, 1, 3 kPa": a number without a unit has that of the
/// next one that has any.
/// @throws std::invalid_argument saying what is wrong and what to do
std::vector<double> quantities_in_si(std::string_view list, const Unit& expected);

}  // namespace pendular
