#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <vector>

#include "calib/emulator/emulator.h"
#include "sim/runs/fidelity.h"

namespace pendular {

/// Whether two flow states have the same effects and agree within 5 % in friction, inertial number,
/// reduced pressure, bridge volume and the sizes of the effects, so that one run serves both.
bool near(const FlowState& a, const FlowState& b);

/// Choice of the flow states at which runs reduce the errors of predictions most.
struct RunChoice {
    std::vector<FlowState> targets;  ///< states whose predictions matter
    /// Weights of the variances of the predicted stress ratio and solid fraction at each target, in
    /// this order [1].
    Eigen::VectorXd weights;
    std::vector<FlowState> from;  ///< states at which runs may be made
    /// Factor by which the weighted variances are to decrease [1].
    double factor = 1;
    /// Smallest and largest number of runs that are chosen.
    std::size_t fewest = 4, most = 16;
};

/// Flow states at which runs reduce the sum of the squared weighted variances of the emulator's
/// predictions most, the most useful first: the squares let the worst predictions count most. The
/// states are chosen one after the other, some repeatedly, each with the largest reduction for its
/// time, which is inversely proportional to the inertial number. A run at c
/// reduces the covariance C of the predictions by
///     C(., c) [C(c, c) + N]^-1 C(c, .),
/// with the noise N of a run of this fidelity (set of simulation settings).
std::vector<FlowState> most_informative(const Emulator& emulator, const Fidelity& fidelity,
                                        const RunChoice& choice);

}  // namespace pendular
