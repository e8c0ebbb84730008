#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "sim/dem/run.h"
#include "sim/runs/store/store_file.h"

namespace pendular {

/// A simulation run as read from a store (SQLite file of runs) or from a CSV file of runs.
struct StoredRun {
    std::int64_t id = 0;      ///< number of the run in the store; 0: from no store
    int physics_version = 0;  ///< version of the solver that gave the run
    dem::RunResult run;       ///< has trace and final state only from `get` and `nearest`
};

/// The store: the user's SQLite file of all runs that were carried out. The key of a run contains
/// everything that determines the run (`run_description` and the physics version), and no run is
/// stored twice. Several processes and threads may read and write at once. Each run is added in one
/// transaction, so that a process that is killed loses only the run that it was carrying out.
///
/// The table `runs` has a column for each of `run_columns()`, so that any SQLite tool can query it.
///
/// All functions throw InputError for a file that is not a store, is corrupt or was written by a
/// newer version, and std::runtime_error, naming the file and the reason, for a file that cannot be
/// written.
class RunStore {
  public:
    /// Opens the SQLite file of runs, and creates the file and its folder if missing.
    /// Where `must_exist` is true, a file that cannot be written is opened for reading only.
    /// @throws InputError where the file is missing and `must_exist` is true
    explicit RunStore(const std::filesystem::path& file, bool must_exist = false);
    ~RunStore();
    RunStore(const RunStore&) = delete;
    RunStore& operator=(const RunStore&) = delete;

    const std::filesystem::path& file() const { return file_; }

    /// Returns the stored run with these parameters, number of threads and the current physics
    /// version, without trace and final state; empty where there is none.
    std::optional<dem::RunResult> find(const dem::RunParameters& parameters, int threads = 1) const;
    /// Adds a run with its trace and final state. Returns false, and changes nothing, if the store
    /// already has a run of equal parameters, number of threads and physics version.
    bool add(const dem::RunResult& run, int physics_version = dem::physics_version);

    /// Returns the stored run, with its final state, whose parameters are nearest to `parameters`,
    /// among runs that did not fail, are steady, not crystallised, of equal number of grains, and
    /// dry or wet as `parameters` is; empty where there is none. The squared distance, with d the
    /// difference of the two runs and the last two terms for wet runs only, is
    ///     (d friction/0.1)^2 + (d ln I)^2 + (d ln kappa)^2 + (d ln P*)^2 + (d ln V0)^2.
    std::optional<StoredRun> nearest(const dem::RunParameters& parameters) const;

    /// Number of runs in the store, of all physics versions and failed runs included.
    std::size_t size() const;
    /// Returns the stored runs, without trace and final state, that satisfy an SQL condition on the
    /// columns ("friction = 0.09 AND reduced_pressure IS NULL"), in the order in which they were
    /// added. An empty condition selects all runs.
    /// @throws InputError for a condition that SQLite does not understand
    std::vector<StoredRun> select(const std::string& condition = "") const;
    /// Numbers (StoredRun::id) of the runs that satisfy an SQL condition on the columns (see
    /// `select`), including corrupt runs, which cannot be read.
    /// @throws InputError for a condition that SQLite does not understand
    std::vector<std::int64_t> numbers(const std::string& condition) const;
    /// Returns the run with this number (StoredRun::id), including trace and final state.
    /// @throws InputError where the store has no run with this number
    StoredRun get(std::int64_t id) const;
    /// Removes the runs with these numbers (StoredRun::id) from the store, ignoring numbers that it
    /// does not have. Returns the number of removed runs.
    std::size_t remove(const std::vector<std::int64_t>& ids);
    /// Adds the runs of another store that are missing in this store, including traces and final
    /// states. Returns the number of added runs.
    std::size_t merge(const RunStore& other);

    /// Path of the user's store (SQLite file of runs): $PENDULAR_STORE, else
    /// $XDG_DATA_HOME/pendular/runs.sqlite, else ~/.local/share/pendular/runs.sqlite.
    static std::filesystem::path standard_file();

    static constexpr int format = store_format;  ///< version of the store's file format
    /// Name to pass to the constructor for a store that is kept in memory only, without a file.
    static constexpr const char* in_memory = store_in_memory;

    /// Checks that the store's file is the one that was opened.
    /// @throws std::runtime_error where the file was removed or replaced
    void demand_present() const;

  private:
    /// Calls `take` for each row of "SELECT `columns` FROM runs", with a condition unless empty.
    void query(const std::string& columns, const std::string& condition,
               const std::function<void(SQLite::Statement&)>& take) const;

    std::filesystem::path file_;
    std::array<std::uint64_t, 2> identity_{};  ///< device and number of the file that was opened
    std::unique_ptr<SQLite::Database> database_;
    mutable std::mutex mutex_;  ///< serialises access by the threads of this process
};

}  // namespace pendular
