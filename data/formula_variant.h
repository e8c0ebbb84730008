#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace pendular {

/// Variant of a formula that Badetti et al. (2018) misprint: as derived from their definitions, or
/// as they print it.
enum class FormulaVariant { derived, as_printed };

/// Names of all variants in study.toml, on the command line and in JSON; the default is first.
const std::vector<std::string>& formula_variant_names();
/// Name of a variant, as in `formula_variant_names`.
const std::string& to_string(FormulaVariant form);

/// Variant with this name.
/// @throws InputError if no variant has the name, suggesting the nearest name
FormulaVariant formula_variant_named(std::string_view name);

}  // namespace pendular
