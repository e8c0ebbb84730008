#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "data/files/formats/number_style.h"

namespace pendular {

/// Number in a text of a person, who may use another decimal mark than the instrument does below.
struct StatedNumber {
    /// One for each way to read the number: "2,650" is 2650 or 2.65. That of the style of the file
    /// comes first.
    std::vector<double> readings;
    /// Whether the file writes numbers so, and readings but the first are unusual.
    bool in_style = true;
    bool range = false;  ///< whether the readings are middles of a range such as "0.4-0.6 mm"
    std::string unit;    ///< behind the number, or before it as in "mm 15"; empty: none
};

/// Regular expression, one pair of parentheses, for a number with digits, marks, and blanks or
/// apostrophes that separate groups of three digits.
const std::string& number_expression();

/// Returns the number that a text consists of, with its unit; empty for a text with two numbers,
/// which UDUNITS would multiply: it reads "2 650 kg" as 1300 kg. A text with a standard error
/// behind "±" has one number.
std::optional<StatedNumber> stated_number(std::string_view text, const NumberStyle& style);

}  // namespace pendular
