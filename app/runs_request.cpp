#include "app/runs_request.h"

#include <fmt/format.h>

#include "app/stored_runs.h"
#include "data/input_error.h"
#include "sim/runs/store/run_table.h"

namespace pendular::app {

std::unique_ptr<RunStore> RunsRequest::source() const {
    if (!atlas) return std::make_unique<RunStore>(common.store, true);
    const auto file = atlas_file();
    if (file.empty()) {
        throw InputError("there is no atlas; name one in PENDULAR_ATLAS");
    }
    auto store = std::make_unique<RunStore>(RunStore::in_memory);
    for (const StoredRun& run : read_runs(file)) {
        store->add(run.run, run.physics_version);
    }
    return store;
}

void RunsRequest::refuse_atlas(const std::string& action) const {
    if (!atlas) return;
    throw InputError(
        fmt::format("--atlas works with list, show, compare, plot, export and learn; '{}' changes "
                    "the store and never the atlas: leave out --atlas",
                    action));
}

void RunsRequest::demand_words(std::size_t least, const std::string& what) const {
    if (words.size() < least) {
        throw InputError("name " + what);
    }
}

StoredRun numbered_run(const RunStore& store, const std::string& word) {
    const std::int64_t id = run_number(word);
    const bool of_atlas = store.file() == RunStore::in_memory;
    if (of_atlas && store.numbers(fmt::format("id = {}", id)).empty()) {
        throw InputError(fmt::format(
            "the atlas has no simulation {}; 'pendular runs list --atlas' lists them", id));
    }
    return store.get(id);
}

}  // namespace pendular::app
