#pragma once

#include <Eigen/Core>
#include <string>
#include <utility>
#include <vector>

#include "calib/model/model.h"
#include "data/reading.h"

namespace pendular {

/// Measured values with the covariance of their errors. First come the shear stress [Pa] and solid
/// fraction [1] of each reading in turn, then the direct measurements of effects' parameters, each
/// in the unit of the parameter.
struct Measured {
    Eigen::VectorXd value;
    /// Covariance of the errors of the measured values. The covariance contains the estimated
    /// scatter of replicates (repeated measurements), as if the estimate were exact.
    Eigen::MatrixXd covariance;
    /// Addition to `covariance` that widens the standard errors if few replicates (repeated
    /// measurements) determine the scatter. If empty, nothing is added.
    Eigen::MatrixXd widening = {};
};
/// Returns the values of readings, followed by direct measurements of effects' parameters, with the
/// covariance of the errors of all values. The covariance includes errors that several readings
/// share, such as the error of a filling of the cell.
Measured stack(const std::vector<Reading>& readings,
               const std::vector<DirectMeasurement>& direct = {});

/// Result of one weighted least-squares fit of a model's parameters to measured values.
struct Fit {
    /// Fitted parameter values, in the order of Model::parameters().
    Eigen::VectorXd parameters;
    /// Covariance (J' J)^-1 of the fitted parameters, not scaled by chi2/dof, where dof is the
    /// number of degrees of freedom. J contains the derivatives of the predictions with respect to
    /// the parameters, whitened (multiplied by the inverse Cholesky factor of the covariance of
    /// measurement and simulation).
    Eigen::MatrixXd covariance;
    /// Addition to the `covariance` of the parameters that widens the standard errors if few
    /// replicates (repeated readings) determine the scatter of the readings (Measured::widening).
    /// If empty, nothing is added.
    Eigen::MatrixXd widening;
    /// Contribution of the errors of measurement to the `covariance` of the parameters.
    Eigen::MatrixXd measurement_part;
    /// Contribution of the noise of the simulation runs to the `covariance` of the parameters.
    /// `covariance` minus `measurement_part` and minus `run_part` is the contribution of the errors
    /// of corrections of the simulation (such as the correction to the stiffness of the grains), of
    /// the model discrepancy that the study states, and of constant cohesions fitted to wet
    /// readings.
    Eigen::MatrixXd run_part;
    /// Minimum of chi2 [1], the sum of the squared whitened residuals.
    double chi2 = 0;
    /// Number of degrees of freedom of the fit: number of measured values minus number of
    /// parameters.
    int dof = 0;
    /// Whether the search for the minimum of chi2 converged. The value is false if a parameter has
    /// no influence on the predictions. In the result of `calibrate`, the value also states whether
    /// the rounds of simulations and fits converged.
    bool converged = false;
    /// For each parameter, whether the fitted value is at an end of the parameter's range or of the
    /// range that simulations support.
    std::vector<bool> at_bound;
    /// Range within which each parameter was fitted: its own range, or the range that simulations
    /// support where that is narrower. Empty for a fit that an earlier version wrote.
    ParameterBounds range = {};
    /// Prediction of the measured values at the fitted parameters, with derivatives and covariance.
    Prediction prediction;
    /// Message of the solver Ceres or of Pendular that says why the fit stopped.
    std::string message;

