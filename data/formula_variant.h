#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace pendular {

/// Variant of a formula that is misprinted in Badetti et al. (2018): `derived` follows from the
/// definitions in the paper, `as_printed` is the formula as the paper prints it.
enum class FormulaVariant { derived, as_printed };

/// Returns the names used in study.toml, on the command line and in JSON, in the order of the enum.
const std::vector<std::string>& formula_variant_names();
const std::string& to_string(FormulaVariant form);

/// Returns the formula variant with a given name.
/// @throws InputError for an unknown name, with a suggestion
FormulaVariant formula_variant_named(std::string_view name);

}  // namespace pendular
