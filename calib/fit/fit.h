#pragma once

#include <Eigen/Core>
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
    /// Standard errors of all parameters, each in its unit, as `standard_error` gives them.
    Eigen::VectorXd standard_errors() const;
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

/// Parameters of the model, in their units, that minimise chi2 = r'r, r = L^-1 (y - f(theta)), with
/// L L' = `covariance`, the covariance of the differences between readings and predictions in the
/// squares of the readings' units. Costs less than `fit` where no errors are needed.
/// @throws std::logic_error where `covariance` is not positive definite
Eigen::VectorXd best_parameters(const Model& model, const Measured& measured,
                                const Eigen::MatrixXd& covariance, const Eigen::VectorXd& start,
                                const FitEffort& effort);

/// Profile-likelihood interval of the parameter with index `which`, in its unit: where chi2,
/// minimised over all other parameters, exceeds its minimum by at most `rise`; 1 gives the 68 %
/// interval. An end beyond the parameter's range, or the range that simulation supports, is
/// replaced by the end of that range.
std::pair<double, double> profile_interval(const Model& model, const Measured& measured,
                                           const Fit& best, Eigen::Index which, double rise = 1);
/// Profile likelihood of the parameter with index `which`: rise of chi2 above its minimum [1] where
/// the parameter has each of `values` [its unit] and all other parameters minimise chi2 within
/// their ranges; infinite where the readings are impossible. The covariance is that of the fit
/// `best`, as in `profile_interval`.
Eigen::VectorXd profile_rise(const Model& model, const Measured& measured, const Fit& best,
                             Eigen::Index which, const Eigen::VectorXd& values);

/// Values of a model's parameters where a fit starts (Parameter::start), in the order of
/// parameters().
Eigen::VectorXd start_of(const Model& model);

}  // namespace pendular
