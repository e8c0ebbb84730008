#include "workflow/fit_runs.h"

#include <fmt/format.h>

#include <map>
#include <nlohmann/json.hpp>
#include <utility>

#include "sim/runs/store/run_table.h"
#include "workflow/run_json.h"

namespace pendular {
namespace {

constexpr const char* own_runs_name = "fit_runs.csv";

std::string run_name(const dem::RunResult& run) {
    return run_fingerprint({.physics_version = dem::physics_version, .run = run});
}

using RunsByName = std::map<std::string, dem::RunResult>;

void add_runs(RunsByName& known, const std::filesystem::path& table) {
    if (table.empty() || !std::filesystem::exists(table)) {
        return;
    }
    for (StoredRun& stored : read_runs(table)) {
        std::string name = run_fingerprint(stored);
        known.emplace(std::move(name), std::move(stored.run));
    }
}

}  // namespace

nlohmann::ordered_json run_names(const std::vector<dem::RunResult>& runs) {
    nlohmann::ordered_json names = nlohmann::ordered_json::array();
    for (const dem::RunResult& run : runs) {
        names.push_back(run_name(run));
    }
    return names;
}

void write_own_runs(const std::filesystem::path& folder, const std::vector<dem::RunResult>& runs) {
    RunsByName atlas;
    add_runs(atlas, atlas_file());
    std::vector<StoredRun> own;
    for (const dem::RunResult& run : runs) {
        if (!atlas.contains(run_name(run))) {
            own.push_back({.physics_version = dem::physics_version, .run = run});
        }
    }
    if (own.empty()) {
        std::filesystem::remove(folder / own_runs_name);
    } else {
        write_runs(folder / own_runs_name, own);
    }
}

std::vector<dem::RunResult> named_runs(const nlohmann::ordered_json& names,
                                       const std::filesystem::path& fit_file) {
    const auto own = fit_file.parent_path() / own_runs_name, atlas = atlas_file();
    RunsByName known;
    add_runs(known, atlas);
    add_runs(known, own);
    std::vector<dem::RunResult> runs;
    std::size_t missing = 0;
    for (const auto& name : names) {
        if (name.is_object()) {
            runs.push_back(run_from_json(name));
        } else if (const auto found = known.find(name.get<std::string>()); found != known.end()) {
            runs.push_back(found->second);
        } else {
            ++missing;
        }
    }
    if (missing > 0) {
        throw InputError(
            {fit_file.string()},
            fmt::format("{} of the {} simulations that this fit rests on are neither in the atlas "
                        "({}) nor in {}; one of the two was changed or removed since: run "
                        "'pendular calibrate' again",
                        missing, names.size(), atlas.empty() ? "there is none" : atlas.string(),
                        own.string()));
    }
    return runs;
}

}  // namespace pendular
