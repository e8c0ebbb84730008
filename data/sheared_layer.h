#pragma once

namespace pendular {

/// Bed of grains between a lid that shears it, a base and two side walls. Lengths are in grain
/// diameters.
struct WalledBed {
    double height = 0;           ///< from base to lid
    double width = 0;            ///< between the side walls
    double wall_friction = 0;    ///< friction stress over normal stress at the side walls [1]
    double weight = 0;           ///< weight of the bed over the load on it [1]
    double inertial_number = 0;  ///< of the lid's speed over the height [1]
    double stress_ratio = 0;     ///< that the grains would have in uniform shear at this rate [1]
};

/// Where a bed is sheared, and what the lid feels.
struct ShearedLayer {
    /// (int rate dd)^2/int rate^2 dd [diameters]: the height of the bed in uniform shear, less
    /// where shear gathers under the lid.
    double height = 0;
    double stress_ratio = 0;  ///< shear stress over normal stress at the lid [1]
};

/// Returns the sheared layer under the lid of a bed.
///
/// Side walls drag on the moving grains, and the weight of the grains adds to the normal stress, so
/// that the stress ratio falls with the depth d under the lid (balance of forces of a slice):
///     tau(d) = tau(0) - (2 mu_w k/w) int_0^d sigma dd',   sigma(d) = P (1 + weight d/H)
/// Where it falls below the quasi-static stress ratio mu_0, grains move only as far as their
/// neighbours take them along (nonlocal fluidity g = rate/stress ratio):
///     (A a)^2 g'' = abs(mu - mu_0) (g - g_local),   g' = 0 at lid and base
/// with g_local from mu = mu_0 + b I above mu_0 and 0 below. The stress ratio at the lid is the one
/// at which the lid has its speed. With A = 0.4 the profiles of bench/real_cell come out
/// (docs/explanation/cell.md); the wall friction is what acts on the moving layer, about 0.6 times
/// the friction coefficient of a wall smoother than the grains.
/// Sources: Janssen, Z. Ver. dt. Ing. 39 (1895) 1045; Kamrin and Koval, Phys. Rev. Lett. 108 (2012)
/// 178301.
ShearedLayer sheared_layer(const WalledBed& bed);

/// Returns the friction stress over normal stress at the walls of a sheared layer [1], for a
/// friction coefficient of the walls. Beads also roll along a wall and slide across the flow: 0.08
/// to 0.12 at a coefficient of 0.15, 0.12 to 0.14 at 0.3 in bench/real_cell, for beads of friction
/// 0.12.
constexpr double mobilised(double wall_friction) {
    return 0.9 * wall_friction / (1 + 3.6 * wall_friction);
}

}  // namespace pendular
