#include "app/stored_runs.h"

#include <fmt/format.h>

#include <unistd.h>
#include <charconv>

#include "app/terminal.h"
#include "data/input_error.h"
#include "sim/runs/store/run_table.h"

namespace pendular::app {

std::unique_ptr<RunStore> open_store(const CommonOptions& options) {
    if (!options.store_named) {
        std::error_code error;
        std::filesystem::create_directories(options.store.parent_path(), error);
        if (error || access(options.store.parent_path().c_str(), W_OK) != 0) {
            print_line(stderr, fmt::format("Note: {} cannot be written, so that no simulation is "
                                           "kept; --store FILE names another place",
                                           options.store.parent_path().string()));
            return nullptr;
        }
    }
    return std::make_unique<RunStore>(options.store);
}

std::shared_ptr<const TrainingRuns> training_runs(const CommonOptions& options,
                                                  const RunStore* store) {
    return options.runs_of ? runs_of_result(*options.runs_of, store) : nullptr;
}

std::int64_t run_number(const std::string& word) {
    std::int64_t id = 0;
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), id);
    if (error != std::errc() || end != word.data() + word.size()) {
        throw InputError(fmt::format(
            "'{}' is not the number of a stored simulation; 'pendular runs list' lists them",
            word));
    }
    return id;
}

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
