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

#include "sim/dem/distant_forces.h"
#include "sim/dem/pair_forces.h"
#include "sim/dem/parts.h"
#include "sim/dem/simulation_error.h"
#include "sim/dem/viscous_loss.h"

namespace pendular::dem {
namespace {

constexpr double unit_volume = std::numbers::pi / 6;
/// Chosen: so loose that grains placed at random soon find room.
constexpr double initial_solid_fraction = 0.3;
/// Rate at which the height shrinks until the grains first carry the stress [1]. Chosen: the servo
/// takes over there, and no average includes the transient.
constexpr double initial_closing_rate = 0.05;
/// Solid fraction with which the edges of the cell are chosen: flows of frictions up to 0.4 have
/// 0.59 to 0.64 (docs/validation.md, An independent code).
constexpr double steady_solid_fraction = 0.62;
/// Modulus B of the servo over the stiffness number. Eight times as much changes averages by 1.4
/// standard errors or less (docs/validation.md, Numerical parameters).
constexpr double servo_modulus = 0.05;
/// Viscosity of the contacts against a change of height, over zeta sqrt(kappa). For affine motion
/// and Z/2 contacts per grain with dashpots zeta sqrt(2 K_N) it is
/// 0.2 (6 Phi/pi) (Z/2) sqrt(2 K_N/kappa), 0.6 to 0.8 in a flowing sample. The servo is stable
/// while the true gain is below twice the gain from this value plus 1.
constexpr double contact_viscosity = 0.6;
/// Viscosity of the pairs against a change of height if an effect damps them, over the effect's
/// damping coefficient: 0.2 (6 Phi/pi) (Z/2) with Z = 7 bridges per grain. A value above the true
/// one makes the servo slower, never unstable.
constexpr double effect_viscosity = 0.8;
/// Chosen: the stiffest contact hardly changes within so few steps, and the time step is renewed at
/// once where an overlap doubles.
constexpr int steps_between_time_steps = 20;

/// Largest product of time step and damping rate of an effect. A grain's relative velocity is
/// damped by a dozen neighbours, and a step must stay well below twice the time that this takes.
constexpr double damped_step = 0.1;

/// Random number, uniform in [0, 1) with 53 bits, the same on every platform.
double uniform(std::mt19937_64& random) {
    return static_cast<double>(random() >> 11) * 0x1p-53;
}

/// Places grains in a periodic cell such that no grain touches an earlier grain; searches
/// neighbours in bins of the largest diameter.
class RandomPlacement {
  public:
    RandomPlacement(const std::array<double, 3>& edge, double largest_diameter) : edge_(edge) {
        std::size_t bins = 1;
        for (int d = 0; d < 3; ++d) {
            count_[d] = static_cast<int>(edge[d] / largest_diameter);
            bins *= static_cast<std::size_t>(count_[d]);
        }
        bins_.resize(bins);
    }

