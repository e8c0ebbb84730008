#include "reports/symbol_code.h"

#include <algorithm>
#include <cmath>

namespace pendular {

Shape shape_of(double friction) {
    return std::ranges::min(
               friction_code, {},
               [&](const FrictionCode& code) { return std::abs(code.friction - friction); })
        .shape;
}

const ContentCode& code_of(double liquid_content) {
    if (liquid_content <= 0) {
        return dry_code;
    }
    return *std::ranges::min_element(content_code, {}, [&](const ContentCode& code) {
        return std::abs(std::log(code.liquid_content / liquid_content));
    });
}

Symbol simulated_symbol(double friction, double liquid_content) {
    return {shape_of(friction), code_of(liquid_content).filling};
}

}  // namespace pendular
