#pragma once

#include <filesystem>
#include <functional>

#include "sim/dem/run.h"

namespace pendular {

/// Checkpoints of simulations, one file for each unfinished run in a folder beside the store. A run
/// that was stopped by Ctrl-C, or killed, goes on where its last checkpoint was written when it is
/// carried out again, with the same result bit for bit. The file of a run is removed with the run's
/// end, and the empty folder with the object.
class RunCheckpoints {
  public:
    /// @param store file of the store; the folder is STORE.unfinished. A store in memory, or an
    ///         empty path: no checkpoints are written
    explicit RunCheckpoints(const std::filesystem::path& store);
    ~RunCheckpoints();
    RunCheckpoints(const RunCheckpoints&) = delete;
    RunCheckpoints& operator=(const RunCheckpoints&) = delete;

    /// Carries out one simulation in the calling thread, from its checkpoint if there is one, and
    /// returns its averages. If the simulation fails (dem::SimulationError), the result has only
    /// its parameters and `RunResult::failure`. A checkpoint that cannot be read, such as that of
    /// another version of the program, is removed and the run begun anew. While another process
    /// carries out the same run, the run has no checkpoint.
    /// @param keep keeps the result, before the checkpoint is removed
    /// @throws std::invalid_argument for a run that cannot be simulated
    /// @throws dem::Interrupted if a stop is requested, after the checkpoint was written
    dem::RunResult simulated(const dem::RunParameters& run, dem::RunOptions options,
                             const std::function<void(const dem::RunResult&)>& keep) const;

    /// Returns the path of the checkpoint of a run.
    std::filesystem::path file_of(const dem::RunParameters& run) const;

  private:
    std::filesystem::path folder_;
};

}  // namespace pendular
