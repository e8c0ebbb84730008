#include "sim/dem/integrator.h"

#include <algorithm>
#include <utility>

#include "sim/dem/simd.h"

namespace pendular::dem {

MotionSums& MotionSums::operator+=(const MotionSums& other) {
    squares += other.squares;
    shear += other.shear;
    spin += other.spin;
    largest_squared = std::max(largest_squared, other.largest_squared);
    return *this;
}

double MotionSums::energy() const {
    return 0.5 * (squares[0] + squares[1] + squares[2]) + 0.5 * moment_of_inertia * spin;
}

namespace {

template <bool sized>
[[gnu::always_inline]] inline MotionSums advance_all(Beads& beads,
                                                     std::pair<std::size_t, std::size_t> range,
                                                     std::vector<Beads::Load>& loads,
                                                     const Flow& flow, double time_step) {
    Vector squares, shear, spin;
    double largest_squared = 0;
    for (std::size_t i = range.first; i < range.second; ++i) {
        Beads::Load load = std::exchange(loads[i], {});
        Beads::Motion& bead = beads.motion[i];
        if constexpr (sized) {
            const double d = beads.diameters[i], lightness = 1 / beads.mass(i);
            load.force = lightness * load.force;
            load.torque = lightness / (d * d) * load.torque;
        }
        const Vector v = bead.velocity + time_step * (load.force - flow(bead.velocity));
        const Vector w = bead.spin + time_step / moment_of_inertia * load.torque;
        const Vector moved = time_step * v;
        const Vector displacement = beads.displacement[i] + moved;
        bead.velocity = v;
        bead.spin = w;
        bead.position += moved + time_step * flow(bead.position);
        beads.displacement[i] = displacement;
        if constexpr (sized) {
            const double d = beads.diameters[i], mass = beads.mass(i);
            squares += mass * (v * v);
            shear += mass * v[1] * v;
            spin += mass * d * d * (w * w);
        } else {
            squares += v * v;
            shear += v[1] * v;
            spin += w * w;
        }
        largest_squared = std::max(largest_squared, dot(displacement, displacement));
    }
    return {squares, shear[0], spin[0] + spin[1] + spin[2], largest_squared};
}

}  // namespace

PENDULAR_SIMD_CLONES
MotionSums advance(Beads& beads, std::pair<std::size_t, std::size_t> range,
                   std::vector<Beads::Load>& loads, const Flow& flow, double time_step) {
    return beads.diameters.empty() ? advance_all<false>(beads, range, loads, flow, time_step)
                                   : advance_all<true>(beads, range, loads, flow, time_step);
}

}  // namespace pendular::dem
