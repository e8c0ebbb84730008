#pragma once

#include <string>

#include "data/remarks/doubt_wording.h"
#include "data/remarks/fault_wording.h"

namespace pendular {

/// Words for remarks, the only ones in the program. They stand left of `calib`, whose errors quote
/// warnings, and not in `reports`.

/// Returns a remark for the user: a sentence for a warning, a note and a fault of a file; the
/// reason, without a capital or a full stop, for rows and readings that are left out.
std::string text_of(const Remark& remark);

/// Returns the reason why rows of a step are left out, without the number of the step.
std::string reason_of(const Remark& remark);

/// Returns how many times stated errors exceed the scatter of repeated readings, such as "3.2", of
/// a remark of kind `errors_above_scatter`.
std::string factor_above_scatter(const Remark& note);

}  // namespace pendular
