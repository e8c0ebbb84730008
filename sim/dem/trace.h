#pragma once

#include <array>
#include <string_view>
#include <vector>

namespace pendular::dem {

/// What a trace tells of every block; stresses over the imposed normal stress.
constexpr std::array trace_names = std::to_array<std::string_view>(
    {"strain", "s11", "s22", "s33", "s12", "solid_fraction", "contact_coordination",
     "distant_coordination", "localization"});

/// A run block by block, each of a strain of about 0.02 [1], in single precision: numbers in the
/// order of `trace_names`, the strain that of the block alone.
using Trace = std::vector<std::array<float, trace_names.size()>>;

}  // namespace pendular::dem
