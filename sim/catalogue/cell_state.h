#pragma once

namespace pendular {

/// State of an annular cell, as it truly is or as the instrument shows it; SI units. Signs are
/// those of a magnitude: torque and normal force are positive where beads are sheared and pressed.
struct CellState {
    double torque = 0;            ///< on the lid [N m]
    double normal_force = 0;      ///< on the sample at mid-height [N]
    double height = 0;            ///< of the sample [m]
    double angular_velocity = 0;  ///< of the lid [rad/s]
    double liquid_content = 0;    ///< Phi_L/Phi_S [1]
    double bead_volume = 0;       ///< in the cell [m^3]
    double time = 0;              ///< since the first recording began [s]

    // No effect changes these.
    double inner_radius = 0, outer_radius = 0;  ///< of the cell [m]
    double density = 0;                         ///< of the beads [kg/m^3]
    double diameter = 0;                        ///< of the beads [m]

    /// Area of the annulus [m^2].
    double area() const;
    /// Gap between the side walls [m]: Re - Ri.
    double width() const { return outer_radius - inner_radius; }
    /// Weight of the beads [N].
    double weight() const;
};

}  // namespace pendular
