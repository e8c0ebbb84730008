#pragma once

#include <Eigen/Core>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "calib/model/model.h"
#include "data/reading.h"

namespace pendular {

/// Measured values with their errors, stacked as in `Prediction`: shear stress [Pa] and solid
/// fraction [1] of each reading in turn, then direct measurements (of effects' parameters).
struct Measured {
    Eigen::VectorXd value;
    Eigen::MatrixXd covariance;  ///< covariance of `value`; the scatter of replicates as estimated
    /// Addition to `covariance` that widens standard errors, since few replicates (repeated
    /// measurements) determine the scatter; empty: none.
    Eigen::MatrixXd widening = {};
};
/// Stacks the values of readings and direct measurements with their covariance, which includes
/// errors that readings share.
Measured stack(const std::vector<Reading>& readings,
               const std::vector<DirectMeasurement>& direct = {});

/// Result of one weighted least-squares fit of a model's parameters to measured values.
struct Fit {
    Eigen::VectorXd parameters;  ///< fitted parameter values, in the order of Model::parameters()
    /// Covariance of the fitted parameters: (J' J)^-1, with the derivatives J of the predictions by
    /// the parameters, whitened by the covariance of measurement and simulation; not scaled by
    /// chi2/dof.
    Eigen::MatrixXd covariance;
    /// Addition to `covariance` that widens standard errors of parameters, from Measured::widening;
    /// empty: none.
    Eigen::MatrixXd widening;
    Eigen::MatrixXd measurement_part;  ///< part of `covariance` from errors of measurement
    /// Part of `covariance` that comes from the noise of the simulation runs; the rest, beside
    /// `measurement_part`, comes from corrections of the simulation.
    Eigen::MatrixXd run_part;
    double chi2 = 0;             ///< minimum of the sum of squared whitened residuals [1]
    int dof = 0;                 ///< number of measured values minus number of parameters
    bool converged = false;      ///< whether the search (in `calibrate`, the rounds) converged
    std::vector<bool> at_bound;  ///< for each parameter, whether it ended at an end of its range
    Prediction prediction;       ///< prediction of the measured values at the fitted parameters
    std::string message;         ///< how the fit ended: message of Ceres or of the fit

    /// Standard error of the parameter with index `k`, in its unit, widened where few replicates
    /// determine the scatter of the readings.
    double standard_error(Eigen::Index k) const;
    /// Part of the standard error of the parameter with index `k` that comes from the measurement,
    /// in its unit, widened like `standard_error`.
    double measurement_error(Eigen::Index k) const;
    /// Part of the standard error of the parameter with index `k` that comes from simulation, noise
    /// of the runs and corrections, in its unit.
    double simulation_error(Eigen::Index k) const;
};

/// Effort of a least-squares fit. The default reproduces certified regressions to ten digits; an
/// accuracy well within the errors of the readings needs much less.
struct FitEffort {
    int most_steps = 1000;     ///< largest number of steps of a search for the minimum of chi2
    double tolerance = 1e-14;  ///< relative change of chi2 at which a search ends
    /// Length of the last step of the parameters, in standard errors, over sqrt(chi2), at which the
    /// fit has converged [1].
    double settled = 1e-10;
    /// Whether to repeat the search from the same start with other solver settings where a
    /// parameter stays undetermined.
    bool elsewhere = true;
};

/// Fits a model's parameters theta to measured values y by weighted least squares with Ceres,
///     minimise r'r,  r = L^-1 (y - f(theta)),  L L' = Sigma_measurement + Sigma_simulation(start),
/// with the model's predictions f and their derivatives. Sigma_simulation is evaluated at `start`
/// and kept, so that the fit cannot reduce chi2 by a larger simulation error; repeat the fit from
/// its result until the result no longer changes. Where a search ends without determining a
/// parameter within its range, further searches with other settings begin at the same start, and
/// the lowest minimum is taken.
/// @throws std::logic_error where the sum of both covariances is not positive definite
Fit fit(const Model& model, const Measured& measured, const Eigen::VectorXd& start,
        const FitEffort& effort = {});

/// Profile-likelihood interval of the parameter with index `which`, in its unit: where chi2,
/// minimised over all other parameters, exceeds its minimum by at most `rise`; 1 gives the 68 %
/// interval. An end beyond the parameter's range, or the range that simulation supports, is
/// replaced by the end of that range.
std::pair<double, double> profile_interval(const Model& model, const Measured& measured,
                                           const Fit& best, Eigen::Index which, double rise = 1);

/// Values of a model's parameters where a fit starts (Parameter::start), in the order of
/// parameters().
Eigen::VectorXd start_of(const Model& model);

/// Criteria for the end of a calibration, which alternates simulations and fits in rounds.
struct CalibrationOptions {
    /// Largest part of a fitted parameter's variance that may come from the noise of the runs [1].
    double simulation_share = 0.2;
    double settled = 0.5;   ///< largest change of a parameter in the last round [standard errors]
    int fewest_rounds = 3;  ///< smallest number of rounds of simulations and fits
    int most_rounds = 8;    ///< largest number of rounds; 1: a single round
    /// Parameter values at the start of the first fit; empty: Parameter::start.
    std::optional<Eigen::VectorXd> start = {};
};

/// Callback after each round (simulations, then a fit) of a calibration, with the number of the
/// round, from 1, and its fit.
using CalibrationReport = std::function<void(int round, const Fit& fit)>;

/// Model that improves between fits: it requests simulations and is trained on them.
class LearningModel {
  public:
    virtual ~LearningModel() = default;

    /// Model trained on all runs simulated so far.
    virtual const Model& model() const = 0;
    /// Simulates more flow states for `parameters`, the result of a fit or the starting values, and
    /// trains the model on them. `excess` is the factor by which the variance that the noise of the
    /// runs causes in the fit is too large; above 1, the number of runs should grow by about this
    /// factor.
    virtual void improve(const Eigen::VectorXd& parameters, double excess) = 0;
    /// Whether the results of the last simulations agree with the model's predictions made before
    /// them.
    virtual bool confirmed() const { return true; }
};

/// Calibrates a model in rounds: each round simulates states near the last fit, trains the model on
/// them and fits its parameters again. The rounds end when the parameters no longer change, the
/// simulations confirm the model and the part of the parameters' variance from the noise of the
/// runs is small. Fit::converged is false where this does not happen within the allowed number of
/// rounds (if above 1), or a parameter is undetermined.
/// @return fit of the last round
Fit calibrate(LearningModel& learning, const Measured& measured, const CalibrationOptions& options,
              const CalibrationReport& report = {});

}  // namespace pendular
