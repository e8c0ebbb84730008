#pragma once

#include <Eigen/Core>
#include <functional>
#include <optional>

#include "calib/fit/fit.h"
#include "calib/fit/stopping_rule.h"
#include "calib/model/model.h"

namespace pendular {

/// Stopping criteria and start of a calibration, which proceeds in rounds of simulations and a fit.
struct CalibrationOptions {
    /// Largest relative increase [1] of the standard error of a parameter or of a predicted reading
    /// by the noise of the simulations (`enlargement_by_runs`).
    double largest_enlargement = pendular::largest_enlargement;
    /// Largest change of a parameter from one round to the next, in its standard errors [1], at
    /// which it counts as no longer changing.
    double settled = 0.5;
    int fewest_rounds = 3;  ///< fewer if the time for simulations ends
    int most_rounds = 8;
    /// Parameter values at the start of the first fit; if empty, Parameter::start.
    std::optional<Eigen::VectorXd> start = {};
};

/// Called after each round of a calibration, with the number of the round, from 1, and its fit.
using CalibrationReport = std::function<void(int round, const Fit& fit)>;

/// Model whose emulator is trained on more runs between the fits of a calibration.
class LearningModel {
  public:
    virtual ~LearningModel() = default;

    virtual const Model& model() const = 0;
    /// Makes more runs and trains the emulator of the model on them.
    /// @param parameters the result of the last fit or, before any fit, the starting values
    /// @param excess `Enlargement::excess` of the last fit [1]; above 1, the number of runs should
    ///        grow by about this factor
    virtual void improve(const Eigen::VectorXd& parameters, double excess) = 0;
    /// Whether the last runs agree with the predictions before the training on them.
    virtual bool confirmed() const { return true; }
    /// Whether the time for simulations has ended, so that `improve` changes nothing more.
    virtual bool exhausted() const { return false; }
};

/// Calibrates a model in rounds and returns the fit of the last one. Each round improves the model
/// near the fitted parameters of the last round and fits the parameters again.
///
/// After at least `CalibrationOptions::fewest_rounds` rounds, the calibration ends if the
/// parameters no longer change, the runs agree with the predictions of the model, and the noise of
/// the runs enlarges no standard error by more than `CalibrationOptions::largest_enlargement`. It
/// also ends if a fit after the smallest number of rounds does not converge, or if the time for
/// simulations ends. Otherwise it ends after `CalibrationOptions::most_rounds` rounds, and
/// `Fit::converged` is false unless only one round was allowed.
/// @throws std::logic_error if the covariance of the readings is not positive definite
Fit calibrate(LearningModel& learning, const Measured& measured, const CalibrationOptions& options,
              const CalibrationReport& report = {});

}  // namespace pendular
