#include "app/stored_runs.h"

#include <fmt/format.h>
#include <unistd.h>

#include <charconv>

#include "app/terminal.h"
#include "data/input_error.h"

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

}  // namespace pendular::app
