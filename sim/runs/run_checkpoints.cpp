#include "sim/runs/run_checkpoints.h"

#include <fmt/format.h>

#include <chrono>
#include <memory>
#include <string>

#include "data/input_error.h"
#include "sim/dem/checkpoint.h"
#include "sim/dem/simulation_error.h"
#include "sim/runs/run_request.h"
#include "sim/runs/store/run_store.h"

namespace pendular {
namespace {

/// Time between checkpoints of a run [s]: what a kill without warning loses. A checkpoint of 4000
/// grains has 5 MB and takes a tenth of a second with its fsync, 0.2 % of a minute.
constexpr std::chrono::seconds between{60};

dem::RunResult run_one(const dem::RunParameters& run, const dem::RunOptions& options) {
    try {
        return simulate(run, options);
    } catch (const dem::SimulationError& error) {
        // The failure of one sample must not end the other runs.
        return {.parameters = run, .failure = error.what()};
    }
}

/// Checkpoint of a run; empty where it cannot be locked or written.
std::unique_ptr<dem::Checkpoint> checkpoint_at(const std::filesystem::path& file) {
    try {
        return std::make_unique<dem::Checkpoint>(file, between);
    } catch (const InputError&) {
        return nullptr;  // the run itself needs no checkpoint
    }
}

}  // namespace

RunCheckpoints::RunCheckpoints(const std::filesystem::path& store)
    : folder_(store.empty() || store == RunStore::in_memory
                  ? std::filesystem::path()
                  : std::filesystem::path(store.string() + ".unfinished")) {}

RunCheckpoints::~RunCheckpoints() {
    std::error_code ignored;  // the folder stays where it has checkpoints
    if (!folder_.empty()) std::filesystem::remove(folder_, ignored);
}

std::filesystem::path RunCheckpoints::file_of(const dem::RunParameters& run) const {
    // Each version of the solver has its own: this one must not continue a run of another.
    const std::string text =
        fmt::format("{}physics version = {}\n", run_description(run), dem::physics_version);
    return folder_ / fmt::format("{:016x}.checkpoint", fingerprint(text));
}

dem::RunResult RunCheckpoints::simulated(
    const dem::RunParameters& run, dem::RunOptions options,
    const std::function<void(const dem::RunResult&)>& keep) const {
    const auto checkpoint = folder_.empty() ? nullptr : checkpoint_at(file_of(run));
    options.checkpoint = checkpoint.get();
    const auto result = [&] {
        try {
            return run_one(run, options);
        } catch (const InputError&) {
            checkpoint->remove();  // only a checkpoint that cannot be read is an input
            return run_one(run, options);
        }
    }();
    keep(result);
    if (checkpoint) checkpoint->remove();
    return result;
}

}  // namespace pendular
