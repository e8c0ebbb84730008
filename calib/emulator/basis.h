#pragma once

#include <Eigen/Core>
#include <vector>

#include "data/effect_parameter.h"

namespace pendular {

/// State of steady shear at which the emulator predicts, given by the quantities that determine it.
struct FlowState {
    double friction = 0;          ///< friction coefficient of the contacts [1]
    double inertial_number = 0;   ///< I [1]; 0: the quasi-static limit
    double inverse_pressure = 0;  ///< 1/P*, inverse of the reduced pressure [1]; 0: dry
    double bridge_volume = 0;     ///< V0/a^3 [1]; ignored where dry
    /// Effects on grains that act in this state, with values in the units of a run (grain diameter,
    /// grain mass and normal stress are 1).
    std::vector<EffectValues> effects = {};
    /// Stiffness number of the grains [1]. It changes coordination numbers and other observables of
    /// structure by an `EffectResponse`; 0: that of the emulator's training runs for structure.
    double stiffness_number = 0;

    bool dry() const { return inverse_pressure == 0; }
};

/// Coordinates of a flow state in which observables of the flow are nearly linear, all
/// dimensionless.
struct Coordinates {
    /// Friction: ln[(friction + 0.05)/(centre + 0.05)] with a chosen friction `centre`;
    /// `emulated::place_of` has 0.02 for 0.05.
    double x = 0;
    double q = 0;  ///< inertial number: I^exponent
    double u = 0;  ///< inverse reduced pressure: 1/P*
    double v = 0;  ///< bridge volume: ln(V0/a^3/0.002); 0 where dry

    bool operator==(const Coordinates&) const = default;
};

/// Returns the coordinates of a flow state, with x = 0 at the friction `centre` and q =
/// I^`exponent`. From friction 0 to 0.4 the slopes of stress ratio and solid fraction in x change
/// by about a factor 2; the slope of the stress ratio in friction itself changes by a factor 9.
Coordinates coordinates(const FlowState& state, double centre, double exponent);

/// Coordinate x = ln[(friction + 0.05)/(centre + 0.05)] of a friction coefficient [1].
double friction_coordinate(double friction, double centre);
/// Friction coefficient [1] at a coordinate x: the inverse of `friction_coordinate`.
double friction_at(double coordinate, double centre);
/// Derivative dx/d(friction) of `friction_coordinate` = 1/(friction + 0.05).
double friction_slope(double friction);

/// Terms of a polynomial in the coordinates of a flow state: products of powers of x, q, u and v.
class Basis {
  public:
    /// Exponents of the coordinates x, q, u and v in one term of the polynomial.
    struct Powers {
        int x = 0, q = 0, u = 0, v = 0;
    };
    void add(const Powers& term) { terms_.push_back(term); }
    Eigen::Index size() const { return static_cast<Eigen::Index>(terms_.size()); }

    /// Value of each term (product of powers) at a place.
    Eigen::RowVectorXd values(const Coordinates& at) const;
    /// Derivative of each term (product of powers) by one coordinate at a place: 0 for x, 1 for q,
    /// 2 for u, 3 for v; -1 gives the values.
    Eigen::RowVectorXd slopes(const Coordinates& at, int coordinate) const;
    Eigen::RowVectorXd slopes_in_x(const Coordinates& at) const { return slopes(at, 0); }
    Eigen::RowVectorXd slopes_in_v(const Coordinates& at) const { return slopes(at, 3); }

  private:
    std::vector<Powers> terms_;
};

/// Number of distinct values among `values`; a value counts together with a smaller one where their
/// difference is at most `share` [1] times the larger one's magnitude.
std::size_t distinct(std::vector<double> values, double share);

}  // namespace pendular
