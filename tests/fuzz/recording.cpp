// Recordings: a table of a rheometer, and its steps.
#include "data/recordings/recording.h"
#include "data/recordings/steps.h"

#include "tests/fuzz/support.h"

using namespace pendular;

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    fuzz::refuse_or([&] {
        const auto file = fuzz::file_of("recording.csv", fuzz::ascii_of(data, size));
        const auto quick = quick_recording(file, {});
        const Recording recording = read_recording(file);
        fuzz::demand(!quick || (quick->line == recording.line && quick->time == recording.time &&
                                quick->torque == recording.torque));
        for (const Step& step : split_steps(recording)) {
            fuzz::demand(step.begin <= step.end && step.end <= recording.size());
        }
    });
    return 0;
}
