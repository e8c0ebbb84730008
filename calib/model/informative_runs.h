#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <vector>

#include "calib/emulator/emulator.h"
#include "sim/runs/run_settings.h"

namespace pendular {

/// Whether a run at one state also represents the other: both have the same effects on grains, and
/// agree within 5 % in friction coefficient, inertial number, reduced pressure, bridge volume and
/// the parameter values of the effects. Stiffness numbers are not compared.
bool near(const FlowState& a, const FlowState& b);

/// Task for `most_informative`.
struct RunChoice {
    /// States whose predicted stress ratios and solid fractions are to become more precise.
    std::vector<FlowState> targets;
    /// Weights of the variances [1]: for each target in turn, of stress ratio and solid fraction.
    Eigen::VectorXd weights;
    std::vector<FlowState> from;  ///< states at which new runs may be made
    /// Factor [1] by which to reduce the root of the sum of squares of the weighted variances.
    double factor = 1;
    /// Smallest and largest number of chosen runs.
    std::size_t fewest = 4, most = 16;
};

/// Returns the states among `choice.from` at which new runs most reduce the errors of the
/// predictions at `choice.targets`, the most useful state first. A state may occur several times.
/// The measure of error is the sum of squares of the weighted variances. A greedy choice: each
/// state most reduces the measure relative to the computing time of its run, taken as inversely
/// proportional to the inertial number. A run at state c reduces the covariance C of the
/// predictions by
///     C(., c) [C(c, c) + N]^-1 C(c, .),
/// with the covariance N of the noise of a run with the settings `fidelity`. The choice ends when
/// the root of the measure has decreased by the factor `choice.factor`, but not before
/// `choice.fewest` and not after `choice.most` states.
std::vector<FlowState> most_informative(const Emulator& emulator, const Fidelity& fidelity,
                                        const RunChoice& choice);

}  // namespace pendular
