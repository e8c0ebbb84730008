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
/// each observable, the emulator has a Gaussian process over friction coefficient, inertial number,
/// reduced pressure and bridge volume. The processes are trained on simulation runs and take
/// account of the stated noise of the runs. Stress ratio and solid fraction share one process,
/// since the noise of the two observables is correlated within a run. The stiffness numbers of the
/// training runs are about equal. The solid fraction is predicted for rigid grains, and the mean
/// overlap for the stiffness number `emulated::reference_stiffness`, since the main dependence of
/// both observables on stiffness is known.
class PlainEmulator {
  public:
    /// Makes an emulator from training runs. Runs that are not usable (`emulated::usable`) are left
    /// out, for example because they failed, crystallised or were not steady. If an observable has
    /// no hyperparameters, they are fitted when they are first needed, which takes half a second
    /// for each observable.
    /// @param hyperparameters hyperparameters (amplitudes, correlation lengths and noise of the
    ///        Gaussian processes) for each observable; may be empty
    /// @param stiffness_number stiffness number [1] of the runs on which the Gaussian processes are
    ///        trained, with a tolerance of a factor of 2. If no run without effects has this
    ///        stiffness number, the stiffness number of the first run without effects is used
    ///        instead.
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
    struct PreparedShare {
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
        std::map<dem::Observable, PreparedShare> shares;
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
    /// The stiffness numbers of the runs may differ from the returned number by a factor of 2.
    double stiffness_number() const { return stiffness_number_; }
    /// Whether the Gaussian process of an observable can be trained on any of `runs`. Such a run
    /// must have a value of the observable and no effects on grains. The stiffness number of the
    /// run must be within a factor of 2 of `emulated::reference_stiffness`. If no run without
    /// effects is within this factor, the stiffness number of the first run without effects takes
    /// the place of `emulated::reference_stiffness`.
    static bool known(const std::vector<dem::RunResult>& runs, dem::Observable which);
    /// Fits the hyperparameters (amplitudes, correlation lengths and noise of the Gaussian process)
    /// of one observable to runs without effects (`fit_hyperparameters`). The fit uses the runs
    /// whose stiffness number is within a factor of 2 of `stiffness_number` [1]. If no run without
    /// effects is within this factor, the stiffness number of the first run without effects takes
    /// the place of `stiffness_number`.
    /// @throws std::invalid_argument if none of the runs to which the hyperparameters are fitted
    ///         has a value of the observable
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
