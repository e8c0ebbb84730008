// Campaign files.
#include "sim/runs/campaign.h"
#include "tests/fuzz/support.h"

using namespace pendular;

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string_view text = fuzz::text_of(data, size);
    // Numbers of many digits ask for up to a million runs, which takes seconds and is meant to.
    std::size_t digits = 0;
    for (const char c : text) {
        digits = c >= '0' && c <= '9' ? digits + 1 : 0;
        if (digits > 3) return -1;
    }
    fuzz::refuse_or(
        [&] { read_campaign(fuzz::file_of("campaign.toml", text), fidelity_named("quick")); });
    return 0;
}
