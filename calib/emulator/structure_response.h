#pragma once

namespace pendular {

/// Quantity of the network of contacts and liquid bridges at a state of steady shear, such as the
/// coordination number, with its derivatives.
struct StructureResponse {
    /// Value of the quantity of the network, in the unit of the quantity.
    double value = 0;
    /// Derivative of the quantity with respect to the friction coefficient.
    double by_friction = 0;
    /// Derivative of the quantity with respect to ln(V0/a^3), with the bridge volume V0 and the
    /// grain diameter a.
    double by_log_volume = 0;
};

}  // namespace pendular
