#pragma once

namespace pendular {

/// A number with its standard error, in the same unit.
struct Estimate {
    double value = 0;
    double standard_error = 0;
};

}  // namespace pendular
