// Recordings: a table of a rheometer, and its steps.
#include "data/recordings/recording.h"
#include "tests/fuzz/support.h"

using namespace pendular;

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    fuzz::refuse_or([&] {
        const Recording recording =
            read_recording(fuzz::file_of("recording.csv", fuzz::text_of(data, size)));
        for (const Step& step : split_steps(recording)) {
            fuzz::demand(step.begin <= step.end && step.end <= recording.size());
        }
    });
    return 0;
}
