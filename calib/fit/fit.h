#pragma once

#include <Eigen/Core>
#include <string>
#include <utility>
#include <vector>

#include "calib/model/model.h"
#include "data/reading.h"

namespace pendular {

/// Measured values with their errors: shear stress [Pa] and solid fraction [1] of each reading in
/// turn, followed by the direct measurements (of effects' parameters), each in its unit.
struct Measured {
    Eigen::VectorXd value;
    /// Covariance of the errors of the measured values, with the scatter of replicates (repeated
    /// measurements) as estimated.
    Eigen::MatrixXd covariance;
    /// Addition to `covariance` that widens standard errors because few replicates (repeated
    /// measurements) determine the scatter; empty: none.
    Eigen::MatrixXd widening = {};
};
/// Returns the values of readings, followed by direct measurements, with their covariance. The
/// covariance includes errors that several readings share, such as that of a filling.
Measured stack(const std::vector<Reading>& readings,
               const std::vector<DirectMeasurement>& direct = {});

/// Result of one weighted least-squares fit of a model's parameters to measured values.
struct Fit {
    Eigen::VectorXd parameters;  ///< fitted parameter values, in the order of Model::parameters()
    /// Covariance (J' J)^-1 of the fitted parameters, not scaled by chi2/dof (dof: degrees of
    /// freedom). J: derivatives of the predictions with respect to the parameters, whitened
    /// (divided by the Cholesky factor of the covariance of measurement and simulation).
    Eigen::MatrixXd covariance;
    /// Addition to `covariance` that widens the standard errors of the parameters because few
    /// replicates determine the scatter of the readings (Measured::widening); empty: none.
    Eigen::MatrixXd widening;
    /// Part of the parameters' `covariance` that comes from errors of measurement.
    Eigen::MatrixXd measurement_part;
    /// Part of `covariance` that comes from the noise of the simulation runs. The part of
    /// `covariance` beyond `measurement_part` and `run_part` comes from errors of corrections of
    /// the simulation.
    Eigen::MatrixXd run_part;
    double chi2 = 0;  ///< minimum of chi2, the sum of squared whitened residuals [1]
    /// Degrees of freedom of the fit: number of measured values minus number of parameters.
    int dof = 0;
    /// Whether the search for the minimum of chi2 (or, in `calibrate`, the rounds of simulations
    /// and fits) converged.
    bool converged = false;
    std::vector<bool> at_bound;  ///< for each parameter, whether it ended at an end of its range
    Prediction prediction;       ///< prediction of the measured values at the fitted parameters
    /// How the fit ended, in the words of the solver Ceres or of this program.
    std::string message;

    /// Standard error of the parameter with index `k`, in its unit. It is widened (`widening`) if
    /// few replicates (repeated readings) determine the scatter of the readings.
    double standard_error(Eigen::Index k) const;
    /// Standard errors of all parameters, each in its unit. They are widened (`widening`) if few
    /// replicates (repeated readings) determine the scatter of the readings.
    Eigen::VectorXd standard_errors() const;
    /// Part of the standard error of the parameter with index `k` that comes from errors of
    /// measurement, in its unit. It is widened (`widening`) if few replicates (repeated readings)
    /// determine the scatter of the readings.
    double measurement_error(Eigen::Index k) const;
    /// Part of the standard error of the parameter with index `k` that comes from the simulation
    /// (noise of the runs and errors of corrections), in its unit.
    double simulation_error(Eigen::Index k) const;
};

/// Accuracy and limits of the search of a least-squares fit. The defaults reproduce certified
/// regressions to ten digits; an accuracy well within the errors of the readings needs much less.
struct FitEffort {
    /// Largest number of steps of one search for the minimum of chi2.
    int most_steps = 1000;
    /// Relative change of chi2 in one step at which a search ends [1].
    double tolerance = 1e-14;
    /// The fit has converged when the last step of the parameters, in standard errors, is at most
    /// this number times sqrt(chi2) [1].
    double settled = 1e-10;
    /// Whether to repeat the search from the same start with other settings of the solver if the
    /// search leaves a parameter undetermined.
    bool elsewhere = true;
};

/// Fits a model's parameters theta to measured values y by weighted least squares with Ceres,
///     minimise r'r,  r = L^-1 (y - f(theta)),  L L' = Sigma_measurement + Sigma_simulation(start),
/// with the model's predictions f and the covariances Sigma of measurement and simulation.
/// Sigma_simulation is evaluated at `start` and kept constant, so that the fit cannot reduce chi2
/// by a larger simulation error; repeat the fit from its result until the result no longer changes.
/// If a search does not determine a parameter within its range, further searches with other
/// settings begin at the same start, and the lowest minimum is returned.
/// @param start starting values, in the order and units of the parameters
/// @throws std::logic_error if the sum of both covariances is not positive definite
/// @throws std::domain_error if the readings are impossible at `start`: no true state of the cell
///         gives the condition that the instrument shows
Fit fit(const Model& model, const Measured& measured, const Eigen::VectorXd& start,
        const FitEffort& effort = {});

/// Returns the parameters of the model, in their units, that minimise chi2 = r'r with r = L^-1 (y -
/// f(theta)): measured values y, predictions f at parameters theta, and L L' = `covariance`. Faster
/// than `fit`, but does not compute errors of the parameters.
/// @param covariance covariance of measured minus predicted values, in the squared units of the
///        values
/// @param start starting values, in the order and units of the parameters
/// @throws std::logic_error if `covariance` is not positive definite
Eigen::VectorXd best_parameters(const Model& model, const Measured& measured,
                                const Eigen::MatrixXd& covariance, const Eigen::VectorXd& start,
                                const FitEffort& effort);

/// Profile-likelihood interval of one parameter, in its unit: the values at which chi2, minimised
/// over all other parameters, exceeds its minimum by at most `rise` [1]; 1 gives the 68 % interval.
/// The interval is cut off at the end of the parameter's range and at the end of the range that
/// simulation supports.
/// @param best fit of the model, whose covariance of the predictions is used
/// @param which index of the parameter
std::pair<double, double> profile_interval(const Model& model, const Measured& measured,
                                           const Fit& best, Eigen::Index which, double rise = 1);
/// Profile likelihood of one parameter: for each of `values` [unit of the parameter], the rise of
/// chi2 above its minimum [1] when the parameter has this value and all other parameters minimise
/// chi2 within their ranges. The rise is infinite if no true state of the cell gives the conditions
/// that the instrument shows.
/// @param best fit of the model, whose covariance of the predictions is used
/// @param which index of the parameter
Eigen::VectorXd profile_rise(const Model& model, const Measured& measured, const Fit& best,
                             Eigen::Index which, const Eigen::VectorXd& values);

/// Starting values of a fit (Parameter::start), in the order of the model's parameters.
Eigen::VectorXd start_of(const Model& model);

}  // namespace pendular
