#pragma once

#include <functional>
#include <span>
#include <vector>

namespace pendular {

/// Function that simulates wet samples, one short run for each bridge volume, and returns the
/// liquid contents of the samples [1], in the order of the bridge volumes. A liquid content is the
/// liquid volume divided by the grain volume.
/// @param which for each sample, index of its requested liquid content in the list of all requested
///         liquid contents
/// @param bridge_volumes volume of one bridge in each sample, divided by the cubed grain diameter
///         [1]
using MeasureLiquidContents = std::function<std::vector<double>(
    std::span<const std::size_t> which, std::span<const double> bridge_volumes)>;

/// Returns the bridge volumes, divided by the cubed grain diameter [1], at which samples have the
/// requested liquid contents, in the order of the liquid contents.
///     liquid content = 3 Z (V0/a^3)/pi      V0: bridge volume, a: grain diameter
/// The mean number Z of bridges on a grain depends on V0 and must be measured by simulation. The
/// function simulates each sample once and corrects V0. If the liquid content was wrong by more
/// than 3 %, the function simulates the sample a second time with the corrected V0. The relative
/// error of the final liquid content is far below 3 %.
/// @param liquid_contents requested liquid contents [1]: liquid volume divided by grain volume
/// @param measure function that simulates samples and returns the liquid contents of the samples
/// Source: Badetti et al. (2018), Eq. (6).
std::vector<double> bridge_volumes(std::span<const double> liquid_contents,
                                   const MeasureLiquidContents& measure);

/// Returns the bridge volume, divided by the cubed grain diameter [1], with which the function
/// `bridge_volumes` begins its search. The bridge volume gives the requested liquid content if a
/// grain has a typical number of bridges (`dem::typical_coordination`).
/// @param liquid_content requested liquid content: liquid volume divided by grain volume [1]
double first_bridge_volume(double liquid_content);

}  // namespace pendular
