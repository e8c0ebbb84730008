#pragma once

#include <string>

#include "calib/fit/fit.h"

namespace pendular {

/// Returns the number of decimals that show the second significant digit of a standard error, at
/// least 0: 3 for 0.012.
int decimals_for(double standard_error);

/// Returns value and standard error, both rounded to the second significant digit of the error:
/// "0.097 +- 0.011", "4300 +- 120", "(1.032 +- 0.012)e-6".
std::string with_error(double value, double error);

/// Returns value, standard error and unit. Lengths, forces, torques, pressures, surface tensions
/// and viscosities have an SI prefix; angles are in degrees: "0.410 +- 0.030 mN m".
/// @param unit SI unit of value and error; "1" is left out of the text
std::string with_error(double value, double error, const std::string& unit);

/// Returns a fitted parameter with its standard error and unit. An error larger than the range of
/// the parameter says nothing: "0.1563, not determined". Beside a value at the end of the range, it
/// holds on one side only: "0.600 +- 0.091 (at bound)".
/// @param width width of the range within which the parameter was fitted, in its unit
std::string estimate_text(double value, double error, const std::string& unit, double width,
                          bool at_bound);
/// Returns the fitted parameter `k` of a fit in the same way.
std::string estimate_text(const Fit& fit, Eigen::Index k, const std::string& unit);

/// Returns a change with sign and unit, such as "-0.0145", rounded to the second significant digit
/// of the standard error of the value and with the SI prefix that `with_error` gives to the value.
/// @param unit SI unit of change, value and error
std::string change_text(double change, double value, double error, const std::string& unit);

/// Returns a value with `digits` significant digits and unit, with an SI prefix if `with_error`
/// would use one: "5.6 uN" for 5.6e-6 and "N", "0.12" for 0.12 and "1".
/// @param unit SI unit of the value
std::string with_unit(double value, const std::string& unit, int digits = 2);

}  // namespace pendular
