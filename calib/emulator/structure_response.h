#pragma once

namespace pendular {

/// Quantity of the network of contacts and liquid bridges at a state of steady shear, such as the
/// coordination number, with its derivatives.
struct StructureResponse {
    /// Value of the quantity, in its unit.
    double value = 0;
    double by_friction = 0;    ///< derivative by the friction coefficient
    double by_log_volume = 0;  ///< derivative by ln(V0/a^3), with the bridge volume V0
};

}  // namespace pendular
