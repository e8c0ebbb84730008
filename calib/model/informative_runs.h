#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <vector>

#include "calib/emulator/emulator.h"
#include "sim/runs/fidelity.h"

namespace pendular {

/// Whether two states of steady shear are so similar that one simulation run can represent both:
/// they have the same effects on grains and agree within 5 % in friction, inertial number, reduced
/// pressure, bridge volume and the sizes of the effects. Stiffness numbers are not compared.
bool near(const FlowState& a, const FlowState& b);

/// Task for `most_informative`: the predictions to improve, and the states at which runs may be
/// made to reduce their errors.
struct RunChoice {
    /// States of steady shear whose predicted stress ratios and solid fractions are to become more
    /// precise.
    std::vector<FlowState> targets;
    /// Weights of the variances of predictions [1]: for each target, of its stress ratio, then of
    /// its solid fraction.
    Eigen::VectorXd weights;
    /// States of steady shear at which new runs may be made.
    std::vector<FlowState> from;
    /// Factor by which new runs should reduce the root of the sum of squares of the weighted
    /// variances [1].
    double factor = 1;
    /// Smallest and largest number of new runs that `most_informative` chooses.
    std::size_t fewest = 4, most = 16;
};

/// Returns the states of steady shear at which new runs reduce the errors of the emulator's
/// predictions most, the most useful first; a state may occur several times. The measure of error
/// is the sum of squares of the weighted variances of the predictions, so that the worst
/// predictions count most. States are chosen one after the other, each with the largest reduction
/// per computing time, which is inversely proportional to the inertial number. A run at state c
/// reduces the covariance C of the predictions by
///     C(., c) [C(c, c) + N]^-1 C(c, .),
/// with the covariance N of the noise of a run with the settings `fidelity`. Between
/// `choice.fewest` and `choice.most` states are returned.
std::vector<FlowState> most_informative(const Emulator& emulator, const Fidelity& fidelity,
                                        const RunChoice& choice);

}  // namespace pendular
