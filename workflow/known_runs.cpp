#include "workflow/known_runs.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <iterator>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "calib/emulator/known_runs.h"
#include "sim/runs/run_request.h"
#include "sim/runs/store/run_table.h"

namespace pendular {

EmulatorHyperparameters atlas_hyperparameters() {
    const std::filesystem::path atlas = atlas_file();
    const auto file = atlas.parent_path() / hyperparameters_name;
    return !atlas.empty() && std::filesystem::exists(file) ? read_hyperparameters(file)
                                                           : EmulatorHyperparameters{};
}

std::optional<KnownRuns> known_runs(const Study& study, const Fidelity& fidelity,
                                    const RunStore* store, const Listener& listener) {
    // Chosen: twice the number of hyperparameters of a process. With fewer runs, the fit makes its
    // own, at the conditions of the readings.
    constexpr std::size_t fewest = 20;
    const std::filesystem::path atlas = atlas_file();
    std::vector<StoredRun> stored;
    KnownRuns known;
    if (!atlas.empty()) {
        stored = read_runs(atlas);
        known.hyperparameters = atlas_hyperparameters();
    }
    if (store) {
        auto own = store->select();
        std::ranges::move(own.rbegin(), own.rend(), std::back_inserter(stored));
    }
    std::set<std::string> there;
    std::vector<dem::RunResult> runs;
    for (StoredRun& each : stored) {
        if (each.physics_version == dem::physics_version &&
            there.insert(run_description(each.run.parameters, each.run.threads)).second) {
            runs.push_back(std::move(each.run));
        }
    }
    known.runs = runs_serving(study, fidelity, runs);
    if (known.runs.size() > most_known) {
        tell(listener,
             {.text = fmt::format("Of {} simulations that could train the emulator, it uses {}: "
                                  "those of the atlas and the latest of the store. 'pendular runs "
                                  "prune' removes simulations from the store.",
                                  known.runs.size(), most_known)});
        known.runs.resize(most_known);
    }
    return known.runs.size() < fewest ? std::nullopt : std::optional(std::move(known));
}

}  // namespace pendular
