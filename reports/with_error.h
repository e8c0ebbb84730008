#pragma once

#include <string>

namespace pendular {

/// Value with its standard error to two digits: "0.097 +- 0.011", "(1.032 +- 0.012)e-6".
std::string with_error(double value, double error);

/// Value with its error and unit, as people write it: "0.41 +- 0.03 mN m" for 4.1e-4 and "N m".
std::string with_error(double value, double error, const std::string& unit);

/// Value with two significant digits and its unit: "5.6 uN" for 5.6e-6 and "N", "0.12" for "1".
std::string with_unit(double value, const std::string& unit);

}  // namespace pendular
