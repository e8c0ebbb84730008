#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "data/reading.h"
#include "data/remarks/fault_wording.h"

namespace pendular {

/// Words for remarks, the only ones in the program. They stand left of `calib`, whose errors quote
/// warnings, and not in `reports`.

/// Returns a remark for the user: a sentence for a warning, a note and a fault of a file; the
/// reason, without a capital or a full stop, for rows and readings that are left out.
std::string text_of(const Remark& remark);

/// Returns the reason why rows of a step are left out, without the number of the step.
std::string reason_of(const Remark& remark);

/// Returns a warning for the user if a liquid content [1] is outside of the pendular range, in
/// which the liquid forms separate bridges; empty inside of it and for dry grains.
std::optional<std::string> pendular_range_warning(double liquid_content);

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
