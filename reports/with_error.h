#pragma once

#include <string>

namespace pendular {

/// Text of a value with its standard error to two digits: "0.097 +- 0.011", "(1.032 +- 0.012)e-6".
std::string with_error(double value, double error);

/// Text of a value with its standard error and its unit with an SI prefix: "0.41 +- 0.03 mN m" for
/// 4.1e-4, 3e-5 and "N m". The unit "1" is left out.
std::string with_error(double value, double error, const std::string& unit);

/// Text of a value with two significant digits and its unit with an SI prefix: "5.6 uN" for 5.6e-6
/// and "N", "0.12" for 0.12 and "1".
std::string with_unit(double value, const std::string& unit);

}  // namespace pendular
