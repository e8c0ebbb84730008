#pragma once

#include <cstddef>
#include <vector>

namespace pendular::dem {

/// The beads of a sample, structure of arrays, in reduced units (diameter, mass and normal stress
/// are 1). Velocities are peculiar: what remains after the imposed shear and height change.
struct Beads {
    std::vector<double> x, y, z;     ///< centres; inside the cell when the neighbour list was built
    std::vector<double> vx, vy, vz;  ///< peculiar velocities, half a step behind the centres
    std::vector<double> wx, wy, wz;  ///< angular velocities
    std::vector<double> fx, fy, fz;  ///< forces
    std::vector<double> tx, ty, tz;  ///< torques
    std::vector<double> ux, uy, uz;  ///< peculiar displacements since the contact list was made

    explicit Beads(std::size_t count = 0) {
        for (auto* column : columns()) {
            column->assign(count, 0.0);
        }
    }
    std::size_t size() const { return x.size(); }

    /// All arrays, for whoever treats them alike.
    std::vector<std::vector<double>*> columns() {
        return {&x,  &y,  &z,  &vx, &vy, &vz, &wx, &wy, &wz,
                &fx, &fy, &fz, &tx, &ty, &tz, &ux, &uy, &uz};
    }
};

/// Moment of inertia of a bead of unit mass and diameter: (2/5)(1/2)^2.
constexpr double moment_of_inertia = 0.1;

}  // namespace pendular::dem
