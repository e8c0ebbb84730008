#pragma once

#include <string>
#include <string_view>

namespace pendular {

/// Returns a unit as UDUNITS reads it: "mN.m" for "mNm", "10^3 Pa" for "10³ Pa", "turn/min" for
/// "U/min", "1" for none.
/// @throws std::invalid_argument if upper and lower case make it another unit than the likely one
///         ("MNm"), or if its factor may be one of the numbers ("Pa × 1000") or another power of
///         ten ("103 Pa")
std::string spelling_of_udunits(std::string_view spelling);

/// Returns a spelling with weights in place of masses, "in lbf" for "in lb"; empty if it has no
/// word for a mass.
std::string with_weights(std::string_view spelling);

/// Texts of a number and of the unit after it, without blanks around them.
struct NumberAndUnit {
    std::string_view number, unit;
};

NumberAndUnit split_quantity(std::string_view text);

}  // namespace pendular
