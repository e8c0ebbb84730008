#pragma once

#include <optional>

namespace pendular {

/// Standard acceleration of gravity [m/s^2].
constexpr double gravity = 9.80665;

/// Material properties of the grains, in SI units.
struct GrainProperties {
    double diameter = 0;  ///< mean diameter a [m]
    double density = 0;   ///< density of the grain material [kg/m^3]
    /// Young's modulus E [Pa]. If empty, results hold for the stiffness number (see
    /// `stiffness_number`) that belongs to the chosen fidelity (size and duration of simulations).
    std::optional<double> youngs_modulus = {};
    double poisson_ratio = 0.3;  ///< Poisson ratio nu [1]

    /// Mass of one grain [kg]: rho pi a^3/6, with rho the density and a the mean diameter.
    double mass() const;
};

/// The wetting liquid, in SI units.
struct Liquid {
    double surface_tension = 0;  ///< surface tension Gamma [N/m]
    double contact_angle = 0;    ///< contact angle theta [rad]
    double viscosity = 0;        ///< viscosity [Pa s]

    bool operator==(const Liquid&) const = default;
};

/// Inertial number I = rate sqrt(m/(a s22)) [1] at a shear rate [1/s] and a normal stress [Pa],
/// with m the mass and a the diameter of a grain.
/// Source: Badetti et al. (2018), eq:defI, in its three-dimensional form; the other common form,
/// rate a sqrt(rho/s22), is sqrt(6/pi) = 1.382 times larger.
double inertial_number(double shear_rate, double normal_stress, const GrainProperties& grains);

/// Shear rate [1/s] at an inertial number [1] and a normal stress [Pa]; the inverse of
/// `inertial_number`.
double shear_rate_at(double inertial_number, double normal_stress, const GrainProperties& grains);

/// Stiffness number kappa = (E~/s22)^(2/3) [1] at a normal stress s22 [Pa], E~ = E/(1 - nu^2), with
/// E Young's modulus and nu the Poisson ratio of the grains; empty without a Young's modulus.
std::optional<double> stiffness_number(double normal_stress, const GrainProperties& grains);

/// Pull-off force F0 = pi a Gamma cos(theta) [N]: the attraction of two equal grains in contact,
/// joined by a liquid bridge of any volume; a is the grain diameter.
/// Source: Maugis, J. Adhesion Sci. Technol. 1 (1987) 105; Badetti et al. (2018), eq:Maugis.
double pull_off_force(const GrainProperties& grains, const Liquid& liquid);

/// Reduced pressure P* = a^2 s22/F0 [1] at a normal stress s22 [Pa], with a the grain diameter and
/// F0 the pull-off force of two grains joined by a liquid bridge (`pull_off_force`); infinite for a
/// liquid without surface tension.
/// Source: Badetti et al. (2018), eq:defPstar.
double reduced_pressure(double normal_stress, const GrainProperties& grains, const Liquid& liquid);

}  // namespace pendular
