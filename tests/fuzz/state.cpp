// States of runs: bytes that are restored are archived to the same bytes.
#include "sim/dem/archive.h"
#include "sim/dem/run_result.h"
#include "tests/fuzz/support.h"

using namespace pendular;

namespace {

template <typename State>
void restore_and_archive(std::string_view bytes) {
    State state;
    if (dem::restore(bytes, state)) fuzz::demand(dem::archived(state) == bytes);
}

}  // namespace

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string_view bytes = fuzz::text_of(data, size);
    restore_and_archive<dem::Trace>(bytes);
    restore_and_archive<dem::StoredSample>(bytes);
    return 0;
}
