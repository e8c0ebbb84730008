#pragma once

#include <Eigen/Core>
#include <functional>
#include <optional>

#include "calib/fit/fit.h"
#include "calib/fit/stopping_rule.h"
#include "calib/model/model.h"

namespace pendular {

/// Stopping criteria and starting values of a calibration. A calibration proceeds in rounds, each
/// of which consists of simulations followed by a fit.
struct CalibrationOptions {
    /// Largest relative increase [1] of the standard error of a parameter or of a predicted reading
    /// that the noise of the simulations may cause (0.2: 20 %). The function `enlargement_by_runs`
    /// computes the increase.
    double largest_enlargement = pendular::largest_enlargement;
    /// Largest change of a fitted parameter from one round to the next, in standard errors of the
    /// parameter [1], at which the parameter counts as no longer changing.
    double settled = 0.5;
    /// Smallest number of rounds of simulations and fits in a calibration. If the time for
    /// simulations ends, a calibration may have fewer rounds.
    int fewest_rounds = 3;
    /// Largest number of rounds of simulations and fits in a calibration.
    int most_rounds = 8;
    /// Parameter values at the start of the first fit, in the order of the model's parameters. If
    /// empty, the first fit starts from the values Parameter::start.
    std::optional<Eigen::VectorXd> start = {};
};

/// Function that is called after each round (simulations followed by a fit) of a calibration, to
/// report progress. The arguments are the number of the round, from 1, and the fit of the round.
using CalibrationReport = std::function<void(int round, const Fit& fit)>;

/// Model whose emulator (interpolation between simulation runs) is trained on more runs between the
/// fits of a calibration. The function `improve` makes the runs and trains the emulator.
class LearningModel {
  public:
    virtual ~LearningModel() = default;

    /// Returns the model, whose emulator is trained on all runs simulated so far.
    virtual const Model& model() const = 0;
    /// Makes more simulation runs of steady shear and trains the emulator of the model on the runs.
    /// @param parameters parameter values near which predictions are to improve: the result of the
    ///        last fit or, before any fit, the starting values
    /// @param excess variance of a parameter or predicted reading that the noise of the runs causes
    ///        in the last fit, divided by the largest acceptable variance [1]
    ///        (`Enlargement::excess`); above 1, the number of runs should grow by about the factor
    ///        `excess`
    virtual void improve(const Eigen::VectorXd& parameters, double excess) = 0;
    /// Whether the simulation runs of the last call of `improve` agree with the predictions that
    /// the model made before being trained on the runs.
    virtual bool confirmed() const { return true; }
    /// Whether the time for simulations has ended, so that `improve` changes nothing more.
    virtual bool exhausted() const { return false; }
};

/// Calibrates a model in rounds and returns the fit of the last round. Each round simulates states
/// of steady shear near the fitted parameters of the last round, trains the emulator of the model
/// on the runs and fits the parameters again.
///
/// After at least `CalibrationOptions::fewest_rounds` rounds, the calibration ends if the
/// parameters no longer change, the runs agree with the predictions of the model, and the noise of
/// the runs enlarges no standard error by more than `CalibrationOptions::largest_enlargement`. The
/// calibration also ends if a fit after the smallest number of rounds does not converge, or if the
/// time for simulations ends. Otherwise the calibration ends after
/// `CalibrationOptions::most_rounds` rounds, and `Fit::converged` is false unless only one round
/// was allowed.
/// @param report function that is called after each round; may be empty
/// @throws std::logic_error if the covariance of the readings is not positive definite
Fit calibrate(LearningModel& learning, const Measured& measured, const CalibrationOptions& options,
              const CalibrationReport& report = {});

}  // namespace pendular
