#pragma once

#include <optional>
#include <vector>

#include "data/reading.h"

namespace pendular {

/// Sign that readings which state one inertial number were made at different speeds.
struct UnstatedSpeeds {
    /// Correlation between the deviations of shear stress and solid fraction of repeated readings
    /// from their means [1].
    double correlation = 0;
};

/// Looks for different speeds behind one stated inertial number: faster flow has a larger shear
/// stress and a smaller solid fraction, so that the deviations of readings which count as
/// repetitions are correlated negatively. Errors of torque, force, gap and mass act on one of both,
/// or denser fillings are the stronger ones; beads whose friction varies deviate likewise.
/// Returns nothing where the readings at any normal stress state several inertial numbers, where
/// the correlation may be chance (p > 0.001), and where repetitions do not scatter more than their
/// stated errors allow.
std::optional<UnstatedSpeeds> unstated_speeds(const Measurements& measurements);

}  // namespace pendular
