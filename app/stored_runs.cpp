#include "app/stored_runs.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <charconv>
#include <iterator>
#include <set>
#include <vector>

#include "data/input_error.h"
#include "sim/store/run_table.h"

namespace pendular::app {

std::unique_ptr<RunStore> open_store(const CommonOptions& options) {
    if (!options.store_named) {
        std::error_code error;
        std::filesystem::create_directories(options.store.parent_path(), error);
        if (error || access(options.store.parent_path().c_str(), W_OK) != 0) {
            fmt::print(stderr,
                       "note: {} cannot be written, so that runs are not kept; --store FILE names "
                       "another place\n",
                       options.store.parent_path().string());
            return nullptr;
        }
    }
    return std::make_unique<RunStore>(options.store);
}

std::optional<KnownRuns> known_runs(const Study& study, const Fidelity& fidelity,
                                    const RunStore* store) {
    constexpr std::size_t fewest = 20;
    const std::filesystem::path atlas = atlas_file();
    std::vector<StoredRun> stored;
    KnownRuns known;
    if (!atlas.empty()) {
        stored = read_runs(atlas);
        const auto scales = atlas.parent_path() / scales_name;
        if (std::filesystem::exists(scales)) {
            known.scales = read_scales(scales);
        }
    }
    if (store) {
        auto own = store->select();
        std::ranges::move(own.rbegin(), own.rend(), std::back_inserter(stored));
    }
    std::set<std::string> there;
    std::vector<dem::RunResult> runs;
    for (StoredRun& each : stored) {
        if (each.physics_version == dem::physics_version &&
            there.insert(dem::described(each.run.parameters, each.run.threads)).second) {
            runs.push_back(std::move(each.run));
        }
    }
    known.runs = EmulatedSimulation::serving(study, fidelity, runs);
    if (known.runs.size() > most_known) {
        fmt::print(stderr,
                   "note: of {} runs that could serve the emulator knows {}, the atlas and the "
                   "latest of the store; 'pendular runs prune' removes some\n",
                   known.runs.size(), most_known);
        known.runs.resize(most_known);
    }
    return known.runs.size() < fewest ? std::nullopt : std::optional(std::move(known));
}

dem::Interrupted interrupted_with(const RunStore& store) {
    return dem::Interrupted(fmt::format(
        "the runs that were done are in {}; give the same command again to go on from there",
        store.file().string()));
}

std::int64_t run_number(const std::string& word) {
    std::int64_t id = 0;
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), id);
    if (error != std::errc() || end != word.data() + word.size()) {
        throw InputError(
            fmt::format("'{}' is no number of a run; 'pendular runs list' shows those "
                        "there are",
                        word));
    }
    return id;
}

}  // namespace pendular::app
