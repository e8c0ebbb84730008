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
    Eigen::MatrixXd covariance;  ///< with the scatter of replicates as it was estimated
    /// Widening of the covariance of the readings for standard errors, since few replicates
    /// determine the scatter; empty: none.
    Eigen::MatrixXd widening = {};
};
Measured stack(const std::vector<Reading>& readings,
               const std::vector<DirectMeasurement>& direct = {});

/// Outcome of one least-squares fit.
struct Fit {
    Eigen::VectorXd parameters;
    /// Covariance of the parameters, (J' J)^-1 of the whitened derivatives; not scaled by chi2/dof.
    Eigen::MatrixXd covariance;
    Eigen::MatrixXd widening;  ///< of the parameters, beyond `covariance`: see Measured::widening
    Eigen::MatrixXd measurement_part;  ///< what of it the measurement alone causes
    Eigen::MatrixXd run_part;  ///< what of it the runs' noise causes; the rest are corrections
    double chi2 = 0;
    int dof = 0;
    bool converged = false;
    std::vector<bool> at_bound;  ///< per parameter: it ended at a bound of its range
    Prediction prediction;       ///< at the parameters
    std::string message;         ///< what Ceres said

    /// Standard error of a parameter, in its unit, widened where few replicates determine the
    /// scatter.
    double standard_error(Eigen::Index k) const;
    double measurement_error(Eigen::Index k) const;
    double simulation_error(Eigen::Index k) const;
};

/// How far a fit goes. Its standard reproduces certified regressions to ten digits; where the
/// errors of the readings are all that counts, much less will do.
struct FitEffort {
    int most_steps = 1000;
    double tolerance = 1e-14;  ///< relative change of chi2 at which a search ends
    double settled = 1e-10;    ///< last step in standard errors, over the root of chi2
    bool elsewhere = true;     ///< whether to search otherwise where a parameter stays undetermined
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

/// The start of every parameter of a model.
Eigen::VectorXd start_of(const Model& model);

/// When a calibration is good enough, and when it gives up.
struct CalibrationOptions {
    double simulation_share = 0.2;  ///< of a parameter's variance that noise of the runs may cause
    double settled = 0.5;           ///< largest last move, in standard errors
    int fewest_rounds = 3;
    int most_rounds = 8;                        ///< 1: the first fit stands
    std::optional<Eigen::VectorXd> start = {};  ///< none: each parameter's own
};

/// Called after each round with the fit so far.
using CalibrationReport = std::function<void(int round, const Fit& fit)>;

/// A model that learns from runs of its own, and is another one afterwards.
class LearningModel {
  public:
    virtual ~LearningModel() = default;

    /// Model with all runs that were simulated so far.
    virtual const Model& model() const = 0;
    /// Learns more about the neighbourhood of `parameters`, where a fit has arrived. `excess` is
    /// the factor by which the variance that simulation causes in the fit is too large: above 1,
    /// about so many times the work done so far is wanted.
    virtual void improve(const Eigen::VectorXd& parameters, double excess) = 0;
    /// Whether what it learned last agrees with what it had said before.
    virtual bool confirmed() const { return true; }
};

/// Fits, lets the model learn where the fit has arrived, and fits again, until the parameters stay
/// where they are, what the model learns confirms it and the simulation's share of their variance
/// is small. `converged` is false when the rounds run out first.
Fit calibrate(LearningModel& learning, const Measured& measured, const CalibrationOptions& options,
              const CalibrationReport& report = {});

}  // namespace pendular
