#pragma once

#include <functional>
#include <span>
#include <vector>

namespace pendular {

/// Liquid contents [1] found in samples with these bridge volumes V0/a^3, one short simulation
/// each; `which` are the samples' places in the list of contents asked for.
using MeasureLiquidContents = std::function<std::vector<double>(
    std::span<const std::size_t> which, std::span<const double> bridge_volumes)>;

/// Bridge volumes V0/a^3 [1] with which samples have the liquid contents asked for.
///     Phi_L/Phi_S = 3 Z V0/(pi a^3)      the coordination Z depends on V0, friction and stress
/// A first simulation at a typical Z gives the Z to correct by. Where it was off by more than 3 %,
/// a second one checks the correction, and where that is off by more than 3 % still, a secant in
/// the logarithms corrects once more: Z changes by 5 % only where V0 doubles, so what is left is
/// far below 3 %. Source: Badetti et al. (2018), eq:lcont.
std::vector<double> bridge_volumes(std::span<const double> liquid_contents,
                                   const MeasureLiquidContents& measure);

/// Bridge volume over a^3 of the first simulation [1].
double first_bridge_volume(double liquid_content);

}  // namespace pendular
