#pragma once

#include <Eigen/Core>
#include <Eigen/SparseCore>
#include <array>
#include <map>
#include <memory>
#include <mutex>
#include <vector>

#include "calib/emulator/emulated_observables.h"
#include "calib/emulator/gaussian_process.h"
#include "calib/emulator/query.h"
#include "sim/dem/run.h"

namespace pendular {

/// Emulator of grains without effects such as rolling resistance. For each observable, a Gaussian
/// process over friction coefficient, inertial number, reduced pressure and bridge volume is
/// trained on simulation runs. Stress ratio and solid fraction share one process, since their noise
/// is correlated within a run. All training runs have no effects and about the same stiffness
/// number (to a factor of 2). The solid fraction is predicted for rigid grains, and the mean
/// overlap for the stiffness number `emulated::reference_stiffness`.
class PlainEmulator {
  public:
    /// Makes an emulator from those training runs that are `emulated::usable`. Hyperparameters that
    /// `hyperparameters` lacks are fitted when first needed.
    /// @param stiffness_number of the training runs [1], to a factor of 2; if no run without
    ///        effects has it, that of the first run without effects replaces it
    /// @throws std::invalid_argument if none of the runs is usable
    PlainEmulator(const std::vector<dem::RunResult>& runs, EmulatorHyperparameters hyperparameters,
                  double stiffness_number = emulated::reference_stiffness);

    /// Returns all hyperparameters that were given at construction or have been fitted since.
    EmulatorHyperparameters hyperparameters() const;

    /// Returns the result of each query for grains without effects, in the unit of the observable.
    /// Effects in the state of a query are ignored.
    /// @throws std::invalid_argument if no training run has a value of a queried observable, or if
    ///         the observable describes liquid bridges but the state is dry
    Eigen::VectorXd mean(const std::vector<Query>& queries) const;
    /// Queries whose results follow from one Gaussian process: `map` times the values that the
    /// process predicts, plus constants (`emulated::Unit::offset`).
    struct QueriesOfProcess {
        std::vector<Eigen::Index> queries;  ///< indices in the list of all queries
        GaussianProcess::Solved values;
        Eigen::SparseMatrix<double> map;
    };
    /// Queries with the intermediate results for their covariances, for each Gaussian process under
    /// the observable under which the process is stored.
    struct PreparedQueries {
        Eigen::Index count = 0;
        std::map<dem::Observable, QueriesOfProcess> shares;
    };
    /// Returns what covariance() needs of `queries`.
    /// @throws std::invalid_argument as mean()
    PreparedQueries prepare(const std::vector<Query>& queries) const;
    /// Returns the covariance of the errors of the results of `queries`.
    Eigen::MatrixXd covariance(const PreparedQueries& queries) const;
    /// Returns the covariance of the errors of the queries `a` (rows) with those of `b` (columns).
    Eigen::MatrixXd covariance(const PreparedQueries& a, const PreparedQueries& b) const;

    /// Returns all usable runs that were given, also those with effects or other stiffness numbers,
    /// from which `Emulator` predicts changes.
    const std::vector<dem::RunResult>& runs() const { return runs_; }

    /// Returns the variance of the noise of one observable of a run, in its unit squared: squared
    /// standard error times noise factor, plus squared between-run scatter.
    double noise_variance(const dem::RunResult& run, dem::Observable which) const;
    /// Returns the covariance of the noise of the stress ratio and the solid fraction of a run [1].
    Eigen::Matrix2d noise(const dem::RunResult& run) const;

    /// Returns the stiffness number [1] of the training runs.
    double stiffness_number() const { return stiffness_number_; }
    /// Whether any of `runs` would train an emulator of default stiffness number for an observable.
    static bool known(const std::vector<dem::RunResult>& runs, dem::Observable which);
    /// Returns hyperparameters fitted to the runs for an emulator of this stiffness number.
    /// @throws std::invalid_argument if none of these runs has a value of the observable
    static Hyperparameters learn(const std::vector<dem::RunResult>& runs, dem::Observable which,
                                 double stiffness_number = emulated::reference_stiffness);

  private:
    /// Returns the given hyperparameters of one observable, or fits them at the first call.
    Hyperparameters hyperparameters_of(dem::Observable which) const;
    /// Returns the Gaussian process of an observable. The first call trains it.
    /// @throws std::invalid_argument if no training run has a value of the observable
    const GaussianProcess& process_of(dem::Observable which) const;
    std::unique_ptr<const GaussianProcess> trained(dem::Observable which) const;

    /// Gaussian processes and hyperparameters, computed when they are first needed.
    struct Learned {
        struct Process {
            std::once_flag once;
            std::unique_ptr<const GaussianProcess> trained;
        };
        std::array<Process, dem::observable_count> processes;
        std::mutex mutex;  ///< guards `hyperparameters`
        EmulatorHyperparameters hyperparameters;
    };
    std::vector<dem::RunResult> runs_;
    double stiffness_number_;
    std::unique_ptr<Learned> learned_;
};

}  // namespace pendular
