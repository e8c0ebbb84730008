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

/// Simulation run that was read from a store (SQLite file of runs) or from a CSV file of runs.
struct StoredRun {
    std::int64_t id = 0;      ///< number of the run in the store, 0 if the run is in no store
    int physics_version = 0;  ///< version of the solver that made the run
    /// Parameters of the stored run and averages of its observables. The time series (trace) and
    /// the final state are present only if `get` or `nearest` returned the run.
    dem::RunResult run;
};

/// Store: SQLite file of the parameters and results of simulation runs. The parameters of a run,
/// its number of threads and the version of the solver identify the run. No run is stored twice.
/// Several processes and threads may read and write at once. If a process is killed, only the run
/// that it is carrying out is lost. Any SQLite tool can query the table `runs`, which has a column
/// for each of `run_columns()`.
///
/// All functions throw InputError for a file that is not a store, is corrupt or was written by a
/// newer version of the program. All functions throw std::runtime_error, naming the file and the
/// reason, for a file that cannot be written.
class RunStore {
  public:
    /// Opens a store. If `must_exist` is false, a missing file is created, with its folder. If
    /// `must_exist` is true, a file that cannot be written is opened for reading only.
    /// @param must_exist whether a missing file is an error
    /// @throws InputError if the file is missing and `must_exist` is true
    explicit RunStore(const std::filesystem::path& file, bool must_exist = false);
    ~RunStore();
    RunStore(const RunStore&) = delete;
    RunStore& operator=(const RunStore&) = delete;

    const std::filesystem::path& file() const { return file_; }

    /// Returns the stored run with given parameters, a given number of threads and the present
    /// version of the solver. The returned run lacks its time series (trace) and its final state.
    /// The result is empty if the store does not contain the run.
    std::optional<dem::RunResult> find(const dem::RunParameters& parameters, int threads = 1) const;
    /// Adds a run with its time series (trace) and final state.
    /// @return false, and nothing is changed, if the store already has a run with equal parameters,
    ///         number of threads and version of the solver
    bool add(const dem::RunResult& run, int physics_version = dem::physics_version);

    /// Returns the stored run whose parameters are nearest to `parameters`, with its final state,
    /// from which a new run can start; empty if no run qualifies. A run qualifies if it succeeded,
    /// is steady and not crystallised, and has a stored final state. The run must have the number
    /// of grains that `parameters` states, and must be dry or wet like `parameters`. The squared
    /// distance between the parameters of two runs is
    ///     (d friction/0.1)^2 + (d ln I)^2 + (d ln kappa)^2 + (d ln P*)^2 + (d ln V0)^2
    /// with differences d, inertial number I, stiffness number kappa, reduced pressure P* and
    /// bridge volume V0. The terms of P* and V0 count for wet runs only. Other parameters and the
    /// version of the solver do not count.
    std::optional<StoredRun> nearest(const dem::RunParameters& parameters) const;

    /// Returns the number of runs in the store, including failed runs and runs of all versions of
    /// the solver.
    std::size_t size() const;
    /// Returns the stored runs that satisfy an SQL condition on the columns, such as "friction =
    /// 0.09 AND reduced_pressure IS NULL", in the order in which the runs were added. The returned
    /// runs lack time series (trace) and final state. An empty condition selects all runs.
    /// @throws InputError for a condition that SQLite does not understand
    std::vector<StoredRun> select(const std::string& condition = "") const;
    /// Returns the numbers (`StoredRun::id`) of the runs that satisfy an SQL condition on the
    /// columns, such as "friction = 0.09". Corrupt runs, which cannot be read, are included.
    /// @throws InputError for a condition that SQLite does not understand
    std::vector<std::int64_t> numbers(const std::string& condition) const;
    /// Returns the run with the number `id` (`StoredRun::id`), with its time series (trace) and
    /// final state.
    /// @throws InputError if the store has no run with this number
    StoredRun get(std::int64_t id) const;
    /// Removes runs from the store, and returns the number of removed runs.
    /// @param ids numbers of the runs (`StoredRun::id`); numbers of runs that are not in the store
    ///         are ignored
    std::size_t remove(const std::vector<std::int64_t>& ids);
    /// Adds to this store the runs of the store `other` that this store lacks, with their time
    /// series (traces) and final states. Returns the number of added runs.
    std::size_t merge(const RunStore& other);

    /// Returns the path of the user's store (SQLite file of runs). The path is the value of the
    /// environment variable PENDULAR_STORE, else $XDG_DATA_HOME/pendular/runs.sqlite, else
    /// ~/.local/share/pendular/runs.sqlite.
    static std::filesystem::path standard_file();

    static constexpr int format = store_format;  ///< version of the store's file format
    /// Path that makes the constructor open a store in memory, without a file.
    static constexpr const char* in_memory = store_in_memory;

    /// Checks that the path of the store still leads to the file that was opened.
    /// @throws std::runtime_error if the file of the store was removed or replaced
    void demand_present() const;

  private:
    /// Calls `take` for each row of the table `runs` that satisfies an SQL condition. An empty
    /// condition selects all rows.
    /// @param columns beginning of the SQL text, such as "SELECT id"
    void query(const std::string& columns, const std::string& condition,
               const std::function<void(SQLite::Statement&)>& take) const;

    std::filesystem::path file_;
    /// Device number and inode number of the store's file when the file was opened.
    std::array<std::uint64_t, 2> identity_{};
    std::unique_ptr<SQLite::Database> database_;
    mutable std::mutex mutex_;  ///< mutex that serialises access by the threads of this process
};

}  // namespace pendular
