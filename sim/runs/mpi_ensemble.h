#pragma once

#include <filesystem>
#include <vector>

#include "sim/runs/ensemble.h"

namespace pendular {

/// MPI processes of this program: rank 0 distributes simulations to the other ranks. The
/// constructor initialises MPI, and the destructor finalises MPI.
class MpiProcesses {
  public:
    /// Whether mpirun, mpiexec or srun started this process with MPI. Reads only environment
    /// variables, so it may be called before MPI is initialised.
    static bool there();

    MpiProcesses();
    ~MpiProcesses();
    MpiProcesses(const MpiProcesses&) = delete;
    MpiProcesses& operator=(const MpiProcesses&) = delete;

    /// Whether this process has rank 0.
    bool manager() const { return rank_ == 0; }
    /// Returns the number of processes that carry out simulations: all except rank 0.
    int workers() const { return size_ - 1; }

    /// Distributes simulations to the other ranks, the longest first, one at a time to each, and
    /// adds each result to the store when it arrives. Only rank 0 may call this. After an error,
    /// the caller must end the other processes with `abort`.
    /// @param workers settings, of which `stop`, `report` and `store` are used; `store` must be set
    /// @throws dem::Interrupted if a stop is requested
    /// @throws std::runtime_error if a process of another rank runs another version of the program
    /// @throws InputError, std::runtime_error if the store cannot be read or written
    void manage(const std::vector<dem::RunParameters>& runs, const Workers& workers) const;

    /// Carries out the simulations that rank 0 sends and returns the results to it, until none is
    /// left. All ranks other than 0 must call this.
    /// @param store file of the store, beside which unfinished runs have their checkpoints; all
    ///         machines must see it at this path, else a run begins anew after a stop
    /// @throws dem::Interrupted if a stop is requested
    void work(const std::stop_token& stop, const std::filesystem::path& store) const;

    /// Ends all MPI processes of this program, including this one (MPI_Abort).
    [[noreturn]] void abort(int exit_code) const;

  private:
    int rank_ = 0, size_ = 1;
};

}  // namespace pendular
