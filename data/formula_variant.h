#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace pendular {

/// Which form of a formula that the source misprints: the derived one or the printed one.
enum class FormulaVariant { derived, as_printed };

/// How forms are written in studies, on the command line and in JSON, the default first.
const std::vector<std::string>& formula_variant_names();
const std::string& to_string(FormulaVariant form);

/// @throws InputError for any other word, with the nearest known one
FormulaVariant formula_variant_named(std::string_view name);

}  // namespace pendular
