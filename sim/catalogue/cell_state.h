#pragma once

namespace pendular {

/// State of an annular shear cell: the true state, or the state that the instrument shows. Torque
/// is positive when it shears the grains, normal force when it compresses them.
struct CellState {
    double torque = 0;            ///< on the lid [N m]
    double normal_force = 0;      ///< on the sample at mid-height [N]
    double height = 0;            ///< of the sample [m]
    double angular_velocity = 0;  ///< of the lid [rad/s]
    double liquid_content = 0;    ///< liquid volume over grain volume [1]
    double bead_volume = 0;       ///< solid volume of the grains [m^3]
    double time = 0;              ///< since the study's first recording began [s]

    // No effect changes the quantities below.
    double inner_radius = 0, outer_radius = 0;  ///< of the side walls [m]
    double density = 0;                         ///< of the grain material [kg/m^3]
    double diameter = 0;                        ///< mean diameter of the grains [m]

    /// Returns the area of the annulus on which the lid presses [m^2].
    double area() const;
    /// Returns the distance between the side walls [m].
    double width() const { return outer_radius - inner_radius; }
    /// Returns the weight of the dry grains in the cell [N].
    double weight() const;
};

}  // namespace pendular
