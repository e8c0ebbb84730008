#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace pendular {

/// Variant of a formula that is misprinted in Badetti et al. (2018): as derived from the
/// definitions in that paper, or as printed there.
enum class FormulaVariant { derived, as_printed };

/// Names of the formula variants in study.toml, on the command line and in JSON: "derived" (the
/// default) and "as_printed", in the order of the enumerators.
const std::vector<std::string>& formula_variant_names();
/// Name of a formula variant: "derived" or "as_printed".
const std::string& to_string(FormulaVariant form);

/// Returns the formula variant with the name "derived" or "as_printed".
/// @throws InputError for any other name; the message suggests the nearest name or lists both
FormulaVariant formula_variant_named(std::string_view name);

}  // namespace pendular
