#pragma once

#include <Eigen/Core>
#include <functional>
#include <optional>

#include "calib/fit/fit.h"
#include "calib/fit/stopping_rule.h"
#include "calib/model/model.h"

namespace pendular {

/// Criteria for the end of a calibration, which alternates simulations and fits in rounds.
struct CalibrationOptions {
    /// Limit of `enlargement_by_runs` [1]: the noise of the simulations may enlarge the standard
    /// error of each parameter and of each predicted reading at most by this factor.
    double largest_enlargement = pendular::largest_enlargement;
    double settled = 0.5;   ///< largest change of a parameter in the last round [standard errors]
    int fewest_rounds = 3;  ///< smallest number of rounds of simulations and fits
    int most_rounds = 8;    ///< largest number of rounds; 1: a single round
    /// Parameter values at the start of the first fit; empty: Parameter::start.
    std::optional<Eigen::VectorXd> start = {};
};

/// Callback after each round (simulations, then a fit) of a calibration, with the number of the
/// round, from 1, and its fit.
using CalibrationReport = std::function<void(int round, const Fit& fit)>;

/// Model that improves between fits: it requests simulations and is trained on them.
class LearningModel {
  public:
    virtual ~LearningModel() = default;

    /// Model trained on all runs simulated so far.
    virtual const Model& model() const = 0;
    /// Simulates more flow states for `parameters`, the result of a fit or the starting values, and
    /// trains the model on them. `excess` is the variance that the noise of the runs causes in the
    /// fit, over the largest acceptable variance [1]; above 1, the number of runs should grow by
    /// about this factor.
    virtual void improve(const Eigen::VectorXd& parameters, double excess) = 0;
    /// Whether the results of the last simulations agree with the model's predictions made before
    /// them.
    virtual bool confirmed() const { return true; }
    /// Whether the time for simulations has ended, so that `improve` changes nothing more.
    virtual bool exhausted() const { return false; }
};

/// Calibrates a model in rounds: each round simulates states near the last fit, trains the model on
/// them and fits its parameters again. The rounds end when the parameters no longer change, the
/// simulations confirm the model and their noise enlarges no error by more than
/// `CalibrationOptions::largest_enlargement`, or when the time for simulations has ended.
/// Fit::converged is false where neither happens within the allowed number of rounds (if above 1),
/// or a parameter is undetermined.
/// @return fit of the last round
Fit calibrate(LearningModel& learning, const Measured& measured, const CalibrationOptions& options,
              const CalibrationReport& report = {});

}  // namespace pendular
