// Formulas of a study's own effects, and their values for numbers of any size.
#include <array>
#include <limits>

#include "sim/catalogue/formula.h"
#include "tests/fuzz/support.h"

using namespace pendular;

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    try {
        const CompiledFormula formula(std::string(fuzz::text_of(data, size)),
                                      {"torque", "normal_force", "a"});
        for (const double x : {0.0, 1.0, -1e300, std::numeric_limits<double>::quiet_NaN()}) {
            formula(std::array{x, x, x});
        }
    } catch (const FormulaError&) {
    }
    return 0;
}
