#pragma once

#include <Eigen/Core>
#include <vector>

#include "data/effect_parameter.h"

namespace pendular {

/// State of steady shear that the emulator predicts: the quantities that determine it.
struct FlowState {
    double friction = 0;
    double inertial_number = 0;
    double inverse_pressure = 0;             ///< 1/P*; 0: dry
    double bridge_volume = 0;                ///< V0/a^3; of no consequence where dry
    std::vector<EffectValues> effects = {};  ///< on grains, in the units of a run

    bool dry() const { return inverse_pressure == 0; }
};

/// Coordinates in which responses are nearly straight.
struct Coordinates {
    double x = 0;  ///< ln[(friction + 0.05)/(centre + 0.05)]
    double q = 0;  ///< I^exponent
    double u = 0;  ///< 1/P*
    double v = 0;  ///< ln(V0/a^3/0.002)

    bool operator==(const Coordinates&) const = default;
};

/// Coordinates of a state about a centre in friction. From friction 0 to 0.4 the slopes of stress
/// ratio and solid fraction in x change by about a factor 2, that of the stress ratio in friction
/// itself by 9.
Coordinates coordinates(const FlowState& state, double centre, double exponent);

/// x of a friction about a centre, and back.
double friction_coordinate(double friction, double centre);
double friction_at(double coordinate, double centre);
/// dx/d(friction).
double friction_slope(double friction);

/// Products of powers of the coordinates.
class Basis {
  public:
    struct Powers {
        int x = 0, q = 0, u = 0, v = 0;
    };
    void add(const Powers& term) { terms_.push_back(term); }
    Eigen::Index size() const { return static_cast<Eigen::Index>(terms_.size()); }

    Eigen::RowVectorXd values(const Coordinates& at) const;
    /// Derivatives of the values in one coordinate, by its place in `Coordinates`.
    Eigen::RowVectorXd slopes(const Coordinates& at, int coordinate) const;
    Eigen::RowVectorXd slopes_in_x(const Coordinates& at) const { return slopes(at, 0); }
    Eigen::RowVectorXd slopes_in_v(const Coordinates& at) const { return slopes(at, 3); }

  private:
    std::vector<Powers> terms_;
};

/// Number of values that differ from each other by more than `share` of their size.
std::size_t distinct(std::vector<double> values, double share);

}  // namespace pendular
