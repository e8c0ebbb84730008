// Text for the terminal has no control characters, whatever it was.
#include "data/files/text_file.h"
#include "tests/fuzz/support.h"

using namespace pendular;

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string shown = printable(fuzz::text_of(data, size));
    for (std::size_t k = 0; k < shown.size(); ++k) {
        const auto c = static_cast<unsigned char>(shown[k]);
        fuzz::demand(c >= 0x20 || c == '\n' || c == '\t');
        fuzz::demand(c != 0x7f);
        const bool eight_bit_control =
            c == 0xc2 && k + 1 < shown.size() && static_cast<unsigned char>(shown[k + 1]) < 0xa0;
        fuzz::demand(!eight_bit_control);
    }
    fuzz::demand(printable(shown) == shown);
    return 0;
}
