#include "workflow/json/training_runs.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <iterator>
#include <map>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>
#include <utility>

#include "data/files/file_access.h"
#include "data/files/json_text.h"
#include "sim/runs/run_request.h"
#include "sim/runs/store/run_table.h"
#include "workflow/json/run.h"

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

nlohmann::ordered_json runs_json(const std::vector<dem::RunResult>& runs,
                                 std::optional<std::size_t> began_with) {
    std::vector<std::string> names;
    std::ranges::transform(runs, std::back_inserter(names), run_name);
    std::vector<std::string> sorted = names;
    std::ranges::sort(sorted);
    return {
        {"number", names.size()},
        {"hash", fmt::format("{:016x}", fingerprint(fmt::format("{}", fmt::join(sorted, " "))))},
        {"began_with", began_with.value_or(names.size())},
        {"names", fmt::format("{}", fmt::join(names, " "))}};  // a line each would be hundreds
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

namespace {

/// Names of the runs in the entry `runs` of a result.
std::vector<std::string> names_in(const nlohmann::ordered_json& json) {
    if (json.is_array()) return json.get<std::vector<std::string>>();  // an earlier version
    std::istringstream text(json.at("names").get<std::string>());
    return {std::istream_iterator<std::string>(text), {}};
}

/// Whether an early version wrote the runs themselves in place of their names.
bool holds_whole_runs(const nlohmann::ordered_json& json) {
    return json.is_array() && !json.empty() && json.front().is_object();
}

TrainingRuns whole_runs(const nlohmann::ordered_json& json) {
    TrainingRuns whole;
    std::ranges::transform(json, std::back_inserter(whole.runs), run_from_json);
    whole.began_with = whole.runs.size();
    return whole;
}

/// Runs of these names, as far as they are known, with the number of those that are not.
std::pair<std::vector<dem::RunResult>, std::size_t> found_runs(
    const RunsByName& known, const std::vector<std::string>& names) {
    std::vector<dem::RunResult> runs;
    for (const std::string& name : names) {
        if (const auto found = known.find(name); found != known.end())
            runs.push_back(found->second);
    }
    const std::size_t missing = names.size() - runs.size();
    return {std::move(runs), missing};
}

std::size_t began_with(const nlohmann::ordered_json& json, std::size_t all) {
    return json.is_object() ? std::min(json.at("began_with").get<std::size_t>(), all) : all;
}

}  // namespace

TrainingRuns named_runs(const nlohmann::ordered_json& json, const std::filesystem::path& fit_file) {
    if (holds_whole_runs(json)) return whole_runs(json);
    const auto own = fit_file.parent_path() / own_runs_name, atlas = atlas_file();
    RunsByName known;
    add_runs(known, atlas);
    add_runs(known, own);
    const std::vector<std::string> names = names_in(json);
    auto [runs, missing] = found_runs(known, names);
    if (missing > 0) {
        throw InputError(
            {fit_file.string()},
            fmt::format("{} of the {} simulations that this fit rests on are neither in the atlas "
                        "({}) nor in {}; one of the two was changed or removed since: run "
                        "'pendular calibrate' again",
                        missing, names.size(), atlas.empty() ? "there is none" : atlas.string(),
                        own.string()));
    }
    const std::size_t count = began_with(json, runs.size());
    return {std::move(runs), count};
}

std::shared_ptr<const TrainingRuns> runs_of_result(const std::filesystem::path& result,
                                                   const RunStore* store) {
    const auto json =
        nlohmann::ordered_json::parse(read_bytes(result, largest_table), nullptr, false);
    const auto entry = json.is_object() ? json.find("runs") : json.end();
    if (!json.is_object() || entry == json.end()) {
        throw InputError({result.string()},
                         "names no simulations that a result rests on; --runs-of takes a JSON file "
                         "that 'pendular calibrate', 'compare', 'diagnose', 'next', 'predict' or "
                         "'report' wrote");
    }
    check_json_format(json, result, "repeat the result with this version");
    if (holds_whole_runs(*entry)) return std::make_shared<const TrainingRuns>(whole_runs(*entry));
    RunsByName known;
    add_runs(known, atlas_file());
    add_runs(known, result.parent_path() / own_runs_name);
    if (store) {
        for (StoredRun& stored : store->select()) {
            std::string name = run_fingerprint(stored);
            known.emplace(std::move(name), std::move(stored.run));
        }
    }
    try {
        const std::vector<std::string> names = names_in(*entry);
        auto [runs, missing] = found_runs(known, names);
        if (missing > 0) {
            throw InputError(
                {result.string()},
                fmt::format(
                    "{} of the {} simulations that this result rests on are neither in the "
                    "atlas nor in the store: it cannot be repeated; name the store that has "
                    "them with --store, or leave out --runs-of",
                    missing, names.size()));
        }
        const std::size_t count = began_with(*entry, runs.size());
        return std::make_shared<const TrainingRuns>(std::move(runs), count);
    } catch (const nlohmann::json::exception& error) {
        throw InputError(
            {result.string()},
            fmt::format("the entry 'runs' is not one that this version writes ({})", error.what()));
    }
}

}  // namespace pendular
