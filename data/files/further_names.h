#pragma once

#include <string_view>
#include <vector>

namespace pendular {

/// Names of a quantity in the headers of files.
struct FurtherNames {
    std::string_view quantity;
    std::vector<std::string_view> names;
};

/// Returns the names of what steady shear needs in Polish, Czech, Dutch, Swedish, Danish,
/// Portuguese, Turkish, Hungarian and Finnish, as far as they differ from those in English, French,
/// German, Spanish and Italian (column_names.cpp). Left out is Turkish "Aralık", which is both a
/// gap and an interval.
const std::vector<FurtherNames>& further_names();

}  // namespace pendular