    /// Places a grain if it touches no earlier grain. @return whether it was placed
    bool place(const std::array<double, 3>& at, double diameter) {
        for (int step = 0; step < 27; ++step) {
            for (const auto& other :
                 bins_[bin(at, {step % 3 - 1, step / 3 % 3 - 1, step / 9 - 1})]) {
                double squared = 0;
                for (int d = 0; d < 3; ++d) {
                    const double apart = at[d] - other.at[d];
                    const double nearest = apart - edge_[d] * std::round(apart / edge_[d]);
                    squared += nearest * nearest;
                }
                const double touching = 0.5 * (diameter + other.diameter);
                if (squared < touching * touching) {
                    return false;
                }
            }
        }
        bins_[bin(at, {0, 0, 0})].push_back({at, diameter});
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
    struct Placed {
        std::array<double, 3> at;
        double diameter;
    };
    std::vector<std::vector<Placed>> bins_;
};

}  // namespace

ShearCell::ShearCell(int count, const Material& material, double shear_rate, std::uint64_t seed,
                     const BridgeLaw& bridges, int parts, const GrainEffects& effects)
    : ShearCell(random_gas(count, seed,
                           effects.diameters(static_cast<std::size_t>(std::max(count, 0)), seed)),
                material, {.shear_rate = shear_rate}, bridges, parts, effects) {}

ShearCell::ShearCell(Sample sample, const Material& material, const Flow& flow,
                     const BridgeLaw& bridges, int parts, const GrainEffects& effects)
    : grains_(std::move(sample.grains)),
      cell_(sample.cell),
      pairs_(effects.changed(bridges).rupture_distance, parts,
             {effects.contact_history(), effects.bridges_without_contact()}),
      material_(material),
      effects_(effects),
      bridges_(effects.changed(bridges)),
      flow_(flow),
      parts_(parts),
      other_net_forces_(static_cast<std::size_t>(parts) - 1,
                        std::vector<Grains::ForceAndTorque>(grains_.size())) {
    bead_volume_ = grains_.volume();
    recent_overlap_ = overlap_at(1.0, material_.modulus);
    follow_stiffest_contact();
    pairs_.rebuild(grains_, cell_);
}

double ShearCell::edge(int count) {
    return std::cbrt(count * unit_volume / steady_solid_fraction);
}

Sample random_gas(int count, std::uint64_t seed, const std::vector<double>& diameters) {
    if (count < ShearCell::fewest_grains) {
        throw std::invalid_argument("a sample needs at least 64 grains");
    }
    // The base is that of a cube of the flowing sample; the cell is taller, so that grains placed at
    // random find room.
    Sample sample{Grains(static_cast<std::size_t>(count)), {}};
    sample.grains.diameters = diameters;
    Cell& cell = sample.cell;
    const double base = ShearCell::edge(count);
    cell = {base, sample.grains.volume() / initial_solid_fraction / (base * base), base, 0};
    RandomPlacement placement({cell.length, cell.height, cell.width},
                              sample.grains.largest_diameter());
    std::mt19937_64 random(seed);
    for (std::size_t i = 0; i < sample.grains.size(); ++i) {
        std::array<double, 3> at;
        do {
            at = {cell.length * uniform(random), cell.height * uniform(random),
                  cell.width * uniform(random)};
        } while (!placement.place(at, sample.grains.diameter(i)));
        sample.grains.position(i) = {at[0], at[1], at[2]};
    }
    return sample;
}

double ShearCell::solid_fraction() const {
    return bead_volume_ / cell_.volume();
}

void ShearCell::step(EnergyAccounting accounting) {
    if (shares_made_at_ != pairs_.renewals()) {
        shares_ = shares_of(pairs_, grains_.size(), parts_);
        shares_made_at_ = pairs_.renewals();
    }
    const PairLaws laws{cell_,      flow_,      material_, bridging_ ? bridges_ : BridgeLaw(),
                        time_step_, accounting, &effects_};
    MotionSums moved;
    if (parts_ == 1 && accounting == EnergyAccounting::off) {
        measure(sum_forces(shares_.front(), grains_.net_force, laws, &moved));
    } else {
        measure(sum_forces(laws));
        if (accounting == EnergyAccounting::on) {
            energy_.viscosity = viscous_loss(grains_, all_net_forces(), pairs_.narrow(), laws);
        }
        moved = move_grains();
    }
    check_state();
    exchange_liquid();
    motion_ = moved;
    advance_cell();
    if (servo_) {
        adjust_height_rate();
    }
    ++steps_;
    if (steps_ % steps_between_time_steps == 0 || largest_overlap_ > 2 * recent_overlap_) {
        follow_stiffest_contact();
    }
}

PairSums ShearCell::sum_forces(const Share& share, std::vector<Grains::ForceAndTorque>& net_forces,
                               const PairLaws& laws, MotionSums* moved) {
    PairSums sums;
    for (const Section& section : share.sections) {
        sums += pair_forces(grains_, pairs_.narrow(), section.near, laws, net_forces);
        if (laws.bridges.wet()) {
            sums += distant_forces(grains_, pairs_.distant(), section.distant, laws, net_forces);
        }
        if (moved) {
            *moved += advance(grains_, section.grains, net_forces, flow_, time_step_);
        }
    }
    return sums;
}

PairSums ShearCell::sum_forces(const PairLaws& laws) {
    std::vector<PairSums> sums(static_cast<std::size_t>(parts_));
    in_parts(parts_, [&](int part) {
        const auto at = static_cast<std::size_t>(part);
        sums[at] = sum_forces(shares_[at], net_forces_of(part), laws);
    });
    if (parts_ > 1) {
        in_parts(parts_, [&](int part) { collect_net_forces(part); });
    }
    for (std::size_t part = 1; part < sums.size(); ++part) {
        sums.front() += sums[part];
    }
    return sums.front();
}

void ShearCell::collect_net_forces(int part) {
    auto& mine = net_forces_of(part);
    const auto [begin, end] = shares_[static_cast<std::size_t>(part)].grains();
    for (int other = 0; other < parts_; ++other) {
        const auto& ghosts = shares_[static_cast<std::size_t>(other)].ghosts;
        auto& theirs = net_forces_of(other);
        auto ghost = std::ranges::lower_bound(ghosts, static_cast<std::int32_t>(begin));
        for (; ghost != ghosts.end() && static_cast<std::size_t>(*ghost) < end; ++ghost) {
            const auto at = static_cast<std::size_t>(*ghost);
            const Grains::ForceAndTorque net_force = std::exchange(theirs[at], {});
            mine[at].force += net_force.force;
            mine[at].torque += net_force.torque;
        }
    }
}

std::vector<Grains::ForceAndTorque>& ShearCell::net_forces_of(int part) {
    return part == 0 ? grains_.net_force : other_net_forces_[static_cast<std::size_t>(part) - 1];
}

std::vector<Grains::ForceAndTorque> ShearCell::all_net_forces() {
    std::vector<Grains::ForceAndTorque> all = grains_.net_force;
    for (int part = 1; part < parts_; ++part) {
        const auto [begin, end] = shares_[static_cast<std::size_t>(part)].grains();
        for (std::size_t i = begin; i < end; ++i) {
            all[i] = net_forces_of(part)[i];
        }
    }
    return all;
}

void ShearCell::measure(const PairSums& sums) {
    const double volume = cell_.volume();
    stress_.s11 = (sums.virial_11 + motion_.squares[0]) / volume;
    stress_.s22 = (sums.virial_22 + motion_.squares[1]) / volume;
    stress_.s33 = (sums.virial_33 + motion_.squares[2]) / volume;
    stress_.s12 = (sums.virial_12 + motion_.shear) / volume;
    energy_ = sums.energy;
    largest_overlap_ = sums.largest_overlap;
    recent_overlap_ = std::max(recent_overlap_, largest_overlap_);
}

void ShearCell::adjust_height_rate() {
    // kappa = E^(2/3), since the imposed normal stress is 1.
    const double stiffness = std::cbrt(material_.modulus * material_.modulus);
    const double wanted = (stress_.s22 - 1) / (servo_modulus * stiffness);
    // The stress of viscous contacts follows the height rate within one step: d(s22)/d(rate) is
    // about -zeta sqrt(kappa). The servo is implicit in this term. An explicit servo alternated
    // between two rates at every step where that gain over B is near 1: in wet samples at
    // stiffness number 300, which a mean stress of 1 hid.
    double gain = contact_viscosity * material_.damping / (servo_modulus * std::sqrt(stiffness));
    // Without the damping by effects in it, samples with viscous bridges blew up: from about
    // 0.05 Pa s at stiffness number 300 and 0.3 Pa s at 1000.
    if (effects_.changes_pairs()) {
        gain += effect_viscosity * effects_.damping_rate(bridges_) / (servo_modulus * stiffness);
    }
    flow_.height_rate += (wanted - flow_.height_rate) / (1 + gain);
}

void ShearCell::exchange_liquid() {
    const double rate = bridging_ ? effects_.exchange_rate() : 0;
    if (rate > 0) {
        exchange_.flow(pairs_, *effects_.volume_in_history(), grains_.size(),
                       rate * time_step_ * std::abs(flow_.shear_rate));
    }
}

void ShearCell::check_state() const {
    // Checked in every step, before a position that is NaN reaches the bins of the neighbour
    // search.
    if (!std::isfinite(stress_.s22) || largest_overlap_ > 0.5) {
        throw SimulationError(fmt::format(
            "the simulation blew up at strain {:.3g} (largest overlap {:.2g} diameters); "
            "lower the damping or the inertial number, or raise the stiffness number",
            strain_, largest_overlap_));
    }
}

MotionSums ShearCell::move_grains() {
    std::vector<MotionSums> sums(static_cast<std::size_t>(parts_));
    in_parts(parts_, [&](int part) {
        const auto at = static_cast<std::size_t>(part);
        for (const Section& section : shares_[at].sections) {
            sums[at] += advance(grains_, section.grains, net_forces_of(part), flow_, time_step_);
        }
    });
    for (std::size_t part = 1; part < sums.size(); ++part) {
        sums.front() += sums[part];
    }
    return sums.front();
}

void ShearCell::advance_cell() {
    const double dt = time_step_;
    // The image of a grain one height up moves exactly as the imposed flow moves a grain there.
    cell_.offset += dt * (flow_.shear_rate * cell_.height + flow_.length_rate * cell_.offset);
    cell_.length += dt * flow_.length_rate * cell_.length;
    cell_.height += dt * flow_.height_rate * cell_.height;
    cell_.width += dt * flow_.width_rate * cell_.width;
    strain_ += dt * flow_.shear_rate;
    pairs_.update(grains_, cell_,
                  dt * (std::abs(flow_.shear_rate) + std::abs(flow_.length_rate) +
                        std::abs(flow_.height_rate) + std::abs(flow_.width_rate)),
                  motion_.largest_squared);
}

void ShearCell::follow_stiffest_contact() {
    const double stiffness = Hertz::at(recent_overlap_, material_.modulus).normal_stiffness;
    double wanted = fraction_ / std::sqrt(stiffness) / std::max(1.0, material_.damping);
    if (effects_.changes_pairs()) {
        // Smaller grains are lighter; damping by an effect must not overshoot.
        wanted *= std::pow(grains_.smallest_diameter(), 1.5);
        const double rate = effects_.damping_rate(bridges_);
        wanted = rate > 0 ? std::min(wanted, damped_step / rate) : wanted;
    }
    // The time step may shrink at once but grows slowly, so that one quiet moment does not lengthen
    // it.
    time_step_ = time_step_ == 0 ? wanted : std::min(wanted, 1.01 * time_step_);
    recent_overlap_ = std::max(largest_overlap_, overlap_at(0.1, material_.modulus));
}

bool ShearCell::compress(const std::stop_token& stop) {
    flow_.height_rate = -initial_closing_rate;
    while (stress_.s22 < 1) {
        step();
        // Equal spheres cannot be packed more densely than 0.74: the grains overlap without
        // carrying the stress. The negation also catches NaN.
        if (!(solid_fraction() < 0.8)) {
            return false;
        }
        if (stop.stop_requested()) {
            throw Interrupted();
        }
    }
    bridging_ = true;
    servo_ = true;
    return true;
}

}  // namespace pendular::dem
