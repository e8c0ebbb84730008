#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace pendular {

/// Variant of a formula that Badetti et al. (2018) misprint: the derived or the printed one.
enum class FormulaVariant { derived, as_printed };

/// Names of the variants in studies, on the command line and in JSON, the default first.
const std::vector<std::string>& formula_variant_names();
const std::string& to_string(FormulaVariant form);

/// @throws InputError for any other word, with the nearest known one
FormulaVariant formula_variant_named(std::string_view name);

}  // namespace pendular
