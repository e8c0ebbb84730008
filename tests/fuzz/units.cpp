// Units and quantities with a unit: a unit has a finite factor.
#include <cmath>
#include <stdexcept>

#include "data/quantities/units.h"
#include "tests/fuzz/support.h"

using namespace pendular;

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string_view text = fuzz::text_of(data, size);
    static const Unit metre("m"), torque("N m");
    try {
        const Unit unit(text);
        fuzz::demand(std::isfinite(unit.to_si(1)) && std::isfinite(unit.to_si(0)));
        if (!unit.same_dimension(torque)) wrong_dimension(unit, torque);
    } catch (const std::invalid_argument&) {
    }
    try {
        quantities_in_si(text, metre);
    } catch (const std::invalid_argument&) {
    }
    return 0;
}
