#include "data/sheared_layer.h"

#include <algorithm>
#include <array>
#include <boost/math/tools/toms748_solve.hpp>
#include <cmath>
#include <cstdint>

namespace pendular {
namespace {

/// d(stress ratio)/dI of uniform shear [1]: friction 0.12, I from 0 to 0.1, by simulation; 0.88 to
/// 0.96 in parts of this range.
constexpr double slope = 0.93;
/// Reach A of the motion of neighbours [diameters]: 0.4 fits the heights of sheared layers in
/// bench/real_cell, 0.3 to 0.5 about as well; 0.48 is published for glass beads.
constexpr double decay_reach = 0.4;
/// Normal stress on the side walls over that on horizontal planes [1], in the sheared layers of
/// bench/real_cell; 0.94 in flow without walls.
constexpr double lateral_stress_ratio = 0.85;

/// Three times as many change the stress ratio at the lid by at most 0.3 % for beds of up to 80
/// diameters; a bed of 200 between rough walls 10 apart would need more (8 %).
constexpr int slices = 40;
using Slices = std::array<double, slices>;

/// Bed in slices of equal height, from the lid down.
class SlicedBed {
  public:
    explicit SlicedBed(const WalledBed& bed)
        : step_(bed.height / slices),
          slope_(slope_of(bed)),
          quasi_static_(bed.stress_ratio - slope_ * bed.inertial_number) {
        const double drag = 2 * bed.wall_friction * lateral_stress_ratio / bed.width;
        for (int k = 0; k < slices; ++k) {
            const double depth = (k + 0.5) * step_, share = bed.weight * depth / bed.height;
            of_load_[at(k)] = 1 / (1 + share);
            rate_unit_[at(k)] = std::sqrt(1 + share) / slope_;
            drag_[at(k)] = drag * depth * (1 + share / 2);
        }
    }

    /// Shear rates in the slices, in units of sqrt(load diameter/mass), at a stress ratio at the
    /// lid.
    Slices rates(double at_lid) const;
    double speed(double at_lid) const {
        double sum = 0;
        for (const double rate : rates(at_lid))
            sum += rate * step_;
        return sum;
    }
    double step() const { return step_; }

  private:
    static std::size_t at(int k) { return static_cast<std::size_t>(k); }
    /// Grains of a small stress ratio cannot owe more than half of it to their speed.
    static double slope_of(const WalledBed& bed) {
        return std::min(slope, 0.5 * bed.stress_ratio / bed.inertial_number);
    }

    double step_, slope_, quasi_static_;
    Slices of_load_, rate_unit_, drag_;
};

Slices SlicedBed::rates(double at_lid) const {
    // Thomas' algorithm for g_(k-1) - (2 + w) g_k + g_(k+1) = -w g_local; no gradient at the ends.
    Slices ratio, above, right, rate;
    const double scale = step_ * step_ / (decay_reach * decay_reach);
    double above_before = 0, right_before = 0;
    for (int k = 0; k < slices; ++k) {
        // Far below the lid the walls would carry more than there is.
        const double own = std::max((at_lid - drag_[at(k)]) * of_load_[at(k)], 1e-3);
        const double excess = own - quasi_static_;
        const double local = std::max(excess, 0.0) * rate_unit_[at(k)] / own;
        const double weight = std::max(std::abs(excess), 1e-6) * scale;
        const double before = k > 0 ? 1 : 0, after = k + 1 < slices ? 1 : 0;
        const double pivot = 1 / (before + after + weight - before * above_before);
        ratio[at(k)] = own;
        above[at(k)] = above_before = after * pivot;
        right[at(k)] = right_before = (weight * local + before * right_before) * pivot;
    }
    double fluidity = 0;
    for (int k = slices - 1; k >= 0; --k) {
        fluidity = right[at(k)] + above[at(k)] * fluidity;
        rate[at(k)] = fluidity * ratio[at(k)];
    }
    return rate;
}

/// Stress ratio at the lid at which the lid has a speed, which rises with the ratio.
double ratio_at_speed(const SlicedBed& bed, double speed, double low, double high) {
    if (bed.speed(low) >= speed) return low;
    if (bed.speed(high) <= speed) return high;
    // To 1e-13 of the ratio, since fits take differences of it over 1e-5.
    const boost::math::tools::eps_tolerance<double> close(44);
    std::uintmax_t most_steps = 100;
    const auto [below, above] = boost::math::tools::toms748_solve(
        [&](double ratio) { return bed.speed(ratio) - speed; }, low, high, close, most_steps);
    return (below + above) / 2;
}

}  // namespace

ShearedLayer sheared_layer(const WalledBed& bed) {
    // At rest, as close to it as makes no difference: I = 1e-4 adds 1e-4 to the stress ratio.
    WalledBed moving = bed;
    moving.inertial_number = std::max(bed.inertial_number, 1e-4);
    const SlicedBed sliced(moving);
    const double speed = moving.inertial_number * bed.height;
    // In uniform shear the stress ratio would be enough without drag and weight; with them, the
    // ratio at the base is, if that at the lid is larger by all that they take.
    const double all = 2 * bed.wall_friction * bed.height / bed.width;
    const double most = (bed.stress_ratio + all) * (1 + bed.weight) + 0.01;
    const double ratio = ratio_at_speed(sliced, speed, 0.5 * bed.stress_ratio, most);
    double sum = 0, squares = 0;
    for (const double rate : sliced.rates(ratio)) {
        sum += rate;
        squares += rate * rate;
    }
    return {sum * sum * sliced.step() / squares, ratio};
}

}  // namespace pendular
