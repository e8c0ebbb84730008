#pragma once

#include <functional>
#include <span>
#include <vector>

namespace pendular {

/// Simulates wet samples, one short run for each bridge volume, and returns their liquid contents
/// [1] in the same order.
/// @param which for each sample, index of its liquid content among all requested ones
/// @param bridge_volumes over the cubed grain diameter [1]
using MeasureLiquidContents = std::function<std::vector<double>(
    std::span<const std::size_t> which, std::span<const double> bridge_volumes)>;

/// Returns the bridge volumes V0, over the cubed grain diameter a^3 [1], at which samples have the
/// requested liquid contents [1], in their order.
///     liquid content = 3 Z (V0/a^3)/pi
/// The mean number Z of bridges on a grain depends on V0 and must be measured by simulation. Each
/// sample is simulated once and V0 corrected; if the liquid content was wrong by more than 3 %, the
/// sample is simulated a second time with the corrected V0. The relative error of the final liquid
/// content is far below 3 %.
/// Source: Badetti et al. (2018), Eq. (6).
std::vector<double> bridge_volumes(std::span<const double> liquid_contents,
                                   const MeasureLiquidContents& measure);

/// Returns the bridge volume, over the cubed grain diameter [1], with which `bridge_volumes`
/// begins: for a typical number of bridges on a grain (`dem::typical_coordination`).
double first_bridge_volume(double liquid_content);

}  // namespace pendular
