#include "calib/emulator/basis.h"

#include <cmath>

namespace pendular {
namespace {

// The stress ratio is nearly linear in the logarithm with this offset: between frictions of 0 and
// 0.4, slopes vary by a factor of 2 there, and by a factor of 9 in the friction itself. The offset
// of `emulated::place_of`, `emulated::friction_scale`, is another.
constexpr double friction_offset = 0.05;
constexpr double volume_scale = 2e-3;  // V0/a^3 in the middle of the pendular range

double power(double base, int n) {
    double product = 1;
    for (; n > 0; --n) {
        product *= base;
    }
    return product;
}

/// Derivative d(base^n)/d(base).
double derivative(double base, int n) {
    return n == 0 ? 0.0 : n * power(base, n - 1);
}

}  // namespace

double friction_coordinate(double friction, double centre) {
    return std::log((friction + friction_offset) / (centre + friction_offset));
}

double friction_at(double coordinate, double centre) {
    return (centre + friction_offset) * std::exp(coordinate) - friction_offset;
}

Coordinates coordinates(const FlowState& state, double centre, double exponent) {
    return {friction_coordinate(state.friction, centre), std::pow(state.inertial_number, exponent),
            state.inverse_pressure,
            state.dry() ? 0.0 : std::log(state.bridge_volume / volume_scale)};
}

Eigen::RowVectorXd Basis::values(const Coordinates& at) const {
    return slopes(at, -1);
}

Eigen::RowVectorXd Basis::slopes(const Coordinates& at, int coordinate) const {
    const double bases[] = {at.x, at.q, at.u, at.v};
    Eigen::RowVectorXd row(size());
    for (Eigen::Index k = 0; k < size(); ++k) {
        const Powers& p = terms_[static_cast<std::size_t>(k)];
        const int powers[] = {p.x, p.q, p.u, p.v};
        row(k) = 1;
        for (int c = 0; c < 4; ++c) {
            row(k) *=
                c == coordinate ? derivative(bases[c], powers[c]) : power(bases[c], powers[c]);
        }
    }
    return row;
}

}  // namespace pendular
