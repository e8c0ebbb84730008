#pragma once

namespace pendular {

/// Quantity of the network of contacts and bridges at a state, with its derivatives.
struct StructureResponse {
    double value = 0;
    double by_friction = 0;    ///< derivative by friction
    double by_log_volume = 0;  ///< derivative by ln(V0/a^3)
};

}  // namespace pendular
