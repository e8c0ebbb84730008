#pragma once

#include <vector>

#include "sim/runs/ensemble.h"

namespace pendular {

/// MPI processes of this program. The constructor initialises MPI and the destructor finalises it.
/// Rank 0 distributes runs to the other ranks, which carry them out.
class MpiProcesses {
  public:
    /// Whether mpirun, mpiexec or srun started this process with MPI. Reads environment variables
    /// only, so that MPI need not be initialised to find out.
    static bool there();

    MpiProcesses();
    ~MpiProcesses();
    MpiProcesses(const MpiProcesses&) = delete;
    MpiProcesses& operator=(const MpiProcesses&) = delete;

    /// Whether this process is rank 0, which distributes the runs.
    bool manager() const { return rank_ == 0; }
    /// Number of MPI ranks that carry out runs: all except rank 0.
    int workers() const { return size_ - 1; }

    /// On rank 0: distributes the runs to the other ranks, the longest first, one at a time to each
    /// rank, and adds each result to the store (SQLite file of runs) when it arrives. Only `stop`,
    /// `report` and `store` of `workers` are used; `store` must be set. Only rank 0 accesses the
    /// store, so that the machines need no shared disk.
    /// @throws dem::Interrupted on a stop request, std::runtime_error where another rank runs
    ///         another version of the program, and whatever the store throws; the caller must then
    ///         end the other ranks with `abort`
    void manage(const std::vector<dem::RunParameters>& runs, const Workers& workers) const;

    /// On ranks other than 0: carries out the runs that rank 0 sends and sends back each result,
    /// until rank 0 says that there are no more runs.
    /// @throws dem::Interrupted when a stop is requested
    void work(const std::stop_token& stop) const;

    /// Aborts all MPI processes of the ensemble, including this one, by MPI_Abort; does not return.
    [[noreturn]] void abort(int exit_code) const;

  private:
    int rank_ = 0, size_ = 1;
};

}  // namespace pendular
