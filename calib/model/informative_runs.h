#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <vector>

#include "calib/emulator/emulator.h"
#include "sim/runs/fidelity.h"

namespace pendular {

/// Whether two states of steady shear are so similar that a simulation run at one state also
/// represents the other state. The states must have the same effects on grains, and must agree
/// within 5 % in friction coefficient, inertial number, reduced pressure, bridge volume and the
/// parameter values of the effects. Stiffness numbers are not compared.
bool near(const FlowState& a, const FlowState& b);

/// Task for the function `most_informative`: the predictions of the emulator to improve, and the
/// states at which simulation runs may be made to reduce the errors of the predictions.
struct RunChoice {
    /// States of steady shear whose predicted stress ratios and solid fractions are to become more
    /// precise.
    std::vector<FlowState> targets;
    /// Weights by which the variances of the predictions at `targets` are multiplied [1]. Each
    /// target in turn has two weights, first for the stress ratio, then for the solid fraction.
    Eigen::VectorXd weights;
    /// States of steady shear at which new runs may be made.
    std::vector<FlowState> from;
    /// Factor [1] by which new runs should reduce the root of the sum of squares of the weighted
    /// variances of the predictions.
    double factor = 1;
    /// Smallest (`fewest`) and largest (`most`) number of new runs that `most_informative` chooses.
    std::size_t fewest = 4, most = 16;
};

/// Returns the states among `choice.from` at which new simulation runs most reduce the errors of
/// the emulator's predictions at `choice.targets`, the most useful state first. A state may occur
/// several times. The measure of error is the sum of squares of the weighted variances of the
/// predictions. The function chooses one state after another. Each chosen state most reduces the
/// measure of error, relative to the computing time of its run (taken as inversely proportional to
/// the inertial number). A run at state c reduces the covariance C of the predictions by
///     C(., c) [C(c, c) + N]^-1 C(c, .),
/// with the covariance N of the noise of a run with the settings `fidelity`. The choice ends when
/// the root of the measure of error has decreased by the factor `choice.factor`, but not before
/// `choice.fewest` and not after `choice.most` states.
std::vector<FlowState> most_informative(const Emulator& emulator, const Fidelity& fidelity,
                                        const RunChoice& choice);

}  // namespace pendular
