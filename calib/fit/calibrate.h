#pragma once

#include <Eigen/Core>
#include <functional>
#include <optional>

#include "calib/fit/fit.h"
#include "calib/fit/stopping_rule.h"
#include "calib/model/model.h"

namespace pendular {

/// Criteria that end a calibration, which alternates simulations and fits in rounds.
struct CalibrationOptions {
    /// Largest relative increase [1] of the standard error of a parameter or of a predicted reading
    /// that the noise of the simulations may cause (0.2: 20 %); see `enlargement_by_runs`.
    double largest_enlargement = pendular::largest_enlargement;
    /// Largest change of a fitted parameter in the last round with which a calibration may end
    /// [standard errors of the parameter].
    double settled = 0.5;
    /// Smallest number of rounds of simulations and fits in a calibration.
    int fewest_rounds = 3;
    /// Largest number of rounds of simulations and fits in a calibration.
    int most_rounds = 8;
    /// Parameter values at the start of the first fit, in the order of the model's parameters;
    /// empty: Parameter::start.
    std::optional<Eigen::VectorXd> start = {};
};

/// Function that is called after each round (simulations, then a fit) of a calibration, with the
/// number of the round, from 1, and the fit of the round.
using CalibrationReport = std::function<void(int round, const Fit& fit)>;

/// Model that is improved between fits: it requests simulation runs and is trained on them.
class LearningModel {
  public:
    virtual ~LearningModel() = default;

    /// Model trained on all runs simulated so far.
    virtual const Model& model() const = 0;
    /// Simulates more states of steady shear and trains the model on the runs.
    /// @param parameters parameter values at which the new runs are to improve predictions: the
    ///        result of the last fit or, before any fit, its starting values
    /// @param excess variance that the noise of the runs causes in the fit, divided by the largest
    ///        acceptable variance [1]; above 1, the number of runs should grow by about this factor
    virtual void improve(const Eigen::VectorXd& parameters, double excess) = 0;
    /// Whether the simulation runs of the last call of `improve` agree with the predictions that
    /// the model made before it was trained on them.
    virtual bool confirmed() const { return true; }
    /// Whether the time for simulations has ended, so that `improve` changes nothing more.
    virtual bool exhausted() const { return false; }
};

/// Calibrates a model in rounds and returns the fit of the last round. Each round simulates states
/// near the last fit, trains the model on the runs and fits its parameters again. The rounds end
/// when the parameters no longer change, the runs confirm the model and their noise enlarges no
/// standard error by more than `CalibrationOptions::largest_enlargement`. They also end when the
/// time for simulations has ended or, after `CalibrationOptions::fewest_rounds`, when a fit does
/// not converge. `Fit::converged` is false if a parameter is undetermined, and if more than one
/// round was allowed but the last one fulfilled none of these conditions.
/// @param report called after each round; may be empty
/// @throws std::logic_error if the covariance of the readings is not positive definite
Fit calibrate(LearningModel& learning, const Measured& measured, const CalibrationOptions& options,
              const CalibrationReport& report = {});

}  // namespace pendular
