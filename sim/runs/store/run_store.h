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

/// Simulation run that was read from a store or from a CSV file.
struct StoredRun {
    std::int64_t id = 0;      ///< in the store; 0 if in none
    int physics_version = 0;  ///< of the solver that made the run
    /// Time series and final state are present only if `get` or `nearest` returned the run.
    dem::RunResult run;
};

/// SQLite file of the parameters and results of simulation runs. The parameters of a run, its
/// number of threads and the version of the solver identify the run. No run is stored twice.
/// Several processes and threads may read and write at once. If a process is killed, only the run
/// that it is carrying out is lost. Any SQLite tool can query the table `runs`, which has a column
/// for each of `run_columns()`.
///
/// All functions throw InputError for a file that is not a store, is corrupt or was written by a
/// newer version of the program, and std::runtime_error, naming the file and the reason, for a file
/// that cannot be written.
class RunStore {
  public:
    /// Opens a store. If `must_exist` is false, a missing file is created, with its folder; if
    /// true, a file that cannot be written is opened for reading only.
    /// @throws InputError if the file is missing and `must_exist` is true
    explicit RunStore(const std::filesystem::path& file, bool must_exist = false);
    ~RunStore();
    RunStore(const RunStore&) = delete;
    RunStore& operator=(const RunStore&) = delete;

    const std::filesystem::path& file() const { return file_; }

    /// Returns the stored run of the present version of the solver, without time series and final
    /// state; empty if there is none.
    std::optional<dem::RunResult> find(const dem::RunParameters& parameters, int threads = 1) const;
    /// Adds a run with its time series and final state.
    /// @return false, and nothing is changed, if the store already has the run
    bool add(const dem::RunResult& run, int physics_version = dem::physics_version);

    /// Returns the stored run whose parameters are nearest to `parameters`, with its final state,
    /// from which a new run can start; empty if no run qualifies. A run qualifies if it succeeded,
    /// is steady and not crystallised, has a stored final state and as many grains, and is dry or
    /// wet like `parameters`. The squared distance is
    ///     (d friction/0.1)^2 + (d ln I)^2 + (d ln kappa)^2 + (d ln P*)^2 + (d ln V0)^2
    /// with differences d, inertial number I, stiffness number kappa, reduced pressure P* and
    /// bridge volume V0 (the last two for wet runs only). Other parameters and the version of the
    /// solver do not count.
    std::optional<StoredRun> nearest(const dem::RunParameters& parameters) const;

    /// Returns the number of runs, including failed runs and runs of all versions of the solver.
    std::size_t size() const;
    /// Returns the runs that satisfy an SQL condition on the columns, such as "friction = 0.09 AND
    /// reduced_pressure IS NULL", in the order in which they were added, without time series and
    /// final state. An empty condition selects all runs.
    /// @throws InputError for a condition that SQLite does not understand
    std::vector<StoredRun> select(const std::string& condition = "") const;
    /// Returns the numbers (`StoredRun::id`) of the runs that satisfy an SQL condition. Corrupt
    /// runs, which cannot be read, are included.
    /// @throws InputError for a condition that SQLite does not understand
    std::vector<std::int64_t> numbers(const std::string& condition) const;
    /// Returns the run of a number (`StoredRun::id`), with its time series and final state.
    /// @throws InputError if the store has no run with this number
    StoredRun get(std::int64_t id) const;
    /// Removes runs by their numbers and returns how many were removed; unknown numbers are
    /// ignored.
    std::size_t remove(const std::vector<std::int64_t>& ids);
    /// Adds the runs of `other` that this store lacks, with time series and final states, and
    /// returns their number.
    std::size_t merge(const RunStore& other);

    /// Returns the path of the user's store: the environment variable PENDULAR_STORE, else
    /// $XDG_DATA_HOME/pendular/runs.sqlite, else ~/.local/share/pendular/runs.sqlite.
    static std::filesystem::path standard_file();

    static constexpr int format = store_format;
    /// Path of a store in memory, without a file.
    static constexpr const char* in_memory = store_in_memory;

    /// Checks that the path still leads to the file that was opened.
    /// @throws std::runtime_error if the file was removed or replaced
    void demand_present() const;

  private:
    /// Calls `take` for each row of the table `runs` that satisfies an SQL condition; empty: all
    /// rows.
    /// @param columns beginning of the SQL text, such as "SELECT id"
    void query(const std::string& columns, const std::string& condition,
               const std::function<void(SQLite::Statement&)>& take) const;

    std::filesystem::path file_;
    std::array<std::uint64_t, 2> identity_{};  ///< `identity_of` the opened file
    std::unique_ptr<SQLite::Database> database_;
    mutable std::mutex mutex_;  ///< serialises the threads of this process
};

}  // namespace pendular
