#include "sim/dem/shear_cell.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <random>
#include <stdexcept>
#include <utility>
#include <vector>

#include "sim/dem/simd.h"
#include "sim/dem/simulation_error.h"

namespace pendular::dem {
namespace {

constexpr double bead_volume = std::numbers::pi / 6;
constexpr double initial_solid_fraction = 0.3;
constexpr double initial_closing_rate = 0.05;
constexpr double steady_solid_fraction = 0.62;
constexpr double servo_modulus = 0.05;
constexpr int steps_between_time_steps = 20;

/// Sums of v v over the beads, in eight interleaved parts so that lanes do not change their order.
struct KineticSums {
    double xx[8] = {}, yy[8] = {}, zz[8] = {}, xy[8] = {};
    static double sum(const double (&part)[8]) {
        return ((part[0] + part[1]) + (part[2] + part[3])) +
               ((part[4] + part[5]) + (part[6] + part[7]));
    }
};

/// Velocities by one step: dv/dt = f - L v with L the imposed velocity gradient, since v is
/// peculiar.
PENDULAR_SIMD_CLONES
void advance_velocities(Beads& beads, const Flow& flow, double dt) {
    const std::size_t n = beads.size();
    double* __restrict vx = beads.vx.data();
    double* __restrict vy = beads.vy.data();
    double* __restrict vz = beads.vz.data();
    const double* __restrict fx = beads.fx.data();
    const double* __restrict fy = beads.fy.data();
    const double* __restrict fz = beads.fz.data();
    for (std::size_t i = 0; i < n; ++i) {
        const double up = vy[i];
        vx[i] += dt * (fx[i] - flow.shear_rate * up);
        vy[i] += dt * (fy[i] - flow.height_rate * up);
        vz[i] += dt * fz[i];
    }
    for (auto [w, t] : {std::pair(&beads.wx, &beads.tx), std::pair(&beads.wy, &beads.ty),
                        std::pair(&beads.wz, &beads.tz)}) {
        double* __restrict rate = w->data();
        const double* __restrict torque = t->data();
        for (std::size_t i = 0; i < n; ++i) {
            rate[i] += dt / moment_of_inertia * torque[i];
        }
    }
}

/// Positions by one step: dx/dt = v + L x.
PENDULAR_SIMD_CLONES
void advance_positions(Beads& beads, const Flow& flow, double dt) {
    const std::size_t n = beads.size();
    double* __restrict x = beads.x.data();
    double* __restrict y = beads.y.data();
    double* __restrict z = beads.z.data();
    double* __restrict ux = beads.ux.data();
    double* __restrict uy = beads.uy.data();
    double* __restrict uz = beads.uz.data();
    const double* __restrict vx = beads.vx.data();
    const double* __restrict vy = beads.vy.data();
    const double* __restrict vz = beads.vz.data();
    for (std::size_t i = 0; i < n; ++i) {
        const double dx = dt * vx[i], dy = dt * vy[i], dz = dt * vz[i];
        x[i] += dx + dt * flow.shear_rate * y[i];
        y[i] += dy + dt * flow.height_rate * y[i];
        z[i] += dz;
        ux[i] += dx;
        uy[i] += dy;
        uz[i] += dz;
    }
}

PENDULAR_SIMD_CLONES
KineticSums kinetic_sums(const Beads& beads) {
    KineticSums sums;
    const std::size_t n = beads.size(), whole = n / 8 * 8;
    const double* __restrict vx = beads.vx.data();
    const double* __restrict vy = beads.vy.data();
    const double* __restrict vz = beads.vz.data();
    const auto add = [&](std::size_t i, std::size_t lane) {
        sums.xx[lane] += vx[i] * vx[i];
        sums.yy[lane] += vy[i] * vy[i];
        sums.zz[lane] += vz[i] * vz[i];
        sums.xy[lane] += vx[i] * vy[i];
    };
    for (std::size_t i = 0; i < whole; i += 8) {
        for (std::size_t lane = 0; lane < 8; ++lane) {
            add(i + lane, lane);
        }
    }
    for (std::size_t i = whole; i < n; ++i) {
        add(i, i - whole);
    }
    return sums;
}

/// Uniform in [0, 1) with 53 bits, the same on every platform.
double uniform(std::mt19937_64& random) {
    return static_cast<double>(random() >> 11) * 0x1p-53;
}

/// Places at random, each no closer than one diameter to those before it, by bins of one diameter.
class RandomPlacement {
  public:
    explicit RandomPlacement(const std::array<double, 3>& edge) : edge_(edge) {
        std::size_t bins = 1;
        for (int d = 0; d < 3; ++d) {
            count_[d] = static_cast<int>(edge[d]);
            bins *= static_cast<std::size_t>(count_[d]);
        }
        bins_.resize(bins);
    }

    /// Takes the place where it is free.
    bool place(const std::array<double, 3>& at) {
        for (int step = 0; step < 27; ++step) {
            for (const auto& other :
                 bins_[bin(at, {step % 3 - 1, step / 3 % 3 - 1, step / 9 - 1})]) {
                double squared = 0;
                for (int d = 0; d < 3; ++d) {
                    const double apart = at[d] - other[d];
                    const double nearest = apart - edge_[d] * std::round(apart / edge_[d]);
                    squared += nearest * nearest;
                }
                if (squared < 1) {
                    return false;
                }
            }
        }
        bins_[bin(at, {0, 0, 0})].push_back(at);
        return true;
    }

