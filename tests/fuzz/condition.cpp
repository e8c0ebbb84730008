// Conditions of --where: they change nothing.
#include "sim/runs/store/run_store.h"
#include "tests/fuzz/support.h"

using namespace pendular;

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    static RunStore& store = []() -> RunStore& {
        static RunStore made(RunStore::in_memory);
        for (const double friction : {0.1, 0.2, 0.3}) {
            dem::RunResult run;
            run.parameters.friction = friction;
            made.add(run);
        }
        return made;
    }();
    fuzz::refuse_or([&] { store.select(std::string(fuzz::text_of(data, size))); });
    fuzz::demand(store.size() == 3);
    return 0;
}
