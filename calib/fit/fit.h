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

/// Readings stacked as the model predicts them: shear stress [Pa] and solid fraction [1] in turn,
/// then direct measurements.
struct Measured {
    Eigen::VectorXd value;
    Eigen::MatrixXd covariance;  ///< covariance with the scatter of replicates as estimated
    /// Widening of the covariance of the readings for standard errors, since few replicates
    /// determine the scatter; empty: none.
    Eigen::MatrixXd widening = {};
};
Measured stack(const std::vector<Reading>& readings,
               const std::vector<DirectMeasurement>& direct = {});

/// Result of one least-squares fit.
struct Fit {
    Eigen::VectorXd parameters;
    /// Covariance of the parameters, (J' J)^-1 of the whitened derivatives; not scaled by chi2/dof.
    Eigen::MatrixXd covariance;
    Eigen::MatrixXd
        widening;  ///< widening of `covariance` for standard errors: see Measured::widening
    Eigen::MatrixXd measurement_part;  ///< part of `covariance` that comes from the measurement
    Eigen::MatrixXd
        run_part;  ///< part that comes from the noise of the runs; the rest comes from corrections
    double chi2 = 0;
    int dof = 0;
    bool converged = false;
    std::vector<bool> at_bound;  ///< for each parameter, whether it ended at a bound
    Prediction prediction;       ///< prediction at the fitted parameters
    std::string message;         ///< message of Ceres

    /// Standard error of a parameter, in its unit, widened where few replicates determine the
    /// scatter.
    double standard_error(Eigen::Index k) const;
    double measurement_error(Eigen::Index k) const;
    double simulation_error(Eigen::Index k) const;
};

/// Effort of a fit. The default reproduces certified regressions to ten digits; where the errors of
/// the readings are all that counts, much less will do.
struct FitEffort {
    int most_steps = 1000;
    double tolerance = 1e-14;  ///< relative change of chi2 at which a search ends
    double settled = 1e-10;    ///< last step in standard errors, over the root of chi2
    bool elsewhere =
        true;  ///< whether to search from other starts where a parameter stays undetermined
};

/// Weighted least squares of a model's predictions to the readings by Ceres,
///     minimise r'r,  r = L^-1 (y - f(theta)),  L L' = Sigma_measurement + Sigma_simulation(start),
/// with the model's own derivatives. The weights are those at the start, so that the noise of the
/// simulation cannot be traded for misfit; repeat from the answer until it stays. Where a search
/// ends without determining a parameter within its range, others start from the same place, and the
/// lowest minimum counts.
Fit fit(const Model& model, const Measured& measured, const Eigen::VectorXd& start,
        const FitEffort& effort = {});

/// Interval of one parameter within which chi2, minimised over the others, stays within `rise` of
/// its minimum; 1 gives the 68 % interval. An end beyond the supported range is reported there.
std::pair<double, double> profile_interval(const Model& model, const Measured& measured,
                                           const Fit& best, Eigen::Index which, double rise = 1);

/// Starting values of a model's parameters.
Eigen::VectorXd start_of(const Model& model);

/// Criteria for the end of a calibration.
struct CalibrationOptions {
    double simulation_share =
        0.2;  ///< largest share of a parameter's variance from the noise of the runs [1]
    double settled = 0.5;  ///< largest last move, in standard errors
    int fewest_rounds = 3;
    int most_rounds = 8;  ///< largest number of rounds; 1: one fit without fresh runs
    std::optional<Eigen::VectorXd> start = {};  ///< starting values; empty: those of the parameters
};

/// Callback after each round, with the fit so far.
using CalibrationReport = std::function<void(int round, const Fit& fit)>;

/// Model that orders simulations and is trained on them between fits.
class LearningModel {
  public:
    virtual ~LearningModel() = default;

    /// Model with all runs that were simulated so far.
    virtual const Model& model() const = 0;
    /// Simulates more states near `parameters`, where a fit has arrived, and trains on them.
    /// `excess` is the factor by which the variance that simulation causes in the fit is too large:
    /// above 1, about so many times the work done so far is wanted.
    virtual void improve(const Eigen::VectorXd& parameters, double excess) = 0;
    /// Whether the last simulations agree with the predictions made before them.
    virtual bool confirmed() const { return true; }
};

/// Fits, trains the model on simulations near the fit, and fits again, until the parameters no
/// longer move, the simulations confirm the model and the simulation's share of their variance is
/// small. `converged` is false when the rounds run out first.
Fit calibrate(LearningModel& learning, const Measured& measured, const CalibrationOptions& options,
              const CalibrationReport& report = {});

}  // namespace pendular