    /// Returns the standard error of the parameter with index `k`, in the unit of the parameter.
    /// The standard error is widened (`widening`) if few replicates (repeated readings) determine
    /// the scatter of the readings.
    double standard_error(Eigen::Index k) const;
    /// Returns the width of the range of the parameter with index `k`, in the unit of the
    /// parameter; infinity if the range is unknown.
    double width(Eigen::Index k) const;
    /// Whether the readings determine the parameter with index `k`: its standard error is smaller
    /// than the width of its range.
    bool determines(Eigen::Index k) const { return standard_error(k) < width(k); }
    /// Returns the standard errors of all parameters, each in the unit of the parameter. The
    /// standard errors are widened (`widening`) if few replicates (repeated readings) determine the
    /// scatter of the readings.
    Eigen::VectorXd standard_errors() const;
    /// Returns the contribution of errors of measurement to the standard error of the parameter
    /// with index `k`, in the unit of the parameter. The contribution is widened (`widening`) if
    /// few replicates (repeated readings) determine the scatter of the readings.
    double measurement_error(Eigen::Index k) const;
    /// Returns the contribution of the simulation to the standard error of the parameter with index
    /// `k`, in the unit of the parameter. The contribution comes from the noise of the runs, from
    /// errors of corrections of the simulation, from the model discrepancy that the study states,
    /// and from constant cohesions fitted to wet readings.
    double simulation_error(Eigen::Index k) const;
};

/// Accuracy and limits of the search for the minimum of chi2 in a least-squares fit. With the
/// default values, fits reproduce certified regression results to ten digits. Much less effort
/// suffices if the errors of the fit need only be far below the errors of the readings.
struct FitEffort {
    /// Largest number of steps of one search for the minimum of chi2.
    int most_steps = 1000;
    /// Relative change of chi2 in one step [1] at or below which a search ends.
    double tolerance = 1e-14;
    /// Convergence limit [1] of a fit: the fit has converged when the length of the last step, in
    /// standard errors of the parameters, is at most `settled` times sqrt(chi2).
    double settled = 1e-10;
    /// Whether to repeat the search from the start with other settings of the solver if the search
    /// leaves a parameter undetermined. If false, the solver also spends less effort on each step
    /// at the bounds of the parameters.
    bool elsewhere = true;
};

/// Fits a model's parameters theta to measured values y by weighted least squares,
///     minimise r'r,  r = L^-1 (y - f(theta)),  L L' = Sigma_measurement + Sigma_simulation,
/// with the predictions f of the model and the covariances Sigma of measurement and simulation.
///
/// Sigma_simulation depends on the parameters, but is constant in each search: that of the result
/// before, until the result stays the same. The fitted parameters thus solve
///     J' (Sigma_measurement + Sigma_simulation(theta))^-1 (y - f(theta)) = 0,
/// whose expectation is 0 at the true parameters whatever the covariances, so that a model is drawn
/// neither to states that the simulations know badly (as where chi2 is minimised with Sigma(theta))
/// nor away from these (ln det Sigma added to chi2 rewards large errors where the model misfits).
/// Source: iteratively reweighted least squares, Carroll and Ruppert, Transformation and Weighting
/// in Regression (1988), section 2.1.
///
/// If a search leaves a parameter undetermined, the function searches again with other settings and
/// returns the lowest minimum.
/// @param start starting values, in the order and units of the parameters
/// @throws std::logic_error if the sum of both covariances is not positive definite
/// @throws std::domain_error if a measured condition is impossible with the parameters `start`: no
///         actual state of the cell would make the instrument show the condition
Fit fit(const Model& model, const Measured& measured, const Eigen::VectorXd& start,
        const FitEffort& effort = {});

/// Returns the parameters theta of the model, in their units, that minimise chi2 = r'r with r =
/// L^-1 (y - f(theta)) and L L' = `covariance`. Here y contains the measured values and f the
/// predictions. The function is faster than `fit`, but computes no standard errors.
/// @param covariance covariance of measured minus predicted values, in the squared units of the
///        values
/// @param start starting values, in the order and units of the parameters
/// @throws std::logic_error if `covariance` is not positive definite
Eigen::VectorXd best_parameters(const Model& model, const Measured& measured,
                                const Eigen::MatrixXd& covariance, const Eigen::VectorXd& start,
                                const FitEffort& effort);

/// Returns the lower and the upper end of the profile-likelihood interval of one parameter, in the
/// unit of the parameter. In the interval, chi2 minimised over all other parameters exceeds the
/// minimum of chi2 by at most `rise` [1]. A rise of 1 gives the 68 % interval. The interval ends at
/// the latest at the ends of the parameter's range and of the range that simulation supports.
/// @param best fit of the model, with the covariance of the predictions
/// @param which index of the parameter
std::pair<double, double> profile_interval(const Model& model, const Measured& measured,
                                           const Fit& best, Eigen::Index which, double rise = 1);
/// Returns the profile likelihood of one parameter: for each of `values` [unit of the parameter],
/// the rise of chi2 above the minimum of chi2 [1]. The parameter is held at the value, and all
/// other parameters minimise chi2 within their ranges. The rise is infinite if no true state of the
/// cell gives the conditions that the instrument shows.
/// @param best fit of the model, with the covariance of the predictions
/// @param which index of the parameter
Eigen::VectorXd profile_rise(const Model& model, const Measured& measured, const Fit& best,
                             Eigen::Index which, const Eigen::VectorXd& values);

/// Returns the starting values of a fit (Parameter::start), in the order of the model's parameters.
Eigen::VectorXd start_of(const Model& model);

}  // namespace pendular
