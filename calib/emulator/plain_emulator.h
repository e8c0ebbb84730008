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

/// Emulator that interpolates simulations of grains without effects such as rolling resistance. For
/// each observable, a Gaussian process over friction coefficient, inertial number, reduced pressure
/// and bridge volume is trained on simulation runs. Stress ratio and solid fraction share one
/// process, since their noise is correlated within a run. All training runs have about the same
/// stiffness number. The solid fraction is predicted for rigid grains, and the mean overlap for the
/// stiffness number `emulated::reference_stiffness`.
class PlainEmulator {
  public:
    /// Makes an emulator from training runs. Runs that are not usable (`emulated::usable`) are left
    /// out, such as runs that failed or crystallised. If an observable has no hyperparameters, the
    /// emulator fits them when they are first needed.
    /// @param hyperparameters hyperparameters (amplitudes, correlation lengths and noise of the
    ///        Gaussian processes) for each observable; may be empty
    /// @param stiffness_number stiffness number [1] of the training runs, with a tolerance of a
    ///        factor of 2; if no run without effects has this stiffness number, the stiffness
    ///        number of the first run without effects replaces it
    /// @throws std::invalid_argument if none of the runs is usable
    PlainEmulator(const std::vector<dem::RunResult>& runs, EmulatorHyperparameters hyperparameters,
                  double stiffness_number = emulated::reference_stiffness);

    /// Returns all hyperparameters that were given at construction or have been fitted since, with
    /// the observable as the key.
    EmulatorHyperparameters hyperparameters() const;

    /// Returns the result of each query for grains without effects: the predicted value of the
    /// observable, in the unit of the observable, or the derivative that the query names. Effects
    /// in the state of a query are ignored.
    /// @throws std::invalid_argument if no training run has a value of a queried observable, or if
    ///         the observable describes liquid bridges but the state is dry
    Eigen::VectorXd mean(const std::vector<Query>& queries) const;
    /// Queries whose results follow from one Gaussian process, with the intermediate results from
    /// which the covariance of the query results follows. The results of the queries are the matrix
    /// `map` times the values that the process predicts, plus constants (`emulated::Unit::offset`).
    struct QueriesOfProcess {
        /// Index, in the list of all queries, of each query whose result follows from the Gaussian
        /// process.
        std::vector<Eigen::Index> queries;
        GaussianProcess::Solved values;
        Eigen::SparseMatrix<double> map;
    };
    /// Queries with the intermediate results from which the covariances of the query results
    /// follow. The map `shares` has an entry for each Gaussian process that the queries need. The
    /// key of an entry is the observable under which the process is stored.
    struct PreparedQueries {
        Eigen::Index count = 0;
        std::map<dem::Observable, QueriesOfProcess> shares;
    };
    /// Computes the intermediate results from which the covariances of the results of `queries`
    /// follow.
    /// @throws std::invalid_argument if no training run has a value of a queried observable, or if
    ///         the observable describes liquid bridges but the state is dry
    PreparedQueries prepare(const std::vector<Query>& queries) const;
    /// Returns the covariance of the errors of the predicted results of `queries`. The matrix has a
    /// row and a column for each query.
    Eigen::MatrixXd covariance(const PreparedQueries& queries) const;
    /// Returns the covariance of the errors of the predicted results of the queries `a` (rows) with
    /// the errors of the predicted results of the queries `b` (columns).
    Eigen::MatrixXd covariance(const PreparedQueries& a, const PreparedQueries& b) const;

    /// Returns all usable runs that were given. The Gaussian processes are not trained on runs with
    /// effects on grains, nor on runs whose stiffness number differs from `stiffness_number()` by
    /// more than a factor of 2. `Emulator` uses these runs to predict changes by effects and by
    /// stiffness.
    const std::vector<dem::RunResult>& runs() const { return runs_; }

    /// Returns the variance of the noise of one observable of a run, in the square of the unit of
    /// the observable. The variance is the squared standard error of the run times the fitted noise
    /// factor, plus the squared between-run scatter (standard deviation between runs of equal
    /// parameters beyond the stated noise).
    double noise_variance(const dem::RunResult& run, dem::Observable which) const;
    /// Returns the covariance of the noise of the stress ratio and the solid fraction of one run
    /// [1], in this order.
    Eigen::Matrix2d noise(const dem::RunResult& run) const;

    /// Returns the stiffness number [1] of the runs on which the Gaussian processes are trained.
    /// The stiffness numbers of the runs differ from the returned number by at most a factor of 2.
    double stiffness_number() const { return stiffness_number_; }
    /// Whether any of `runs` can train the Gaussian process of an observable. The run must have a
    /// value of the observable, no effects on grains, and a stiffness number within a factor of 2
    /// of `emulated::reference_stiffness`. If no run without effects has such a stiffness number,
    /// the stiffness number of the first run without effects replaces
    /// `emulated::reference_stiffness`.
    static bool known(const std::vector<dem::RunResult>& runs, dem::Observable which);
    /// Fits the hyperparameters (amplitudes, correlation lengths and noise of the Gaussian process)
    /// of one observable. The fit uses the runs without effects whose stiffness number is within a
    /// factor of 2 of `stiffness_number` [1]. If there is no such run, the stiffness number of the
    /// first run without effects replaces `stiffness_number`.
    /// @throws std::invalid_argument if none of these runs has a value of the observable
    static Hyperparameters learn(const std::vector<dem::RunResult>& runs, dem::Observable which,
                                 double stiffness_number = emulated::reference_stiffness);

  private:
    /// Returns the hyperparameters (amplitudes, correlation lengths and noise of the Gaussian
    /// process) of one observable. If the hyperparameters of the observable were not given, the
    /// first call fits them.
    Hyperparameters hyperparameters_of(dem::Observable which) const;
    /// Returns the Gaussian process that predicts an observable. The first call trains the process.
    /// @throws std::invalid_argument if no training run has a value of the observable
    const GaussianProcess& process_of(dem::Observable which) const;
    /// Trains the Gaussian process that predicts an observable. The training runs are the usable
    /// runs without effects whose stiffness number is within a factor of 2 of `stiffness_number()`.
    /// @throws std::invalid_argument if no training run has a value of the observable
    std::unique_ptr<const GaussianProcess> trained(dem::Observable which) const;

    /// Gaussian process and hyperparameters of each observable, computed when they are first
    /// needed.
    struct Learned {
        struct Process {
            std::once_flag once;
            std::unique_ptr<const GaussianProcess> trained;
        };
        std::array<Process, dem::observable_count> processes;
        /// Lock that guards the map `hyperparameters` when several threads use the emulator.
        std::mutex mutex;
        EmulatorHyperparameters hyperparameters;
    };
    std::vector<dem::RunResult> runs_;
    double stiffness_number_;
    std::unique_ptr<Learned> learned_;
};

}  // namespace pendular
