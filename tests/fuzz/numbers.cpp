// Numbers in cells: whatever is read is finite, in every spelling.
#include <cmath>

#include "data/quantities/number.h"
#include "tests/fuzz/support.h"

using namespace pendular;

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string_view text = fuzz::text_of(data, size);
    if (const auto number = parse_number(text)) {
        fuzz::demand(std::isfinite(*number));
        short_text(*number);
        fuzz::demand(std::abs(*number) <= largest_magnitude || beyond_measure(*number));
    }
    has_decimal_comma(text);
    return 0;
}
