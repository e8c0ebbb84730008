#pragma once

#include <string>
#include <vector>

#include "analysis/reproduction/paper_states.h"

namespace pendular {

/// A number or range that Badetti et al. (2018) state, with what the simulations give.
struct ScoreboardRow {
    std::string section;    ///< heading under which the row stands
    std::string what;       ///< quantity and condition, with its unit
    std::string published;  ///< published value or range, as text
    std::string ours;       ///< value with its standard error, or range of the values, as text
    double lower = 0, upper = 0;     ///< published range; of a value, the value -+ its error
    double least = 0, greatest = 0;  ///< smallest and largest of our values
    /// Distance of our most distant value from the published range, in combined standard errors
    /// [1]; 0 inside the range.
    double distance = 0;
    int values = 0;      ///< number of our values
    int outside = 0;     ///< number of our values that are further outside than allowed
    std::string where;   ///< states of the values outside, as text; empty: none
    bool agrees = true;  ///< whether `distance` is at most `allowed_distance`
};

/// Largest distance of a value that agrees from a published value or range, in combined standard
/// errors [1]. With about 300 values beside ranges, one in 370 is further off by chance.
inline constexpr double allowed_distance = 3;

/// Compares the simulations of the parameter study with each number that Badetti et al. (2018)
/// state of dry and wet grains. A published number without an error is taken to half a unit of its
/// last digit, or to 10 % where the text says "about" with one digit. Rows whose states no run
/// simulates are left out.
std::vector<ScoreboardRow> scoreboard(const PaperStudy& study);

}  // namespace pendular
