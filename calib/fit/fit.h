#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "calib/fit/least_squares.h"
#include "calib/model/model.h"

namespace pendular {

/// Contribution of an error that all readings share, such as that of a torque gain, to the errors
/// of fitted parameters.
struct InstrumentError {
    std::string name;        ///< `SharedUncertainty::name`
    double standard = 0;     ///< standard uncertainty [`unit`]
    std::string unit = "1";  ///< SI unit; "1": relative
    bool assumed = false;    ///< typical of a class of instruments rather than stated
    bool counts = true;      ///< whether the fit's covariance contains it
    /// Change of each parameter, in its unit, by an error of one standard uncertainty.
    Eigen::VectorXd shift = {};
    double needed = 0;  ///< most likely error by the readings [standard uncertainties]
    /// Names of the errors, and of effects of the instrument without a budget, that change the
    /// fitted readings in nearly the same way: bead_mass and height-offset, for example.
    std::vector<std::string> alike = {};
};

/// Result of one weighted least-squares fit of a model's parameters to measured values.
struct Fit {
    Eigen::VectorXd parameters;  ///< in the order of Model::parameters()
    /// Covariance (J' J)^-1 of the parameters, not scaled by chi2/dof. J contains the derivatives
    /// of the predictions with respect to the parameters, whitened (multiplied by the inverse
    /// Cholesky factor of the covariance of measurement and prediction).
    Eigen::MatrixXd covariance;
    /// Addition to `covariance` that follows from Measured::widening; may be empty.
    Eigen::MatrixXd widening;
    Eigen::MatrixXd measurement_part;  ///< part due to errors of measurement
    /// Part due to the noise of the simulation runs. The rest of `covariance` is due to corrections
    /// of the simulation (such as that to the stiffness of the grains), to fitted constant
    /// cohesions, to the model's discrepancy and to the errors of `instrument`.
    Eigen::MatrixXd run_part;
    Eigen::MatrixXd discrepancy_part;  ///< part due to the model's discrepancy; may be empty
    /// Factor [1] by which the model's discrepancy is larger than expected (`likely_inexactness`).
    /// The errors of the parameters contain it; `chi2` and the weights of the fit do not.
    double inexactness = 1;
    double chi2 = 0;  ///< minimum: sum of squared whitened residuals [1]
    int dof = 0;      ///< measured values minus parameters
    /// Whether the search for the minimum of chi2 converged. False if a parameter has no influence
    /// on the predictions. In the result of `calibrate`, also whether the rounds of simulations and
    /// fits converged.
    bool converged = false;
    /// Whether each parameter is at an end of its range or of the range that simulations support.
    std::vector<bool> at_bound;
    /// Range within which each parameter was fitted: its own range, or the range that simulations
    /// support where that is narrower. Empty for a fit that an earlier version wrote.
    ParameterBounds range = {};
    Prediction prediction;  ///< at the fitted parameters
    std::string message;    ///< why the fit stopped
    /// Contributions of the errors that all readings share (`add_instrument`).
    std::vector<InstrumentError> instrument = {};

    /// Returns `covariance` with `widening` and with what `inexactness` adds.
    Eigen::MatrixXd total_covariance() const;
    /// Returns the standard error of parameter `k` by total_covariance(), in its unit.
    double standard_error(Eigen::Index k) const;
    /// Returns the width of the range of parameter `k`, in its unit; infinity if unknown.
    double width(Eigen::Index k) const;
    /// Whether the readings determine parameter `k`: its standard error is smaller than its range.
    bool determines(Eigen::Index k) const { return standard_error(k) < width(k); }
    /// Whether the readings determine all parameters.
    bool determines_all() const;
    /// Returns standard_error() of all parameters, in their units.
    Eigen::VectorXd standard_errors() const;
    /// Returns the part of standard_error() due to errors of measurement, with `widening`.
    double measurement_error(Eigen::Index k) const;
    /// Returns the part of standard_error() due to the errors of `instrument` that count or, if
    /// `counts` is false, to those of the others in a fit that does not weigh them.
    double instrument_error(Eigen::Index k, bool counts = true) const;
    /// Returns the part of standard_error() due to the model's discrepancy.
    double discrepancy_error(Eigen::Index k) const;
    /// Returns the part of standard_error() that is left: noise of the simulations (`run_part`) and
    /// corrections of them.
    double simulation_error(Eigen::Index k) const;
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
/// @throws std::logic_error if the sum of both covariances is not positive definite
/// @throws std::domain_error if a measured condition is impossible with the parameters `start`: no
///         actual state of the cell would make the instrument show the condition
Fit fit(const Model& model, const Measured& measured, const Eigen::VectorXd& start,
        const FitEffort& effort = {});

/// Returns the parameters theta of the model, in their units, that minimise chi2 = r'r with r =
/// L^-1 (y - f(theta)) and L L' = `covariance`. Faster than `fit`, but without standard errors.
/// @param covariance covariance of measured minus predicted values
/// @throws std::logic_error if `covariance` is not positive definite
Eigen::VectorXd best_parameters(const Model& model, const Measured& measured,
                                const Eigen::MatrixXd& covariance, const Eigen::VectorXd& start,
                                const FitEffort& effort);

/// Returns Parameter::start of all parameters of the model.
Eigen::VectorXd start_of(const Model& model);

}  // namespace pendular
