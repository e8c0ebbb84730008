#pragma once

#include <optional>
#include <string>

#include "data/remarks/remark.h"

namespace pendular {

/// Returns a sentence on values that are probably wrong.
std::string doubt_text(const Remark& doubt);

/// Returns the reason for a doubt without the file, a capital or a full stop: of a value that
/// cannot be, of a column that differs from another by a factor, of a constant column.
std::string impossible_text(const Remark& doubt);
std::string factor_text(const Remark& doubt);
std::string constant_text(const Remark& doubt);

/// Returns a warning for the user if a liquid content [1] is outside of the pendular range, in
/// which the liquid forms separate bridges; empty inside of it and for dry grains.
std::optional<std::string> pendular_range_warning(double liquid_content);

}  // namespace pendular
