#include "data/formula_variant.h"

#include <fmt/format.h>

#include <algorithm>

#include "data/input_error.h"

namespace pendular {

const std::vector<std::string>& formula_variant_names() {
    static const std::vector<std::string> names = {"derived", "as_printed"};
    return names;
}

const std::string& to_string(FormulaVariant form) {
    return formula_variant_names()[static_cast<std::size_t>(form)];
}

FormulaVariant formula_variant_named(std::string_view name) {
    const auto found = std::ranges::find(formula_variant_names(), name);
    if (found == formula_variant_names().end()) {
        throw InputError(fmt::format("unknown variant '{}' of a formula; {}", name,
                                     did_you_mean(name, formula_variant_names())));
    }
    return static_cast<FormulaVariant>(found - formula_variant_names().begin());
}

}  // namespace pendular
