#pragma once

namespace pendular {

/// Number with its standard error; both have the same unit.
struct Estimate {
    double value = 0;
    double standard_error = 0;
};

}  // namespace pendular
