#pragma once

#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "data/files/formats/block_file.h"

namespace pendular {

/// Why a number in the header of a file may be meant otherwise.
enum class StatedDoubt {
    none,
    other_mark,  ///< its mark may separate decimals or thousands: "1,250 µm"
    range,       ///< the middle of a range: "0.4-0.6 mm"
    name         ///< its name may be that of another quantity: "d", "Density (dry)"
};

/// Number in the header of a file.
struct StatedValue {
    double value = 0;  ///< in SI units
    int line = 0;      ///< from 1
    std::string key;   ///< as in the file, such as "Inner radius"
    std::string text;  ///< number and unit as in the file, such as "21 mm"
    StatedDoubt doubt = StatedDoubt::none;
};

/// Statement of one line above a table, taken apart.
struct StatedFact {
    std::string name;  ///< `folded_name`, without a unit
    std::string unit;  ///< in brackets behind the name, as in "Radius (mm);20"; empty: none
    std::string key;   ///< as in the file
    std::string text;  ///< number and unit as in the file, or words
    int line = 0;      ///< from 1
    /// In brackets behind the name, and no unit, as in "Density (loose): 1.45 g/cm³".
    std::string remark = {};
    std::string whole = {};  ///< text of the line, from which the fact may be a part
};

/// Facts above the table of a file. "Inner diameter / outer diameter: 40 / 80 mm" is two, and so is
/// "r_i 20 mm" behind "Cell:", or alone in a line.
std::vector<StatedFact> stated_facts(const BlockFile& file);

/// Words of a text in small letters, without the marks between them.
std::vector<std::string> lower_case_words(std::string_view text);

/// Values in SI units that a quantity may have.
struct PossibleValues {
    double least = 0, most = std::numeric_limits<double>::infinity();
};

/// Value of a fact in SI units; empty if it is no positive number with a unit of this dimension, or
/// has no possible value. Where a mark may separate decimals or thousands, the reading is the
/// possible one, and in doubt if both are possible and the file itself does not write so.
std::optional<StatedValue> positive_value(const StatedFact& fact, const char* unit,
                                          const PossibleValues& possible, const NumberStyle& style);

}  // namespace pendular
