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

/// Emulator of grains without effects: for each observable a Gaussian process over friction,
/// inertial number, reduced pressure and bridge volume, trained on runs with the noise that they
/// state. The noise of stress ratio and solid fraction of one run is correlated, and so are their
/// predictions. The processes are trained on runs of about one stiffness number. The solid fraction
/// is predicted for rigid grains, the overlap for the stiffness number
/// `emulated::reference_stiffness`: their main dependence on stiffness is known.
///
/// Each process is trained when it is first needed, once for all threads.
class PlainEmulator {
  public:
    /// Takes training runs and leaves out those that are not `emulated::usable`: runs that failed,
    /// crystallised or were not steady, for example. Missing hyperparameters are fitted when they
    /// are first needed, which takes half a second for each observable.
    /// @param stiffness_number stiffness number, within a factor 2, of the runs that train the
    ///        processes [1]. Where no run without effects has it, that of the first such run.
    /// @throws std::invalid_argument where no usable run is left
    PlainEmulator(const std::vector<dem::RunResult>& runs, EmulatorHyperparameters hyperparameters,
                  double stiffness_number = emulated::reference_stiffness);

    /// Hyperparameters of the observables for which they were given at construction or fitted
    /// since.
    EmulatorHyperparameters hyperparameters() const;

    /// Predicted value of the observable of each query, in its unit, or the derivative that the
    /// query names, for grains without the effects of the query's state.
    /// @throws std::invalid_argument for an observable of which no training run has a value, and
    ///         for an observable of bridges at a dry state
    Eigen::VectorXd mean(const std::vector<Query>& queries) const;
    /// Queries that one Gaussian process answers, with the terms that covariances need: answer =
    /// map x values that the process predicts.
    struct PreparedShare {
        std::vector<Eigen::Index> queries;  ///< indices of the queries
        GaussianProcess::Solved values;
        Eigen::SparseMatrix<double> map;
    };
    /// Queries with the terms that their covariances need, computed once; the shares of the
    /// processes by the observable under which each process is stored.
    struct PreparedQueries {
        Eigen::Index count = 0;
        std::map<dem::Observable, PreparedShare> shares;
    };
    /// Computes the terms that the covariances of predictions need.
    /// @throws std::invalid_argument as `mean` does
    PreparedQueries prepare(const std::vector<Query>& queries) const;
    /// Covariance of the errors of the predictions that `mean` returns, a row and a column for each
    /// query.
    Eigen::MatrixXd covariance(const PreparedQueries& queries) const;
    /// Covariance of the errors of the predictions for the queries `a` (rows) with those for the
    /// queries `b` (columns).
    Eigen::MatrixXd covariance(const PreparedQueries& a, const PreparedQueries& b) const;

    /// All usable runs that were given; those with effects on grains or of another stiffness number
    /// train only the responses of `Emulator`.
    const std::vector<dem::RunResult>& runs() const { return runs_; }

    /// Variance of the noise of one observable of a run, in the square of the observable's unit:
    /// the square of the run's standard error times the fitted noise factor, plus the between-run
    /// scatter.
    double noise_variance(const dem::RunResult& run, dem::Observable which) const;
    /// Covariance of the noise of stress ratio and solid fraction of one run [1], in this order.
    Eigen::Matrix2d noise(const dem::RunResult& run) const;

    /// Stiffness number, within a factor 2, of the runs that train the processes [1].
    double stiffness_number() const { return stiffness_number_; }
    /// Whether any of `runs` can train the process of an observable: it has no effects on grains, a
    /// value of the observable, and a stiffness number within a factor 2 of
    /// `emulated::reference_stiffness` or, where no run without effects has, of the first such run.
    static bool known(const std::vector<dem::RunResult>& runs, dem::Observable which);
    /// Fits the hyperparameters of one observable to the runs without effects
    /// (`fit_hyperparameters`).
    /// @throws std::invalid_argument where none of them has a training value of the observable
    static Hyperparameters learn(const std::vector<dem::RunResult>& runs, dem::Observable which,
                                 double stiffness_number = emulated::reference_stiffness);

  private:
    /// Hyperparameters of one observable, fitted at the first call where they are missing.
    Hyperparameters hyperparameters_of(dem::Observable which) const;
    /// Gaussian process that predicts an observable, trained at the first call.
    /// @throws std::invalid_argument where no training run has a value of the observable
    const GaussianProcess& process_of(dem::Observable which) const;
    /// Returns the Gaussian process that predicts an observable, trained on all usable runs without
    /// effects.
    std::unique_ptr<const GaussianProcess> trained(dem::Observable which) const;

    /// Gaussian processes and hyperparameters of the observables, each computed when it is first
    /// needed.
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
