#pragma once

#include <optional>

namespace pendular {

/// Standard acceleration of gravity [m/s^2].
constexpr double gravity = 9.80665;

struct GrainProperties {
    double diameter = 0;  ///< a, mean diameter [m]
    double density = 0;   ///< rho, density of the grain material [kg/m^3]
    /// Young's modulus E [Pa]; empty: the simulations have the stiffness number of the chosen
    /// `Fidelity`.
    std::optional<double> youngs_modulus = {};
    double poisson_ratio = 0.3;  ///< nu [1]

    /// Returns the mass of one grain [kg]: rho pi a^3/6.
    double mass() const;
};

/// Properties of the liquid that wets the grains.
struct Liquid {
    double surface_tension = 0;  ///< Gamma [N/m]
    double contact_angle = 0;    ///< theta, on the grains [rad]
    double viscosity = 0;        ///< [Pa s]

    bool operator==(const Liquid&) const = default;
};

/// Returns the inertial number I [1] at a shear rate [1/s] and a normal stress s22 [Pa].
///     I = shear rate sqrt(m/(a s22))      m: mass of a grain [kg]
/// A second common definition, shear rate times a sqrt(density/s22), gives inertial numbers that
/// are sqrt(6/pi) = 1.382 times larger.
/// Source: Badetti et al. (2018), Eq. (12), in its three-dimensional form.
double inertial_number(double shear_rate, double normal_stress, const GrainProperties& grains);

/// Returns the shear rate [1/s] at an inertial number [1] and a normal stress [Pa]: inverse of
/// `inertial_number`.
double shear_rate_at(double inertial_number, double normal_stress, const GrainProperties& grains);

/// Returns the stiffness number kappa [1] of the contacts at a normal stress s22 [Pa]; empty
/// without a Young's modulus.
///     kappa = (E/((1 - nu^2) s22))^(2/3)
std::optional<double> stiffness_number(double normal_stress, const GrainProperties& grains);

/// Returns the pull-off force F0 [N]: attraction of two equal grains in contact that are joined by
/// a liquid bridge of any volume.
///     F0 = pi a Gamma cos(theta)
/// Source: Maugis, J. Adhesion Sci. Technol. 1 (1987) 105; Badetti et al. (2018), Eq. (5).
double pull_off_force(const GrainProperties& grains, const Liquid& liquid);

/// Returns the reduced pressure P* [1] at a normal stress s22 [Pa]; infinite without surface
/// tension.
///     P* = a^2 s22/F0
/// Source: Badetti et al. (2018), Eq. (13).
double reduced_pressure(double normal_stress, const GrainProperties& grains, const Liquid& liquid);

}  // namespace pendular
