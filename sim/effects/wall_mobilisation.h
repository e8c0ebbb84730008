#pragma once

#include <algorithm>
#include <cmath>

namespace pendular {

/// Friction at flat side walls, as simulated cells show it (bench/real_cell,
/// docs/explanation/cell.md).
///
/// A grain at the wall slides with the mean velocity v of its layer and with fluctuations of the
/// other grains' making, in all directions along the wall. Friction opposes the sum of both. Where
/// v is much larger than the fluctuations, all of it acts against the flow; where it is smaller, as
/// in a creeping bed or a diameter or two above a base at rest, most of it cancels. Fluctuations of
/// normal distribution, delta in each direction, leave the share
///     sqrt(pi/8) x exp(-x^2/4) (I0(x^2/4) + I1(x^2/4)),   x = v/delta,
/// which tanh(0.64 x) is within 0.03. Over rate x diameter, fluctuations grow in slow shear:
/// delta/(a rate) = 2.4 (I/0.03)^-0.16 fits the cells 24 diameters wide and 12 high at wall
/// frictions 0.05, 0.15 and 0.3 (I from 0.001 to 0.15), rms 0.05. Without the power, narrow cells
/// are missed by 0.13. Source of the idea: Artoni and Richard, Phys. Rev. Lett. 115 (2015) 158001.

/// Velocity over shear rate at which fluctuations cancel a quarter of the friction along the flow
/// [diameters]: the argument of the tanh is 1. The inertial numbers are those of the cells.
inline double sliding_length(double inertial_number) {
    return 3.8 * std::pow(std::clamp(inertial_number, 0.001, 0.15) / 0.03, -0.16);
}

/// Share of the friction across the flow, by which walls carry load, in that of the walls [1], on
/// which grains that roll show less. In the same cells 0.05, 0.08 and 0.09 at wall frictions 0.05,
/// 0.15 and 0.3, at any depth: grains do not move down on average, and by symmetry it would be 0.
constexpr double carrying_share = 0.09;

/// Share of the friction of a sliding grain that acts along the flow [1], at a velocity over shear
/// rate in diameters.
inline double mobilised_share(double velocity_over_rate, double inertial_number) {
    return std::tanh(velocity_over_rate / sliding_length(inertial_number));
}

/// Mean of that share over the upper half of an evenly sheared bed [1], where velocity over rate is
/// the height above the base: 0.97 at 12 diameters and I = 0.03, 0.87 there at I = 0.001.
///     (2/x) (ln cosh x - ln cosh(x/2)),   x = height/sliding_length
inline double mobilised_in_upper_half(double diameters, double inertial_number) {
    const double x = diameters / sliding_length(inertial_number);
    return 1 + 2 / x * (std::log1p(std::exp(-2 * x)) - std::log1p(std::exp(-x)));
}

}  // namespace pendular
