#pragma once

#include <vector>

#include "sim/runs/ensemble.h"

namespace pendular {

/// The processes that mpirun started this one with, for the life of this object: rank 0 manages,
/// the others carry out runs it hands them.
class MpiProcesses {
  public:
    /// Whether this process was started by mpirun, mpiexec or srun with MPI. Costs nothing, so that
    /// MPI is only initialised where it is used.
    static bool there();

    MpiProcesses();
    ~MpiProcesses();
    MpiProcesses(const MpiProcesses&) = delete;
    MpiProcesses& operator=(const MpiProcesses&) = delete;

    bool manager() const { return rank_ == 0; }
    int workers() const { return size_ - 1; }

    /// Rank 0: has the runs carried out, the longest first, a worker each, and keeps every one as
    /// it comes back. Of `workers` only `stop`, `report` and `store` are used; the store is this
    /// process's alone, so that machines need share no disk.
    /// @throws dem::Interrupted, and what the store throws; the others must then be ended
    void manage(const std::vector<dem::RunParameters>& runs, const Workers& workers) const;

    /// Other ranks: carries out what rank 0 sends until it sends no more.
    void work(const std::stop_token& stop) const;

    /// Ends every process, this one included.
    [[noreturn]] void abort(int exit_code) const;

  private:
    int rank_ = 0, size_ = 1;
};

}  // namespace pendular
