// Tables of the emulator's hyperparameters.
#include "calib/emulator/known_runs.h"
#include "tests/fuzz/support.h"

using namespace pendular;

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    fuzz::refuse_or(
        [&] { read_hyperparameters(fuzz::file_of("emulator.csv", fuzz::text_of(data, size))); });
    return 0;
}
