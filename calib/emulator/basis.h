#pragma once

#include <Eigen/Core>
#include <vector>

#include "data/effect_parameter.h"

namespace pendular {

/// State of steady shear, given by the dimensionless numbers that determine the flow.
struct FlowState {
    double friction = 0;          ///< friction coefficient of the contacts [1]
    double inertial_number = 0;   ///< inertial number I [1]; 0: the quasi-static limit
    double inverse_pressure = 0;  ///< 1/P* = F0/(a^2 s22) [1]; 0 for dry grains
    double bridge_volume = 0;     ///< V0/a^3 of one bridge [1]; unused for dry grains
    /// Effects on the grains with the values of their parameters, in the units of a run, in which
    /// grain diameter, grain mass and normal stress are 1.
    std::vector<EffectValues> effects = {};
    /// Stiffness number (E/((1 - nu^2) s22))^(2/3) of the contacts [1]; 0 stands for that of the
    /// runs on which the emulator is trained.
    double stiffness_number = 0;

    bool dry() const { return inverse_pressure == 0; }
};

/// Coordinates [1] of a state, in which observables such as the stress ratio are nearly linear:
///     x = ln[(friction + s)/(centre + s)],  q = I^exponent,  u = 1/P*,  v = ln(V0/a^3/0.002),
/// and v = 0 for dry grains; s is 0.05 in `coordinates` and 0.02 in `emulated::place_of`.
struct Coordinates {
    double x = 0;
    double q = 0;
    double u = 0;
    double v = 0;

    bool operator==(const Coordinates&) const = default;
};

/// Returns the coordinates of a state of steady shear, with s = 0.05.
/// @param centre friction coefficient at which x is 0 [1]
/// @param exponent exponent of the inertial number in q [1]
Coordinates coordinates(const FlowState& state, double centre, double exponent);

/// Returns the coordinate x = ln[(friction + 0.05)/(centre + 0.05)] of a friction coefficient [1].
double friction_coordinate(double friction, double centre);
/// Returns the friction coefficient [1] at the coordinate x: the inverse of `friction_coordinate`.
double friction_at(double coordinate, double centre);

/// Terms of a polynomial in the coordinates x, q, u and v, each a product of their powers.
class Basis {
  public:
    struct Powers {
        int x = 0, q = 0, u = 0, v = 0;
    };
    void add(const Powers& term) { terms_.push_back(term); }
    Eigen::Index size() const { return static_cast<Eigen::Index>(terms_.size()); }

    /// Returns the value of each term at `at`, in the order in which the terms were added.
    Eigen::RowVectorXd values(const Coordinates& at) const;
    /// Returns the derivative of each term with respect to one coordinate.
    /// @param coordinate 0 for x, 1 for q, 2 for u, 3 for v; -1 for the values of the terms
    Eigen::RowVectorXd slopes(const Coordinates& at, int coordinate) const;

  private:
    std::vector<Powers> terms_;
};

}  // namespace pendular
