// Tables of runs, as the atlas and exported runs are.
#include "sim/runs/store/run_table.h"
#include "tests/fuzz/support.h"

using namespace pendular;

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    fuzz::refuse_or([&] {
        for (const StoredRun& run :
             read_runs(fuzz::file_of("runs.csv", fuzz::ascii_of(data, size)))) {
            run_fingerprint(run);
        }
    });
    return 0;
}
