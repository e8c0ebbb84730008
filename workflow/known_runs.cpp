#include "workflow/known_runs.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <iterator>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "sim/store/run_table.h"

namespace pendular {

std::optional<KnownRuns> known_runs(const Study& study, const Fidelity& fidelity,
                                    const RunStore* store, const Listener& listener) {
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
        tell(listener, {.text = fmt::format(
                            "of {} runs that could serve the emulator knows {}, the atlas and "
                            "the latest of the store; 'pendular runs prune' removes some",
                            known.runs.size(), most_known)});
        known.runs.resize(most_known);
    }
    return known.runs.size() < fewest ? std::nullopt : std::optional(std::move(known));
}

}  // namespace pendular
