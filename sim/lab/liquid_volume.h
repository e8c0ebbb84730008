#pragma once

#include <functional>
#include <span>
#include <vector>

namespace pendular {

/// Function that simulates wet samples, one short run for each bridge volume V0/a^3 [1] in
/// `bridge_volumes`, and returns their liquid contents Phi_L/Phi_S [1]. `which`: index of each
/// sample in the list of requested liquid contents.
using MeasureLiquidContents = std::function<std::vector<double>(
    std::span<const std::size_t> which, std::span<const double> bridge_volumes)>;

/// Returns the bridge volumes V0/a^3 [1] with which samples have the requested liquid contents [1].
///     Phi_L/Phi_S = 3 Z V0/(pi a^3)      the coordination Z depends on V0, friction and stress
/// A first simulation, with V0 from a typical Z, gives the Z that corrects V0. Where its liquid
/// content was off by more than 3 %, a second simulation checks the correction. Where the second
/// liquid content is also off by more than 3 %, a secant step in the logarithms corrects V0 again.
/// Z changes by 5 % only where V0 doubles, so that the final error is far below 3 %. Source:
/// Badetti et al. (2018), eq:lcont.
std::vector<double> bridge_volumes(std::span<const double> liquid_contents,
                                   const MeasureLiquidContents& measure);

/// Returns the bridge volume V0/a^3 [1] that gives a liquid content [1] at a typical coordination
/// number (bridges per grain); the search by `bridge_volumes` starts from this volume.
double first_bridge_volume(double liquid_content);

}  // namespace pendular
