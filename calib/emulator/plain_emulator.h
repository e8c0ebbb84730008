#pragma once

#include <Eigen/Core>
#include <array>
#include <memory>
#include <mutex>
#include <vector>

#include "calib/emulator/emulated_observables.h"
#include "calib/emulator/gaussian_process.h"
#include "calib/emulator/query.h"
#include "sim/dem/run.h"

namespace pendular {

/// Emulator of grains without effects: for each observable a Gaussian process over friction,
/// inertial number, reduced pressure and bridge volume, whose noise is the runs' own. The stress
/// ratio and the solid fraction of one run are correlated, and so are what is said of them.
/// Observables are those of runs but for two that depend on stiffness in a known way, so that runs
/// of any stiffness serve: the solid fraction is that of rigid grains and the overlap is that at
/// the stiffness number `emulated::reference_stiffness`. What else is told of structure is that of
/// runs of about one stiffness, on which it depends weakly.
///
/// A process is trained when it is first asked for, once for all threads.
class PlainEmulator {
  public:
    /// Runs that failed, crystallised or were not steady are left out, and those of another damping
    /// than the standard. Hyperparameters that are missing are fitted, half a second an observable.
    /// @throws std::invalid_argument where no run is left
    PlainEmulator(const std::vector<dem::RunResult>& runs, EmulatorHyperparameters hyperparameters,
                  double structure_stiffness = emulated::reference_stiffness);

    /// Hyperparameters in use, those fitted so far included.
    EmulatorHyperparameters hyperparameters() const;

    /// An entry for each query, whose effects do not count.
    /// @throws std::invalid_argument for an observable of bridges where no run was wet, or of a dry
    ///         state
    Eigen::VectorXd mean(const std::vector<Query>& queries) const;
    /// Covariance of the errors of `mean`, a row and a column for each query.
    Eigen::MatrixXd covariance(const std::vector<Query>& queries) const;

    /// All possible training runs, with and without effects.
    const std::vector<dem::RunResult>& runs() const { return runs_; }

    /// Variance of what a run says about what a longer one would: of the error it states and of the
    /// between-run scatter beyond that.
    double noise_variance(const dem::RunResult& run, dem::Observable which) const;
    /// Covariance of the noise of stress ratio and solid fraction of one run [1].
    Eigen::Matrix2d noise(const dem::RunResult& run) const;

    /// Stiffness number of the runs that tell of structure, but for a factor 2.
    double structure_stiffness() const { return structure_stiffness_; }
    /// Whether any of these runs has a value of an observable.
    static bool known(const std::vector<dem::RunResult>& runs, dem::Observable which);
    /// Hyperparameters of greatest likelihood for one observable.
    /// @throws std::invalid_argument where none does
    static Hyperparameters learn(const std::vector<dem::RunResult>& runs, dem::Observable which,
                                 double structure_stiffness = emulated::reference_stiffness);

  private:
    Hyperparameters hyperparameters_of(dem::Observable which) const;
    const GaussianProcess& process_of(dem::Observable which) const;
    std::unique_ptr<const GaussianProcess> trained(dem::Observable which) const;

    /// State that is computed when it is first needed.
    struct Learned {
        struct Process {
            std::once_flag once;
            std::unique_ptr<const GaussianProcess> trained;
        };
        std::array<Process, dem::observable_count> processes;
        std::mutex mutex;  ///< of the hyperparameters
        EmulatorHyperparameters hyperparameters;
    };
    std::vector<dem::RunResult> runs_;
    double structure_stiffness_;
    std::unique_ptr<Learned> learned_;
};

}  // namespace pendular
