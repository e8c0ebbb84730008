#pragma once

#include <optional>

namespace pendular {

/// Standard acceleration of gravity [m/s^2].
constexpr double gravity = 9.80665;

/// Properties of the grains in SI units: diameter, density and elastic constants.
struct GrainProperties {
    double diameter = 0;  ///< mean diameter a of the grains [m]
    double density = 0;   ///< density of the grain material [kg/m^3]
    /// Young's modulus E of the grain material [Pa]. If E is not given, the simulations have the
    /// stiffness number (`stiffness_number`) of the chosen simulation settings (`Fidelity`).
    std::optional<double> youngs_modulus = {};
    double poisson_ratio = 0.3;  ///< Poisson ratio nu of the grain material [1]

    /// Returns the mass of one grain [kg]: rho pi a^3/6, with the density rho of the grain material
    /// and the mean diameter a of the grains.
    double mass() const;
};

/// Properties of the liquid that wets the grains, in SI units.
struct Liquid {
    double surface_tension = 0;  ///< surface tension Gamma of the liquid [N/m]
    double contact_angle = 0;    ///< contact angle theta of the liquid on the grains [rad]
    double viscosity = 0;        ///< viscosity of the liquid [Pa s]

    bool operator==(const Liquid&) const = default;
};

/// Returns the inertial number I [1] at a shear rate [1/s] and a normal stress s22 [Pa].
///     I = shear rate sqrt(m/(a s22))      m, a: mass [kg] and diameter [m] of a grain
/// A second common definition, shear rate times a sqrt(density/s22), gives inertial numbers that
/// are sqrt(6/pi) = 1.382 times larger.
/// Source: Badetti et al. (2018), Eq. (12), in its three-dimensional form.
double inertial_number(double shear_rate, double normal_stress, const GrainProperties& grains);

/// Returns the shear rate [1/s] at an inertial number I [1] and a normal stress s22 [Pa]. The
/// function inverts `inertial_number`.
///     shear rate = I / sqrt(m/(a s22))      m, a: mass [kg] and diameter [m] of a grain
double shear_rate_at(double inertial_number, double normal_stress, const GrainProperties& grains);

/// Returns the stiffness number kappa [1] of the contacts at a normal stress s22 [Pa]. The result
/// is empty if the Young's modulus of the grains is not given.
///     kappa = (E/((1 - nu^2) s22))^(2/3)      E: Young's modulus [Pa], nu: Poisson ratio [1]
std::optional<double> stiffness_number(double normal_stress, const GrainProperties& grains);

/// Returns the pull-off force F0 [N]: attraction of two equal grains in contact that are joined by
/// a liquid bridge of any volume.
///     F0 = pi a Gamma cos(theta)      a: grain diameter [m], Gamma: surface tension [N/m],
///                                     theta: contact angle [rad]
/// Source: Maugis, J. Adhesion Sci. Technol. 1 (1987) 105; Badetti et al. (2018), Eq. (5).
double pull_off_force(const GrainProperties& grains, const Liquid& liquid);

/// Returns the reduced pressure P* [1] at a normal stress s22 [Pa]. The reduced pressure is
/// infinite for a liquid without surface tension.
///     P* = a^2 s22/F0      a: grain diameter [m], F0: pull-off force of a liquid bridge [N]
/// Source: Badetti et al. (2018), Eq. (13).
double reduced_pressure(double normal_stress, const GrainProperties& grains, const Liquid& liquid);

}  // namespace pendular
