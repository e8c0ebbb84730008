#pragma once

namespace pendular {

/// Quantity of the network of contacts and bridges, such as the coordination number, with
/// derivatives, all in the unit of the quantity.
struct StructureResponse {
    double value = 0;
    double by_friction = 0;
    double by_log_volume = 0;  ///< with respect to ln(V0/a^3)
};

}  // namespace pendular
