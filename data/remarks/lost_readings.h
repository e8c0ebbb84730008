#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "data/reading.h"

namespace pendular {

/// Returns the number of readings with a doubt or without a usable mean, without transients and
/// steps that rest.
std::size_t readings_set_aside(const Measurements& measurements);

/// Whether import gave nothing to rely on: more readings were set aside than kept, or rows were
/// left out and no reading is there.
bool mostly_set_aside(const Measurements& measurements);

/// Returns a sentence with the reason for which most steps were left out, and advice, such as "The
/// normal force is negative in all 30 steps; compression must be positive: ...". Empty unless
/// `mostly_set_aside`, or if the reason is not known.
std::optional<std::string> common_reason(const Measurements& measurements);

/// Returns a sentence on why a study has no reading, with advice.
std::string why_no_reading(const Measurements& measurements);

}  // namespace pendular
