#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "sim/dem/run.h"

namespace SQLite {
class Database;
}

namespace pendular {

/// A run in a store.
struct StoredRun {
    std::int64_t id = 0;
    int physics_version = 0;
    dem::RunResult run;  ///< without trace and final state
};

/// Every run that was ever carried out, in one SQLite file. A run is keyed by all that determines
/// it
/// (`dem::run_description` and the physics version) and never stored twice. Several processes and
/// threads may read and write at once; each run is one transaction, so that a process killed at any
/// instant loses the run it was at and nothing else.
///
/// The table `runs` has a column for each of `run_columns()`, so that any SQLite tool can query it.
///
/// Everything throws InputError for a file that is no store, is corrupt or was written by a newer
/// version, and std::runtime_error, naming the file and the reason, where it cannot be written.
class RunStore {
  public:
    /// Opens the store, creating it and its folder where there is none. `must_exist`: throws
    /// InputError instead.
    explicit RunStore(const std::filesystem::path& file, bool must_exist = false);
    ~RunStore();
    RunStore(const RunStore&) = delete;
    RunStore& operator=(const RunStore&) = delete;

    const std::filesystem::path& file() const { return file_; }

    /// The run that these parameters give with this physics, without trace and final state; empty
    /// where it was never carried out.
    std::optional<dem::RunResult> find(const dem::RunParameters& parameters, int threads = 1) const;
    /// Keeps a run. @return false where it is there already, which leaves the store as it is
    bool add(const dem::RunResult& run, int physics_version = dem::physics_version);

    /// The steady run of as many grains, dry or wet like this one, whose flow is nearest to it,
    /// with its final state; empty where there is none. The measure is
    ///     (d friction/0.1)^2 + (d ln I)^2 + (d ln kappa)^2 + (d ln P*)^2 + (d ln V0)^2.
    std::optional<StoredRun> nearest(const dem::RunParameters& parameters) const;

    std::size_t size() const;
    /// Stored runs for which an SQL condition on the columns holds ("friction = 0.09 AND
    /// reduced_pressure IS NULL"), all where it is empty, as they were added.
    /// @throws InputError for a condition that SQLite does not understand
    std::vector<StoredRun> select(const std::string& condition = "") const;
    /// One run, whole. @throws InputError where there is none
    StoredRun get(std::int64_t id) const;
    /// Removes these runs. @return how many were there
    std::size_t remove(const std::vector<std::int64_t>& ids);
    /// Adds the runs of another store that are missing here, whole. @return how many
    std::size_t merge(const RunStore& other);

    /// $PENDULAR_STORE, else $XDG_DATA_HOME/pendular/runs.sqlite, else the same in ~/.local/share.
    static std::filesystem::path standard_file();

    static constexpr int format = 1;
    static constexpr const char* in_memory = ":memory:";  ///< a store without a file

  private:
    std::filesystem::path file_;
    std::unique_ptr<SQLite::Database> database_;
    mutable std::mutex mutex_;  ///< the threads of this process take turns
};

}  // namespace pendular
