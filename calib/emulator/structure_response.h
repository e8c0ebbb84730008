#pragma once

namespace pendular {

/// Quantity of the bridge network at a state, with its derivatives.
struct StructureResponse {
    double value = 0;
    double by_friction = 0;
    double by_log_volume = 0;  ///< by ln(V0/a^3)
};

}  // namespace pendular
