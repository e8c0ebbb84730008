#pragma once

#include <functional>
#include <span>
#include <vector>

namespace pendular {

/// Function that simulates wet samples, one short run for each bridge volume, and returns the
/// liquid contents (liquid volume divided by grain volume [1]) of the samples in the same order.
/// @param which index of each sample in the list of requested liquid contents
/// @param bridge_volumes volume of one bridge divided by the cubed grain diameter [1] of each
///         sample
using MeasureLiquidContents = std::function<std::vector<double>(
    std::span<const std::size_t> which, std::span<const double> bridge_volumes)>;

/// Returns the bridge volumes divided by the cubed grain diameter [1] at which samples have the
/// requested liquid contents (liquid volume divided by grain volume [1]), in the same order.
///     liquid content = 3 Z (V0/a^3)/pi      V0: bridge volume, a: grain diameter
/// The number Z of bridges per grain depends on V0, friction and stress. A first simulation, with
/// V0 for a typical Z, measures the Z with which V0 is corrected. If the liquid content of the
/// first simulation was wrong by more than 3 %, a second simulation checks the corrected V0. If the
/// second liquid content is also wrong by more than 3 %, a secant step in the logarithms corrects
/// V0 again. Since Z changes by only 5 % if V0 doubles, the final error is far below 3 %.
/// @param measure function that simulates samples and returns their liquid contents
/// Source: Badetti et al. (2018), eq:lcont.
std::vector<double> bridge_volumes(std::span<const double> liquid_contents,
                                   const MeasureLiquidContents& measure);

/// Returns the bridge volume divided by the cubed grain diameter [1] with which the search by
/// `bridge_volumes` begins: its value for a typical number of bridges per grain.
/// @param liquid_content liquid volume divided by grain volume [1]
double first_bridge_volume(double liquid_content);

}  // namespace pendular
