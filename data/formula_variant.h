#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace pendular {

/// Variant of a formula that is misprinted in Badetti et al. (2018). The variant `derived` follows
/// from the definitions in the paper. The variant `as_printed` is the formula as the paper prints
/// it.
enum class FormulaVariant { derived, as_printed };

/// Returns the names of the formula variants, which study.toml, the command line and JSON use:
/// first "derived" (the default), second "as_printed".
const std::vector<std::string>& formula_variant_names();
/// Returns the name of a formula variant: "derived" or "as_printed".
const std::string& to_string(FormulaVariant form);

/// Returns the formula variant with the name "derived" or "as_printed".
/// @throws InputError for every other name. The message suggests the name that was probably meant,
///         or lists both names.
FormulaVariant formula_variant_named(std::string_view name);

}  // namespace pendular
