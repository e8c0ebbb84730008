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

/// Measured values, stacked as in `Prediction`: shear stress [Pa] and solid fraction [1] of each
/// reading in turn, then direct measurements.
struct Measured {
    Eigen::VectorXd value;
    Eigen::MatrixXd covariance;  ///< covariance with the scatter of replicates as estimated
    /// Addition to `covariance` that widens standard errors, since few replicates determine the
    /// scatter; empty: none.
    Eigen::MatrixXd widening = {};
};
/// Stacks readings and direct measurements, with the errors that readings share.
Measured stack(const std::vector<Reading>& readings,
               const std::vector<DirectMeasurement>& direct = {});

/// Result of one least-squares fit.
struct Fit {
    Eigen::VectorXd parameters;  ///< fitted values, in the order of Model::parameters()
    /// Covariance of the parameters, (J' J)^-1 of the whitened derivatives; not scaled by chi2/dof.
    Eigen::MatrixXd covariance;
    /// Addition to `covariance` that widens standard errors: see Measured::widening.
    Eigen::MatrixXd widening;
    Eigen::MatrixXd measurement_part;  ///< part of `covariance` that comes from the measurement
    /// Part of `covariance` that comes from the noise of the runs; the rest, beside
    /// `measurement_part`, comes from corrections.
    Eigen::MatrixXd run_part;
    double chi2 = 0;             ///< minimum of the sum of squared whitened residuals
    int dof = 0;                 ///< number of measured values minus number of parameters
    bool converged = false;      ///< whether the search (in `calibrate`, the rounds) converged
    std::vector<bool> at_bound;  ///< for each parameter, whether it ended at a bound
    Prediction prediction;       ///< prediction at the fitted parameters
    std::string message;         ///< how the fit ended: message of Ceres or of the fit

    /// Standard error of a parameter, in its unit, widened where few replicates determine the
    /// scatter.
    double standard_error(Eigen::Index k) const;
    /// Part of a parameter's standard error that comes from the measurement, in its unit, widened
    /// like `standard_error`.
    double measurement_error(Eigen::Index k) const;
    /// Part of a parameter's standard error that comes from simulation, noise of the runs and
    /// corrections, in its unit.
    double simulation_error(Eigen::Index k) const;
};

/// Effort of a fit. The default reproduces certified regressions to ten digits; an accuracy well
/// within the errors of the readings needs much less.
struct FitEffort {
    int most_steps = 1000;     ///< largest number of steps of a search
    double tolerance = 1e-14;  ///< relative change of chi2 at which a search ends
    /// Length of the last step in standard errors over sqrt(chi2), at which the fit has converged.
    double settled = 1e-10;
    /// Whether to repeat the search with other settings where a parameter stays undetermined.
    bool elsewhere = true;
};

/// Fits a model's parameters to measured values by weighted least squares with Ceres,
///     minimise r'r,  r = L^-1 (y - f(theta)),  L L' = Sigma_measurement + Sigma_simulation(start),
/// with the model's own derivatives. Sigma_simulation is evaluated at the start and kept, so that
/// the fit cannot reduce chi2 by a larger simulation error; repeat the fit from its result until
/// the result no longer changes. Where a search ends without determining a parameter within its
/// range, further searches with other settings begin at the same start, and the lowest minimum is
/// taken.
Fit fit(const Model& model, const Measured& measured, const Eigen::VectorXd& start,
        const FitEffort& effort = {});

/// Profile-likelihood interval of one parameter, in its unit: where chi2, minimised over all other
/// parameters, exceeds its minimum by at most `rise`; 1 gives the 68 % interval. An end beyond the
/// supported range is replaced by the end of that range.
std::pair<double, double> profile_interval(const Model& model, const Measured& measured,
                                           const Fit& best, Eigen::Index which, double rise = 1);

/// Starting values of a model's parameters, in their order.
Eigen::VectorXd start_of(const Model& model);

/// Criteria for the end of a calibration.
struct CalibrationOptions {
    /// Largest part of a parameter's variance that may come from the noise of the runs [1].
    double simulation_share = 0.2;
    double settled = 0.5;   ///< largest change of a parameter in the last round [standard errors]
    int fewest_rounds = 3;  ///< smallest number of rounds of simulations and fits
    int most_rounds = 8;    ///< largest number of rounds; 1: a single round
    std::optional<Eigen::VectorXd> start = {};  ///< starting values; empty: Parameter::start
};

/// Callback after each round of a calibration, with the number of the round and its fit.
using CalibrationReport = std::function<void(int round, const Fit& fit)>;

/// Model that requests simulations between fits and is trained on them.
class LearningModel {
  public:
    virtual ~LearningModel() = default;

    /// Model trained on all runs simulated so far.
    virtual const Model& model() const = 0;
    /// Simulates more states near `parameters`, the result of a fit, and trains the model on them.
    /// `excess` is the factor by which the variance that simulation causes in the fit is too large;
    /// above 1, the number of runs should grow by about this factor.
    virtual void improve(const Eigen::VectorXd& parameters, double excess) = 0;
    /// Whether the last simulations agree with the predictions made before them.
    virtual bool confirmed() const { return true; }
};

/// Calibrates a model in rounds: each round simulates states near the last fit, trains the model on
/// them and fits again. The rounds end when the parameters no longer change, the simulations
/// confirm the model and the part of the parameters' variance from simulation is small. `converged`
/// is false where this does not happen within the allowed number of rounds, or a parameter is
/// undetermined.
Fit calibrate(LearningModel& learning, const Measured& measured, const CalibrationOptions& options,
              const CalibrationReport& report = {});

}  // namespace pendular
