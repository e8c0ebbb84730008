#include "sim/dem/viscous_loss.h"

#include "sim/dem/pair_lanes.h"
#include "sim/dem/vector.h"

namespace pendular::dem {
namespace {

/// Returns the motion of the grains with velocities halfway through the step that these net forces
/// cause.
[[gnu::always_inline]] inline std::vector<Grains::Motion> halfway_through(
    const Grains& grains, const std::vector<Grains::ForceAndTorque>& net_forces,
    const PairLaws& laws) {
    std::vector<Grains::Motion> halfway = grains.motion;
    for (std::size_t i = 0; i < halfway.size(); ++i) {
        const Vector acceleration =
            1 / grains.mass(i) * net_forces[i].force - laws.flow(grains.motion[i].velocity);
        halfway[i].velocity += 0.5 * laws.time_step * acceleration;
    }
    return halfway;
}

}  // namespace

PENDULAR_SIMD_CLONES
double viscous_loss(const Grains& grains, const std::vector<Grains::ForceAndTorque>& net_forces,
                    const Pairs& near, const PairLaws& laws) {
    const std::vector<Grains::Motion> halfway = halfway_through(grains, net_forces, laws);
    const Shifts shifts = image_shifts(laws.cell);
    const Material material = laws.material;
    const Flow flow = laws.flow;
    SizeLanes sizes;
    sizes.set_equal();
    Batch before, mean;
    Lane loss{};
    for (std::size_t begin = 0; begin < near.size(); begin += lanes) {
        if (!grains.diameters.empty()) {
            gather_sizes(grains, near, begin, sizes);
        }
        gather<Gathered::motion>(grains.motion.data(), near, begin, shifts, sizes, before);
        gather<Gathered::motion>(halfway.data(), near, begin, shifts, sizes, mean);
        const double* __restrict root = near.root.data() + begin;  // 0 where there is no contact
        for (std::size_t k = 0; k < lanes; ++k) {
            const Hertz hertz = hertz_contact(root[k] * root[k], sizes[k], material.modulus);
            const double speed = ContactKinematics::of(before.motion(k), flow).normal_speed;
            const double mean_speed = ContactKinematics::of(mean.motion(k), flow).normal_speed;
            loss[k] -= laws.time_step * viscous_force(hertz, speed, sizes[k], material.damping) *
                       mean_speed;
        }
    }
    return sum(loss);
}

}  // namespace pendular::dem
