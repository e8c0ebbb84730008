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

/// Emulator of grains without effects: for each observable, a Gaussian process over friction,
/// inertial number, reduced pressure and bridge volume, trained on simulation runs with the noise
/// that they state. Stress ratio and solid fraction share one process, since their noise is
/// correlated within a run. The training runs have about one stiffness number. The solid fraction
/// is predicted for rigid grains and the mean overlap for the stiffness number
/// `emulated::reference_stiffness`, since their main dependence on stiffness is known.
class PlainEmulator {
  public:
    /// Takes training runs and leaves out those that are not usable (`emulated::usable`), for
    /// example since they failed, crystallised or were not steady. Missing hyperparameters are
    /// fitted when they are first needed, which takes half a second for each observable.
    /// @param hyperparameters hyperparameters by observable; may be empty
    /// @param stiffness_number stiffness number [1], within a factor 2, of the runs that train the
    ///        processes. If no run without effects has this stiffness number, that of the first run
    ///        without effects is used instead.
    /// @throws std::invalid_argument if none of the runs is usable
    PlainEmulator(const std::vector<dem::RunResult>& runs, EmulatorHyperparameters hyperparameters,
                  double stiffness_number = emulated::reference_stiffness);

    /// Hyperparameters that were given at construction or have been fitted since, by observable.
    EmulatorHyperparameters hyperparameters() const;

    /// Returns the result of each query for grains without effects: the predicted value of its
    /// observable, in the unit of the observable, or the derivative that the query names. Effects
    /// in the state of a query are ignored.
    /// @throws std::invalid_argument if no training run has a value of a queried observable, or if
    ///         the observable describes liquid bridges but the state is dry
    Eigen::VectorXd mean(const std::vector<Query>& queries) const;
    /// Queries whose results follow from one Gaussian process, with the intermediate results for
    /// their covariances. The results of the queries are `map` times the values that the process
    /// predicts.
    struct PreparedShare {
        /// Indices, in the list of all queries, of the queries whose results follow from the
        /// process.
        std::vector<Eigen::Index> queries;
        GaussianProcess::Solved values;
        Eigen::SparseMatrix<double> map;
    };
    /// Queries with the intermediate results for their covariances, computed once. `shares` has an
    /// entry for each Gaussian process, by the observable under which the process is stored.
    struct PreparedQueries {
        Eigen::Index count = 0;
        std::map<dem::Observable, PreparedShare> shares;
    };
    /// Computes the intermediate results from which the covariances of the results of queries
    /// follow.
    /// @throws std::invalid_argument if no training run has a value of a queried observable, or if
    ///         the observable describes liquid bridges but the state is dry
    PreparedQueries prepare(const std::vector<Query>& queries) const;
    /// Covariance of the errors of the predicted results of `queries`, a row and a column for each
    /// query.
    Eigen::MatrixXd covariance(const PreparedQueries& queries) const;
    /// Covariance of the errors of the predicted results of the queries `a` (rows) with those of
    /// the queries `b` (columns).
    Eigen::MatrixXd covariance(const PreparedQueries& a, const PreparedQueries& b) const;

    /// All usable runs that were given. Runs with effects on grains, or of another stiffness
    /// number, train only the changes that `Emulator` adds.
    const std::vector<dem::RunResult>& runs() const { return runs_; }

    /// Variance of the noise of one observable of a run, in the square of the observable's unit:
    /// the squared standard error of the run times the fitted noise factor, plus the squared
    /// between-run scatter.
    double noise_variance(const dem::RunResult& run, dem::Observable which) const;
    /// Covariance of the noise of stress ratio and solid fraction of one run [1], in this order.
    Eigen::Matrix2d noise(const dem::RunResult& run) const;

    /// Stiffness number of the runs that train the Gaussian processes, within a factor 2 [1].
    double stiffness_number() const { return stiffness_number_; }
    /// Whether any of `runs` can train the process of an observable. Such a run has no effects on
    /// grains and has a value of the observable. Its stiffness number is within a factor 2 of
    /// `emulated::reference_stiffness` or, if this holds for no run without effects, of the
    /// stiffness number of the first run without effects.
    static bool known(const std::vector<dem::RunResult>& runs, dem::Observable which);
    /// Fits the hyperparameters (amplitudes and lengths of its Gaussian process) of one observable
    /// to runs without effects (`fit_hyperparameters`). These are the runs whose stiffness number
    /// is about `stiffness_number` [1] or, if there are no such runs, about that of the first run
    /// without effects.
    /// @throws std::invalid_argument if none of these runs has a value of the observable
    static Hyperparameters learn(const std::vector<dem::RunResult>& runs, dem::Observable which,
                                 double stiffness_number = emulated::reference_stiffness);

  private:
    /// Returns the hyperparameters (amplitudes and lengths of its Gaussian processes) of one
    /// observable; missing ones are fitted at the first call.
    Hyperparameters hyperparameters_of(dem::Observable which) const;
    /// Returns the Gaussian process that predicts an observable, trained at the first call.
    /// @throws std::invalid_argument if no training run has a value of the observable
    const GaussianProcess& process_of(dem::Observable which) const;
    /// Trains the Gaussian process that predicts an observable on all usable runs without effects.
    std::unique_ptr<const GaussianProcess> trained(dem::Observable which) const;

    /// Gaussian processes and hyperparameters by observable, each computed when it is first needed.
    struct Learned {
        struct Process {
            std::once_flag once;
            std::unique_ptr<const GaussianProcess> trained;
        };
        std::array<Process, dem::observable_count> processes;
        /// Guards the map `hyperparameters` when several threads use the emulator.
        std::mutex mutex;
        EmulatorHyperparameters hyperparameters;
    };
    std::vector<dem::RunResult> runs_;
    double stiffness_number_;
    std::unique_ptr<Learned> learned_;
};

}  // namespace pendular
