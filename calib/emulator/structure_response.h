#pragma once

namespace pendular {

/// Quantity of the network of contacts and liquid bridges at a state of steady shear, such as the
/// coordination number, with the derivatives of the quantity.
struct StructureResponse {
    /// Value of the quantity of the network, in the unit of the quantity.
    double value = 0;
    /// Derivative of the quantity with respect to the friction coefficient [unit of the quantity].
    double by_friction = 0;
    /// Derivative of the quantity with respect to ln(V0/a^3) [unit of the quantity], where V0 is
    /// the bridge volume and a the grain diameter.
    double by_log_volume = 0;
};

}  // namespace pendular
