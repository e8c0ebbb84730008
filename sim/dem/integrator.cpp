#include "sim/dem/integrator.h"

#include <algorithm>
#include <utility>

#include "sim/dem/vector.h"

namespace pendular::dem {

MotionSums& MotionSums::operator+=(const MotionSums& other) {
    squares += other.squares;
    shear += other.shear;
    angular_velocity += other.angular_velocity;
    largest_squared = std::max(largest_squared, other.largest_squared);
    return *this;
}

double MotionSums::energy() const {
    return 0.5 * (squares[0] + squares[1] + squares[2]) +
           0.5 * moment_of_inertia * angular_velocity;
}

namespace {

template <bool sized>
[[gnu::always_inline]] inline MotionSums advance_all(
    Grains& grains, std::pair<std::size_t, std::size_t> range,
    std::vector<Grains::ForceAndTorque>& net_forces, const Flow& flow, double time_step) {
    Vector squares, shear, angular_velocity;
    double largest_squared = 0;
    for (std::size_t i = range.first; i < range.second; ++i) {
        Grains::ForceAndTorque net_force = std::exchange(net_forces[i], {});
        Grains::Motion& grain = grains.motion[i];
        if constexpr (sized) {
            const double d = grains.diameters[i], lightness = 1 / grains.mass(i);
            net_force.force = lightness * net_force.force;
            net_force.torque = lightness / (d * d) * net_force.torque;
        }
        const Vector v = grain.velocity + time_step * (net_force.force - flow(grain.velocity));
        const Vector w = grain.angular_velocity + time_step / moment_of_inertia * net_force.torque;
        const Vector moved = time_step * v;
        const Vector displacement = grains.displacement[i] + moved;
        grain.velocity = v;
        grain.angular_velocity = w;
        grain.position += moved + time_step * flow(grain.position);
        grains.displacement[i] = displacement;
        if constexpr (sized) {
            const double d = grains.diameters[i], mass = grains.mass(i);
            squares += mass * (v * v);
            shear += mass * v[1] * v;
            angular_velocity += mass * d * d * (w * w);
        } else {
            squares += v * v;
            shear += v[1] * v;
            angular_velocity += w * w;
        }
        largest_squared = std::max(largest_squared, dot(displacement, displacement));
    }
    return {squares, shear[0], angular_velocity[0] + angular_velocity[1] + angular_velocity[2],
            largest_squared};
}

}  // namespace

PENDULAR_SIMD_CLONES
MotionSums advance(Grains& grains, std::pair<std::size_t, std::size_t> range,
                   std::vector<Grains::ForceAndTorque>& net_forces, const Flow& flow,
                   double time_step) {
    return grains.diameters.empty() ? advance_all<false>(grains, range, net_forces, flow, time_step)
                                    : advance_all<true>(grains, range, net_forces, flow, time_step);
}

}  // namespace pendular::dem
