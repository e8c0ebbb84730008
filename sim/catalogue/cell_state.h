#pragma once

namespace pendular {

/// State of an annular shear cell in SI units: either the true state or the state that the
/// instrument shows. The torque is positive when the grains are sheared. The normal force is
/// positive when the grains are compressed.
struct CellState {
    double torque = 0;            ///< torque on the lid of the cell [N m]
    double normal_force = 0;      ///< normal force on the sample at mid-height [N]
    double height = 0;            ///< height of the sample in the cell [m]
    double angular_velocity = 0;  ///< angular velocity of the lid [rad/s]
    double liquid_content = 0;    ///< liquid volume divided by grain volume in the cell [1]
    double bead_volume = 0;       ///< solid volume of the grains in the cell [m^3]
    double time = 0;              ///< time since the study's first recording began [s]

    // No effect changes the quantities below.
    /// Radius of the inner side wall and radius of the outer side wall of the cell [m].
    double inner_radius = 0, outer_radius = 0;
    double density = 0;   ///< density of the grain material [kg/m^3]
    double diameter = 0;  ///< mean diameter of the grains [m]

    /// Returns the area of the annulus on which the lid presses [m^2].
    double area() const;
    /// Returns the width of the annulus [m]: distance between the inner and the outer side wall.
    double width() const { return outer_radius - inner_radius; }
    /// Returns the weight of the dry grains in the cell [N].
    double weight() const;
};

}  // namespace pendular
