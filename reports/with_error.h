#pragma once

#include <string>

namespace pendular {

/// Number of decimals that show the second significant digit of a standard error: 3 for 0.012; at
/// least 0.
int decimals_for(double standard_error);

/// Returns a value with its standard error as text, both rounded to the second significant digit of
/// the error, or to whole numbers if that digit is coarser: "0.097 +- 0.011", "(1.032 +-
/// 0.012)e-6".
std::string with_error(double value, double error);

/// Returns a value with its standard error and unit as text, with an SI prefix for lengths, forces,
/// torques, pressures, surface tensions and viscosities, and in degrees for angles: "0.410 +- 0.030
/// mN m" for 4.1e-4, 3e-5 and "N m".
/// @param unit SI unit of value and error; the unit "1" is left out of the text
std::string with_error(double value, double error, const std::string& unit);

/// Returns a change of a value as text with its sign and unit, rounded to the second significant
/// digit of the value's standard error: "-0.0145". The SI prefix is the one that `with_error` gives
/// to the value and its error.
/// @param unit SI unit of the change, the value and the error
std::string change_text(double change, double value, double error, const std::string& unit);

/// Text of a value with two (or `digits`) significant digits and its unit, with an SI prefix as in
/// `with_error`: "5.6 uN" for 5.6e-6 and "N", "0.12" for 0.12 and "1". `unit`: SI unit of the
/// value.
std::string with_unit(double value, const std::string& unit, int digits = 2);

}  // namespace pendular
