#pragma once

#include "sim/dem/vector.h"

namespace pendular::dem {

/// Velocity gradient that is imposed on a sample, in reduced units (grain diameter, grain mass and
/// imposed normal stress are 1). Direction 1 is the flow, 2 the velocity gradient, 3 the vorticity.
///     v1 = length_rate x1 + shear_rate x2,  v2 = height_rate x2,  v3 = width_rate x3
struct Flow {
    double shear_rate = 0;  ///< equal to the inertial number
    double height_rate = 0;
    double length_rate = 0;
    double width_rate = 0;

    template <typename Archive>
    void serialize(Archive& archive) {
        archive(shear_rate, height_rate, length_rate, width_rate);
    }

    /// Returns the velocity gradient times a vector: for a position, the imposed velocity there.
    [[gnu::always_inline]] Vector operator()(const Vector& r) const {
        return Vector(length_rate, height_rate, width_rate) * r + r[1] * Vector(shear_rate, 0, 0);
    }
};

}  // namespace pendular::dem
