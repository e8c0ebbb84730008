#pragma once

#include <deque>
#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "data/recordings/time_series.h"
#include "sim/catalogue/effect_catalogue.h"
#include "sim/runs/store/run_store.h"

namespace pendular {

// JSON of commands whose results are a few numbers or names.

/// State of a campaign: numbers of its runs.
struct CampaignState {
    std::size_t runs = 0, stored = 0, made = 0, failed = 0;
    std::filesystem::path store;
    /// Expected duration of the missing runs [s], empty if unknown; only of --dry-run.
    std::optional<std::optional<double>> seconds = {};
};

nlohmann::ordered_json to_json(const CampaignState& state);

/// Returns the JSON of a page that `pendular report` wrote.
/// @param models number of combinations of the effects `switches` that could be fitted
/// @param runs entry of the training runs (`runs_json`)
nlohmann::ordered_json page_json(const std::filesystem::path& file, const std::string& verdict,
                                 const std::vector<std::string>& switches, std::size_t models,
                                 const nlohmann::ordered_json& runs);

/// Returns the JSON of the address of `pendular serve`.
nlohmann::ordered_json address_json(const std::string& address, int port);

/// State of the page that `pendular serve` shows, as an open page requests it.
struct PageState {
    struct Event {
        std::size_t number = 0;
        std::string time, text;
        bool of_effect = false, ok = true;
    };
    std::size_t version = 0;
    std::string made;  ///< time
    bool working = false;
    std::string sentence;              ///< on the computation in progress
    std::optional<double> share = {};  ///< finished part of it [1]
    bool changing = false;             ///< whether an effect is being added or dropped
    std::string trouble;               ///< error that prevented a newer page
    std::deque<Event> events = {};     ///< the oldest first
};

nlohmann::ordered_json to_json(const PageState& state);

/// Returns the JSON of runs added to a store that now has `runs` runs.
nlohmann::ordered_json added_json(std::size_t added, std::size_t runs);

/// Observable of a second run less that of a first one.
struct RunDifference {
    dem::Observable which;
    Mean difference;
    double standardised = 0;  ///< difference over its standard error [1]
};

/// Returns the differences of the observables that both runs have.
std::vector<RunDifference> differences(const dem::RunResult& first, const dem::RunResult& second);

nlohmann::ordered_json differences_json(const StoredRun& first, const StoredRun& second);

/// Returns the JSON of a manual of effects.
/// @param pages effects, and whether the page of each has a figure
nlohmann::ordered_json manual_json(const std::filesystem::path& index,
                                   const std::vector<std::pair<std::string, bool>>& pages);

/// Relation of an effect to a study.
struct EffectStatus {
    bool listed = false;               ///< whether study.toml lists the effect
    std::optional<Obstacle> obstacle;  ///< why the effect does not apply; empty: it applies
};

/// Effect as `pendular effects` prints it, with its relation to the study that the user named.
struct EffectEntry {
    const Effect* effect;
    bool written = false;                     ///< whether the user wrote it in study.toml
    std::optional<EffectStatus> status = {};  ///< empty without a study
};

/// Parts of the experiment that an effect changes.
enum class Part : std::size_t { instrument, beads_and_liquid, grains, closure, flow };

/// Returns the part of the experiment that an effect changes.
Part part_changed(const Effect& effect);

/// Returns the readings that an effect changes: "dry", "wet", "failure" or "all".
const char* readings_changed(const Effect& effect);

/// Returns name, equation, parameters and bounds as JSON, with `EffectStatus` if it is known.
nlohmann::ordered_json to_json(const EffectEntry& entry);

nlohmann::ordered_json to_json(const std::vector<EffectEntry>& entries);

}  // namespace pendular
