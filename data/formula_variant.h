#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace pendular {

/// Variant of a formula that Badetti et al. (2018) misprint: as derived from their definitions, or
/// as they print it.
enum class FormulaVariant { derived, as_printed };

/// Names of all formula variants in study.toml, on the command line and in JSON, in the order of
/// the enumerators: "derived" (the default) and "as_printed".
const std::vector<std::string>& formula_variant_names();
/// Name of a formula variant: "derived" or "as_printed".
const std::string& to_string(FormulaVariant form);

/// Formula variant with this name, "derived" or "as_printed".
/// @throws InputError if no variant has the name; the message suggests the nearest name or lists
///         all
FormulaVariant formula_variant_named(std::string_view name);

}  // namespace pendular
