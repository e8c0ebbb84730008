#include "sim/dem/pair_forces.h"

#include <algorithm>
#include <array>

#include "sim/dem/simd.h"

namespace pendular::dem {
namespace {

constexpr std::size_t lanes = PairList::batch;
using Lane = std::array<double, lanes>;

/// One batch of pairs as seen by the contact law, in reduced units.
struct alignas(64) Batch {
    Lane rx, ry, rz;  ///< separation from the first to the second bead
    Lane vx, vy, vz;  ///< relative velocity of the centres, affine part included
    Lane wx, wy, wz;  ///< sum of the angular velocities
    Lane fx, fy, fz;  ///< force on the second bead
    Lane tx, ty, tz;  ///< torque on either bead
};

/// Sums kept per lane, so that their order does not depend on the width of the vector unit.
struct alignas(64) LaneSums {
    Lane virial_11{}, virial_22{}, virial_33{}, virial_12{}, largest_overlap{};
};

using Shifts = std::array<std::array<double, 3>, image_code::count + 1>;

Shifts image_shifts(const Cell& cell) {
    Shifts shifts;
    for (int code = 0; code < image_code::count; ++code) {
        const Image n = image_code::image(code);
        shifts[code] = {n.n1 * cell.length + n.n2 * cell.offset, n.n2 * cell.height,
                        n.n3 * cell.width};
    }
    shifts[image_code::nowhere] = {1e3, 0, 0};
    return shifts;
}

/// Reads what the contact law needs of the pairs from `begin` on.
[[gnu::always_inline]] inline void gather(const Beads& beads, const Pairs& pairs, std::size_t begin,
                                          const Shifts& shifts, const Flow& flow, Batch& b) {
    const std::int32_t* first = pairs.first.data() + begin;
    const std::int32_t* second = pairs.second.data() + begin;
    const std::uint8_t* image = pairs.image.data() + begin;
    for (std::size_t k = 0; k < lanes; ++k) {
        const auto i = first[k], j = second[k];
        const auto& shift = shifts[image[k]];
        b.rx[k] = beads.x[j] - beads.x[i] + shift[0];
        b.ry[k] = beads.y[j] - beads.y[i] + shift[1];
        b.rz[k] = beads.z[j] - beads.z[i] + shift[2];
        b.vx[k] = beads.vx[j] - beads.vx[i] + flow.shear_rate * b.ry[k];
        b.vy[k] = beads.vy[j] - beads.vy[i] + flow.height_rate * b.ry[k];
        b.vz[k] = beads.vz[j] - beads.vz[i];
        b.wx[k] = beads.wx[j] + beads.wx[i];
        b.wy[k] = beads.wy[j] + beads.wy[i];
        b.wz[k] = beads.wz[j] + beads.wz[i];
    }
}

/// Contact and capillary forces of a batch; pairs that do not touch get zeros without a branch.
/// Without bridges nothing of them is computed.
template <bool wet>
[[gnu::always_inline]] inline void near_forces(Batch& b, Pairs& pairs, std::size_t begin,
                                               const Material& material, const BridgeLaw& bridges,
                                               double dt, LaneSums& sums) {
    double* __restrict sx = pairs.sx.data() + begin;
    double* __restrict sy = pairs.sy.data() + begin;
    double* __restrict sz = pairs.sz.data() + begin;
    double* __restrict root = pairs.root.data() + begin;
    double* __restrict bridge = pairs.bridge.data() + begin;
    const double modulus = material.modulus, damping = material.damping;
    const double friction = material.friction;
    const double ratio = tangential_ratio(material.poisson_ratio);
#pragma GCC ivdep
    for (std::size_t k = 0; k < lanes; ++k) {
        // Geometry: unit normal from the first to the second bead, overlap.
        const double distance =
            std::sqrt(b.rx[k] * b.rx[k] + b.ry[k] * b.ry[k] + b.rz[k] * b.rz[k]);
        const double inverse = 1 / distance;
        const double nx = b.rx[k] * inverse, ny = b.ry[k] * inverse, nz = b.rz[k] * inverse;
        const double overlap = distance < 1 ? 1 - distance : 0.0;

        // Normal motion: elastic and viscous force.
        const double normal_speed = b.vx[k] * nx + b.vy[k] * ny + b.vz[k] * nz;
        const Hertz hertz = Hertz::at(overlap, modulus);
        double normal_force = hertz.elastic + hertz.viscous(-normal_speed, damping);
        if constexpr (wet) {
            const double gap = distance > 1 ? distance - 1 : 0.0;
            bridge[k] = bridges.joined(overlap, gap, bridge[k]);
            normal_force -= bridge[k] * bridges.pull_off_force * bridges.relative_force(gap);
        }

        // Tangential velocity of the two surfaces where they touch, at the middle of the branch.
        const double arm = distance * 0.5;
        const double tx = b.vx[k] - normal_speed * nx, ty = b.vy[k] - normal_speed * ny,
                     tz = b.vz[k] - normal_speed * nz;
        const double ux = tx - arm * (b.wy[k] * nz - b.wz[k] * ny);
        const double uy = ty - arm * (b.wz[k] * nx - b.wx[k] * nz);
        const double uz = tz - arm * (b.wx[k] * ny - b.wy[k] * nx);

        // The remembered force turns with the normal and spins about it: s += dt Omega x s, and
        // what points along the new normal is dropped.
        const double spin = 0.5 * (b.wx[k] * nx + b.wy[k] * ny + b.wz[k] * nz);
        const double ox = (ny * tz - nz * ty) * inverse + spin * nx;
        const double oy = (nz * tx - nx * tz) * inverse + spin * ny;
        const double oz = (nx * ty - ny * tx) * inverse + spin * nz;
        double px = sx[k] + dt * (oy * sz[k] - oz * sy[k]);
        double py = sy[k] + dt * (oz * sx[k] - ox * sz[k]);
        double pz = sz[k] + dt * (ox * sy[k] - oy * sx[k]);
        const double along = px * nx + py * ny + pz * nz;

        // Unloading, the elastic increment of this step, and the Coulomb limit.
        const double kept = unloading_factor(hertz.root, root[k]);
        const double stiffness = dt * ratio * hertz.normal_stiffness;
        px = kept * (px - along * nx) - stiffness * ux;
        py = kept * (py - along * ny) - stiffness * uy;
        pz = kept * (pz - along * nz) - stiffness * uz;
        const double allowed =
            coulomb_factor(px * px + py * py + pz * pz, friction * hertz.elastic);
        sx[k] = px * allowed;
        sy[k] = py * allowed;
        sz[k] = pz * allowed;
        root[k] = hertz.root;

        // Force on the second bead; the torque -(arm) n x s acts on both.
        b.fx[k] = normal_force * nx + sx[k];
        b.fy[k] = normal_force * ny + sy[k];
        b.fz[k] = normal_force * nz + sz[k];
        b.tx[k] = -arm * (ny * sz[k] - nz * sy[k]);
        b.ty[k] = -arm * (nz * sx[k] - nx * sz[k]);
        b.tz[k] = -arm * (nx * sy[k] - ny * sx[k]);

        sums.virial_11[k] += b.fx[k] * b.rx[k];
        sums.virial_22[k] += b.fy[k] * b.ry[k];
        sums.virial_33[k] += b.fz[k] * b.rz[k];
        sums.virial_12[k] += b.fx[k] * b.ry[k];
        sums.largest_overlap[k] =
            overlap > sums.largest_overlap[k] ? overlap : sums.largest_overlap[k];
    }
}

[[gnu::always_inline]] inline void scatter(const Batch& b, const Pairs& pairs, std::size_t begin,
                                           Beads& beads) {
    for (std::size_t k = 0; k < lanes; ++k) {
        const auto i = pairs.first[begin + k], j = pairs.second[begin + k];
        beads.fx[j] += b.fx[k], beads.fy[j] += b.fy[k], beads.fz[j] += b.fz[k];
        beads.fx[i] -= b.fx[k], beads.fy[i] -= b.fy[k], beads.fz[i] -= b.fz[k];
        beads.tx[j] += b.tx[k], beads.ty[j] += b.ty[k], beads.tz[j] += b.tz[k];
        beads.tx[i] += b.tx[k], beads.ty[i] += b.ty[k], beads.tz[i] += b.tz[k];
    }
}

/// Attraction of a batch of distant pairs.
[[gnu::always_inline]] inline void distant_batch(const Beads& beads, Pairs& pairs,
                                                 std::size_t begin, const Shifts& shifts,
                                                 const BridgeLaw& bridges, Batch& b,
                                                 LaneSums& sums) {
    const std::int32_t* first = pairs.first.data() + begin;
    const std::int32_t* second = pairs.second.data() + begin;
    const std::uint8_t* image = pairs.image.data() + begin;
    double* __restrict bridge = pairs.bridge.data() + begin;
    for (std::size_t k = 0; k < lanes; ++k) {
        const auto i = first[k], j = second[k];
        const auto& shift = shifts[image[k]];
        b.rx[k] = beads.x[j] - beads.x[i] + shift[0];
        b.ry[k] = beads.y[j] - beads.y[i] + shift[1];
        b.rz[k] = beads.z[j] - beads.z[i] + shift[2];
    }
#pragma GCC ivdep
    for (std::size_t k = 0; k < lanes; ++k) {
        const double distance =
            std::sqrt(b.rx[k] * b.rx[k] + b.ry[k] * b.ry[k] + b.rz[k] * b.rz[k]);
        const double gap = distance > 1 ? distance - 1 : 0.0;
        bridge[k] = bridges.joined(0.0, gap, bridge[k]);
        const double over_distance =
            -bridge[k] * bridges.pull_off_force * bridges.relative_force(gap) / distance;
        b.fx[k] = over_distance * b.rx[k];
        b.fy[k] = over_distance * b.ry[k];
        b.fz[k] = over_distance * b.rz[k];
        sums.virial_11[k] += b.fx[k] * b.rx[k];
        sums.virial_22[k] += b.fy[k] * b.ry[k];
        sums.virial_33[k] += b.fz[k] * b.rz[k];
        sums.virial_12[k] += b.fx[k] * b.ry[k];
    }
}

[[gnu::always_inline]] inline void scatter_forces(const Batch& b, const Pairs& pairs,
                                                  std::size_t begin, Beads& beads) {
    for (std::size_t k = 0; k < lanes; ++k) {
        const auto i = pairs.first[begin + k], j = pairs.second[begin + k];
        beads.fx[j] += b.fx[k], beads.fy[j] += b.fy[k], beads.fz[j] += b.fz[k];
        beads.fx[i] -= b.fx[k], beads.fy[i] -= b.fy[k], beads.fz[i] -= b.fz[k];
    }
}

double sum(const Lane& lane) {
    double total = 0;
    for (const double value : lane) {
        total += value;
    }
    return total;
}

}  // namespace

PENDULAR_SIMD_CLONES
PairSums pair_forces(Beads& beads, Pairs& pairs, const Cell& cell, const Flow& flow,
                     const Material& material, double dt, const BridgeLaw& bridges) {
    for (auto* column : {&beads.fx, &beads.fy, &beads.fz, &beads.tx, &beads.ty, &beads.tz}) {
        std::fill(column->begin(), column->end(), 0.0);
    }
    const Shifts shifts = image_shifts(cell);
    Batch batch;
    LaneSums sums;
    for (std::size_t begin = 0; begin < pairs.size(); begin += lanes) {
        gather(beads, pairs, begin, shifts, flow, batch);
        if (bridges.wet()) {
            near_forces<true>(batch, pairs, begin, material, bridges, dt, sums);
        } else {
            near_forces<false>(batch, pairs, begin, material, bridges, dt, sums);
        }
        scatter(batch, pairs, begin, beads);
    }
    return {sum(sums.virial_11), sum(sums.virial_22), sum(sums.virial_33), sum(sums.virial_12),
            *std::ranges::max_element(sums.largest_overlap)};
}

PENDULAR_SIMD_CLONES
void distant_forces(Beads& beads, Pairs& distant, const Cell& cell, const BridgeLaw& bridges,
                    PairSums& total) {
    const Shifts shifts = image_shifts(cell);
    Batch batch;
    LaneSums sums;
    for (std::size_t begin = 0; begin < distant.size(); begin += lanes) {
        distant_batch(beads, distant, begin, shifts, bridges, batch, sums);
        scatter_forces(batch, distant, begin, beads);
    }
    total.virial_11 += sum(sums.virial_11);
    total.virial_22 += sum(sums.virial_22);
    total.virial_33 += sum(sums.virial_33);
    total.virial_12 += sum(sums.virial_12);
}

}  // namespace pendular::dem
