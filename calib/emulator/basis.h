#pragma once

#include <Eigen/Core>
#include <vector>

#include "data/effect_parameter.h"

namespace pendular {

/// State of steady shear, given by the dimensionless numbers that determine the flow. The emulator,
/// which interpolates simulations, predicts observables such as the stress ratio at such states.
struct FlowState {
    double friction = 0;         ///< friction coefficient of the contacts [1]
    double inertial_number = 0;  ///< inertial number I [1]; 0: the quasi-static limit
    /// Inverse reduced pressure 1/P* = F0/(a^2 s22) [1], with the pull-off force F0 of a bridge,
    /// the grain diameter a and the normal stress s22. For dry grains, 1/P* is 0.
    double inverse_pressure = 0;
    /// Volume of one liquid bridge, divided by the cubed grain diameter [1]; unused for dry grains.
    double bridge_volume = 0;
    /// Physical effects on the grains, such as rolling resistance, with the values of their
    /// parameters. The values are in the units of a simulation run, in which grain diameter, grain
    /// mass and normal stress are 1.
    std::vector<EffectValues> effects = {};
    /// Stiffness number (E/((1 - nu^2) s22))^(2/3) of the contacts [1], with Young's modulus E,
    /// Poisson ratio nu and normal stress s22. The value 0 stands for the stiffness number of the
    /// simulation runs on which the emulator is trained.
    double stiffness_number = 0;

    bool dry() const { return inverse_pressure == 0; }
};

/// Dimensionless coordinates of a state of steady shear. Observables of the flow, such as the
/// stress ratio, are nearly linear functions of the coordinates.
struct Coordinates {
    /// Coordinate of the friction coefficient [1]: ln[(friction + s)/(centre + s)] with a chosen
    /// friction coefficient `centre`. The constant s is 0.05 in the function `coordinates` and 0.02
    /// in the function `emulated::place_of`.
    double x = 0;
    /// Coordinate of the inertial number I [1]: I^exponent with a chosen exponent.
    double q = 0;
    /// Coordinate of the reduced pressure P* [1]: the inverse 1/P*.
    double u = 0;
    /// Coordinate of the bridge volume V0 [1]: ln(V0/a^3/0.002) with the grain diameter a. The
    /// coordinate is 0 for dry grains.
    double v = 0;

    bool operator==(const Coordinates&) const = default;
};

/// Returns the coordinates of a state of steady shear,
///     x = ln[(friction + 0.05)/(centre + 0.05)],  q = I^exponent,
///     u = 1/P*,  v = ln(V0/a^3/0.002),
/// with the inertial number I, the reduced pressure P*, the bridge volume V0 and the grain diameter
/// a. For dry grains, v = 0.
/// @param centre friction coefficient at which x is 0 [1]
/// @param exponent exponent of the inertial number in q [1]
Coordinates coordinates(const FlowState& state, double centre, double exponent);

/// Returns the coordinate x = ln[(friction + 0.05)/(centre + 0.05)] of a friction coefficient [1].
/// The coordinate x is 0 at the friction coefficient `centre`.
double friction_coordinate(double friction, double centre);
/// Returns the friction coefficient [1] at which ln[(friction + 0.05)/(centre + 0.05)] equals
/// `coordinate`. The function is the inverse of `friction_coordinate`.
double friction_at(double coordinate, double centre);
/// Returns the derivative of `friction_coordinate` with respect to the friction coefficient [1],
/// which is 1/(friction + 0.05).
double friction_slope(double friction);

/// Terms of a polynomial in the coordinates x, q, u and v of a state of steady shear
/// (`Coordinates`). Each term is a product of powers of the coordinates.
class Basis {
  public:
    /// Exponents of the coordinates x, q, u and v in one term of the polynomial.
    struct Powers {
        int x = 0, q = 0, u = 0, v = 0;
    };
    void add(const Powers& term) { terms_.push_back(term); }
    Eigen::Index size() const { return static_cast<Eigen::Index>(terms_.size()); }

    /// Returns the value of each term of the polynomial (product of powers of x, q, u and v) at the
    /// coordinates `at`, in the order in which the terms were added.
    Eigen::RowVectorXd values(const Coordinates& at) const;
    /// Returns the derivative of each term of the polynomial with respect to one coordinate, at the
    /// coordinates `at`, in the order in which the terms were added.
    /// @param coordinate coordinate with respect to which the terms are differentiated: 0 for x, 1
    ///        for q, 2 for u, 3 for v; if -1, the function returns the values of the terms
    Eigen::RowVectorXd slopes(const Coordinates& at, int coordinate) const;
    Eigen::RowVectorXd slopes_in_x(const Coordinates& at) const { return slopes(at, 0); }
    Eigen::RowVectorXd slopes_in_v(const Coordinates& at) const { return slopes(at, 3); }

  private:
    std::vector<Powers> terms_;
};

}  // namespace pendular
