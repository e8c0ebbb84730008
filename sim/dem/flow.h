#pragma once

#include "sim/dem/vector.h"

namespace pendular::dem {

/// Velocity gradient that is imposed on a sample, in reduced units (grain diameter, grain mass and
/// imposed normal stress are 1). Direction 1 is the flow, 2 the velocity gradient, 3 the vorticity.
///     v1 = length_rate x1 + shear_rate x2,  v2 = height_rate x2,  v3 = width_rate x3
struct Flow {
    /// Imposed shear rate dv1/dx2 in reduced units, in which the shear rate equals the inertial
    /// number.
    double shear_rate = 0;
    /// Rate of change of the cell's height divided by the height, in reduced units.
    double height_rate = 0;
    /// Rate of change of the cell's length along the flow divided by this length, in reduced units.
    double length_rate = 0;
    /// Strain rate of the cell in the vorticity direction (rate of change of the width divided by
    /// the width), in reduced units.
    double width_rate = 0;

    template <typename Archive>
    void serialize(Archive& archive) {
        archive(shear_rate, height_rate, length_rate, width_rate);
    }

    /// Returns the product of the velocity gradient and a vector. If the vector is a position, the
    /// product is the imposed velocity at the position.
    [[gnu::always_inline]] Vector operator()(const Vector& r) const {
        return Vector(length_rate, height_rate, width_rate) * r + r[1] * Vector(shear_rate, 0, 0);
    }
};

}  // namespace pendular::dem