  private:
    std::size_t bin(const std::array<double, 3>& at, const std::array<int, 3>& step) const {
        std::size_t index = 0;
        for (int d = 0; d < 3; ++d) {
            const int b = static_cast<int>(at[d] / edge_[d] * count_[d]) + step[d];
            index = index * count_[d] + static_cast<std::size_t>((b + count_[d]) % count_[d]);
        }
        return index;
    }
    std::array<double, 3> edge_;
    std::array<int, 3> count_{};
    std::vector<std::vector<std::array<double, 3>>> bins_;
};

}  // namespace

ShearCell::ShearCell(int count, const Material& material, double shear_rate, std::uint64_t seed,
                     const BridgeLaw& bridges)
    : beads_(static_cast<std::size_t>(count < fewest_beads ? 0 : count)),
      pairs_(bridges.rupture_distance),
      material_(material),
      bridges_(bridges) {
    if (count < fewest_beads) {
        throw std::invalid_argument("a sample needs at least 64 beads");
    }
    flow_.shear_rate = shear_rate;
    place_at_random(seed);
    recent_overlap_ = overlap_at(1.0, material_.modulus);
    follow_stiffest_contact();
    pairs_.rebuild(beads_, cell_);
}

double ShearCell::edge(int count) {
    return std::cbrt(count * bead_volume / steady_solid_fraction);
}

void ShearCell::place_at_random(std::uint64_t seed) {
    // Tall enough that the sample is a cube once it flows.
    const double solid = static_cast<double>(beads_.size()) * bead_volume;
    const double base = edge(static_cast<int>(beads_.size()));
    cell_ = {base, solid / initial_solid_fraction / (base * base), base, 0};
    RandomPlacement placement({cell_.length, cell_.height, cell_.width});
    std::mt19937_64 random(seed);
    for (std::size_t i = 0; i < beads_.size(); ++i) {
        do {
            beads_.x[i] = cell_.length * uniform(random);
            beads_.y[i] = cell_.height * uniform(random);
            beads_.z[i] = cell_.width * uniform(random);
        } while (!placement.place({beads_.x[i], beads_.y[i], beads_.z[i]}));
    }
}

double ShearCell::solid_fraction() const {
    return static_cast<double>(beads_.size()) * bead_volume / cell_.volume();
}

void ShearCell::step() {
    const BridgeLaw bridges = servo_ ? bridges_ : BridgeLaw();
    PairSums sums =
        pair_forces(beads_, pairs_.narrow(), cell_, flow_, material_, time_step_, bridges);
    if (bridges.wet()) {
        distant_forces(beads_, pairs_.distant(), cell_, bridges, sums);
    }
    measure_stress(sums);
    check_state();
    if (servo_) {
        const double modulus = servo_modulus * std::cbrt(material_.modulus * material_.modulus);
        flow_.height_rate = (stress_.s22 - 1) / modulus;
    }
    advance();
    ++steps_;
    if (steps_ % steps_between_time_steps == 0 || largest_overlap_ > 2 * recent_overlap_) {
        follow_stiffest_contact();
    }
}

void ShearCell::measure_stress(const PairSums& sums) {
    const KineticSums kinetic = kinetic_sums(beads_);
    const double volume = cell_.volume();
    stress_.s11 = (sums.virial_11 + KineticSums::sum(kinetic.xx)) / volume;
    stress_.s22 = (sums.virial_22 + KineticSums::sum(kinetic.yy)) / volume;
    stress_.s33 = (sums.virial_33 + KineticSums::sum(kinetic.zz)) / volume;
    stress_.s12 = (sums.virial_12 + KineticSums::sum(kinetic.xy)) / volume;
    largest_overlap_ = sums.largest_overlap;
    recent_overlap_ = std::max(recent_overlap_, largest_overlap_);
}

void ShearCell::check_state() const {
    // At once, before a position that is no number reaches the bins of the neighbour search.
    if (!std::isfinite(stress_.s22) || largest_overlap_ > 0.5) {
        throw SimulationError(fmt::format(
            "the simulation blew up at strain {:.3g} (largest overlap {:.2g} diameters); "
            "lower the damping or the inertial number, or raise the stiffness number",
            strain_, largest_overlap_));
    }
}

void ShearCell::advance() {
    const double dt = time_step_;
    advance_velocities(beads_, flow_, dt);
    advance_positions(beads_, flow_, dt);
    // The image of a bead one height up moves by exactly what the bead's own law gives it there.
    cell_.offset += dt * flow_.shear_rate * cell_.height;
    cell_.height += dt * flow_.height_rate * cell_.height;
    strain_ += dt * flow_.shear_rate;
    pairs_.update(beads_, cell_, dt * (flow_.shear_rate + std::abs(flow_.height_rate)));
}

void ShearCell::follow_stiffest_contact() {
    const double stiffness = Hertz::at(recent_overlap_, material_.modulus).normal_stiffness;
    const double wanted = fraction_ / std::sqrt(stiffness) / std::max(1.0, material_.damping);
    // It may shrink at once but grows slowly, so that one quiet moment does not lengthen it.
    time_step_ = time_step_ == 0 ? wanted : std::min(wanted, 1.01 * time_step_);
    recent_overlap_ = std::max(largest_overlap_, overlap_at(0.1, material_.modulus));
}

bool ShearCell::compress(const std::stop_token& stop) {
    flow_.height_rate = -initial_closing_rate;
    while (stress_.s22 < 1) {
        step();
        if (!(solid_fraction() < 0.8)) {
            return false;
        }
        if (stop.stop_requested()) {
            throw Interrupted();
        }
    }
    servo_ = true;
    return true;
}

}  // namespace pendular::dem
