#include "sim/dem/pair_forces.h"

#include <algorithm>

#include "sim/dem/grain_effects.h"
#include "sim/dem/pair_stages.h"
#include "sim/dem/vector.h"

namespace pendular::dem {
namespace {

/// In samples of more grains than `cached_beads` the loop prefetches grains, `ahead` pairs in
/// advance. 16,000 grains are as fast per grain as 4000; grains and pairs of 125,000 take 38 MB,
/// for which a step waits (docs/validation.md, Speed).
constexpr std::size_t cached_beads = 20'000, ahead = 2 * lanes;

/// Stages of the loop over the lanes of a batch. Effects act between `normal` and `tangential`.
enum class Stage {
    normal,      ///< kinematics, normal forces and bridges
    tangential,  ///< tangential forces, then force and torque of the pair
    both         ///< both stages at once, with nothing stored in between
};

/// Loop over the pairs of a sample that has exactly these needs (PairNeeds).
template <bool sized, bool wet, bool accounted, bool staged>
class ForceLoop {
  public:
    [[gnu::always_inline]] ForceLoop(const Grains& grains, Pairs& pairs, const PairLaws& laws,
                                     Grains::ForceAndTorque* net_force)
        : grains_(grains),
          pairs_(pairs),
          laws_(laws),
          net_force_(net_force),
          shifts_(image_shifts(laws.cell)),
          contact_history_(pairs.contact_history.size()) {
        if constexpr (staged && !sized) {
            sizes_.set_equal();
        }
    }

    [[gnu::always_inline]] PairSums sum(Stretch stretch) {
        const bool fetching = grains_.size() > cached_beads;
        for (std::size_t begin = stretch.first; begin < stretch.second; begin += lanes) {
            if (fetching && begin + ahead + lanes <= pairs_.size()) {
                fetch(begin + ahead);
            }
            read(begin);
            if constexpr (staged) {
                work_with_effects(begin);
            } else {
                work<Stage::both>(begin);
            }
            constexpr auto torques = sized || staged ? Torques::separate : Torques::shared;
            scatter<torques>(batch_, pairs_, begin, net_force_);
        }
        return sums_.total(accounted ? EnergyAccounting::on : EnergyAccounting::off);
    }

  private:
    /// Prefetches the data of the second grains of a batch, which are spread over memory. The data
    /// of the first grains are in order and need no prefetch.
    [[gnu::always_inline]] void fetch(std::size_t begin) const {
        for (std::size_t k = begin; k < begin + lanes; ++k) {
            const auto grain = static_cast<std::size_t>(pairs_.second[k]);
            const char* motion = reinterpret_cast<const char*>(&grains_.motion[grain]);
            __builtin_prefetch(motion, 1);
            __builtin_prefetch(motion + sizeof(Grains::Motion) - 1, 1);
            __builtin_prefetch(&net_force_[grain], 1);
        }
    }

    [[gnu::always_inline]] void read(std::size_t begin) {
        if constexpr (sized) {
            gather_sizes(grains_, pairs_, begin, sizes_);
        }
        constexpr auto part = sized ? Gathered::weighted_motion : Gathered::motion;
        gather<part>(grains_.motion.data(), pairs_, begin, shifts_, sizes_, batch_);
        if constexpr (staged) {
            gather_rolling(grains_.motion.data(), pairs_, begin, stages_.rolling);
        }
    }

    /// Computes the forces and torques of the batch of pairs that starts at `begin`; they are zero
    /// for pairs without contact and bridge.
    template <Stage stage>
    [[gnu::always_inline]] void work(std::size_t begin) {
        double* __restrict sx = pairs_.sx.data() + begin;
        double* __restrict sy = pairs_.sy.data() + begin;
        double* __restrict sz = pairs_.sz.data() + begin;
        double* __restrict root = pairs_.root.data() + begin;
        double* __restrict bridge = pairs_.bridge.data() + begin;
        const Material material = laws_.material;
        const BridgeLaw bridges = laws_.bridges;
        const Flow flow = laws_.flow;
        const double dt = laws_.time_step;
        // An effect may let bridges form without contact. Where an effect replaces the force of
        // bridges, their potential is unknown and not counted.
        const double always = staged && laws_.effects->bridges_without_contact() ? 1.0 : 0.0;
        const double potential = staged && laws_.effects->changes_bridges() ? 0.0 : 1.0;
#pragma GCC ivdep
        for (std::size_t k = 0; k < lanes; ++k) {
            const PairSizes sizes = sized ? sizes_[k] : PairSizes{};
            ContactKinematics kinematics;
            NormalForces normal;
            if constexpr (stage == Stage::tangential) {
                kinematics = stages_.kinematics(k);
                normal = stages_.forces(k);
            } else {
                kinematics = ContactKinematics::of(batch_.motion(k), flow);
                normal = contact_forces(kinematics, sizes, material);
                if constexpr (wet) {
                    const double before = staged && always > bridge[k] ? always : bridge[k];
                    add_bridge(normal, before, sizes, bridges);
                }
            }
            if constexpr (stage == Stage::normal) {
                stages_.set(k, kinematics, normal);
            } else {
                const auto step =
                    TangentialStep::of({sx[k], sy[k], sz[k]}, kinematics, normal, root[k],
                                       tangential_stiffness(root[k], sizes, material), dt);
                if constexpr (accounted) {
                    account(k, normal, step, sizes, material);
                }
                if constexpr (accounted && wet) {
                    const double energy = potential * bridge_energy(normal, sizes, bridges);
                    sums_.capillary[k] += normal.joined * energy;
                    sums_.bridges[k] += (bridge[k] - normal.joined) * energy;
                }
                sx[k] = step.force.x, sy[k] = step.force.y, sz[k] = step.force.z;
                root[k] = normal.root;
                if constexpr (wet) {
                    bridge[k] = normal.joined;
                }
                push(k, kinematics, normal, step.force, sizes);
            }
        }
    }

    /// Adds the elastic energy and the losses of a contact to the sums.
    [[gnu::always_inline]] void account(std::size_t k, const NormalForces& normal,
                                        const TangentialStep& step, const PairSizes& sizes,
                                        const Material& material) {
        const Hertz hertz = hertz_contact(normal.overlap, sizes, material.modulus);
        sums_.elastic[k] += hertz.energy(normal.overlap);
        sums_.elastic[k] += step.stored;
        sums_.friction[k] += step.sliding;
        sums_.unloading[k] += step.unloading;
    }

    /// Sets the force and torques of a pair from its normal and tangential forces.
    [[gnu::always_inline]] void push(std::size_t k, const ContactKinematics& kinematics,
                                     const NormalForces& normal, const Xyz& tangential,
                                     const PairSizes& sizes) {
        const Xyz force = normal.total() * kinematics.normal + tangential;
        const Xyz torque = contact_torque(kinematics, tangential);
        batch_.force.set(k, force);
        if constexpr (sized && !staged) {
            batch_.torque.set(k, sizes.second_arm * torque);
            batch_.first_torque.set(k, sizes.first_arm() * torque);
        } else {
            batch_.torque.set(k, torque);
        }
        if constexpr (!staged) {
            sums_.add_virial(k, force, batch_.separation[k]);
        }
        const double largest = sums_.largest_overlap[k];
        sums_.largest_overlap[k] = normal.overlap > largest ? normal.overlap : largest;
    }

    /// Runs the two stages on a batch, with the effects between and after them.
    [[gnu::always_inline]] void work_with_effects(std::size_t begin) {
        for (std::size_t word = 0; word < contact_history_.size(); ++word) {
            contact_history_[word] = pairs_.contact_history[word].data() + begin;
        }
        const GrainEffects& effects = *laws_.effects;
        const PairBatch view =
            batch_for_effects(batch_, stages_, sizes_, laws_.time_step, contact_history_.data());
        work<Stage::normal>(begin);
        effects.bridge(view, laws_.material, laws_.bridges);
        effects.limit(view, laws_.material, laws_.bridges);
        work<Stage::tangential>(begin);
        effects.add(view, laws_.material, laws_.bridges);
        add_effects();
    }

    /// Completes the virial and the torques of a batch after effects have added forces and torques.
    [[gnu::always_inline]] void add_effects() {
#pragma GCC ivdep
        for (std::size_t k = 0; k < lanes; ++k) {
            sums_.add_virial(k, batch_.force[k], batch_.separation[k]);
            const PairSizes sizes = sized ? sizes_[k] : PairSizes{};
            const Xyz torque = batch_.torque[k], own = stages_.own_torque[k];
            batch_.torque.set(k, sizes.second_arm * torque + own);
            batch_.first_torque.set(k, sizes.first_arm() * torque - own);
        }
    }

    const Grains& grains_;
    Pairs& pairs_;
    const PairLaws& laws_;
    Grains::ForceAndTorque* net_force_;
    Shifts shifts_;
    Batch batch_;
    SizeLanes sizes_;
    Stages stages_;
    LaneSums sums_;
    /// For each value that effects store per pair, its array from the first pair of the batch on.
    std::vector<double*> contact_history_;
};

/// Sums the forces with the ForceLoop that is compiled for these needs, given in the order of its
/// template parameters.
template <bool... known, typename... Needs>
[[gnu::always_inline]] inline PairSums sum_forces(const Grains& grains, Pairs& pairs,
                                                  Stretch stretch, const PairLaws& laws,
                                                  Grains::ForceAndTorque* net_force, bool need,
                                                  Needs... others) {
    if constexpr (sizeof...(known) == 3) {
        return need ? ForceLoop<known..., true>(grains, pairs, laws, net_force).sum(stretch)
                    : ForceLoop<known..., false>(grains, pairs, laws, net_force).sum(stretch);
    } else {
        return need ? sum_forces<known..., true>(grains, pairs, stretch, laws, net_force, others...)
                    : sum_forces<known..., false>(grains, pairs, stretch, laws, net_force,
                                                  others...);
    }
}

}  // namespace

PairNeeds PairNeeds::of(const Grains& grains, const PairLaws& laws) {
    return {.sizes = !grains.diameters.empty(),
            .bridges = laws.bridges.wet(),
            .accounting = laws.accounting == EnergyAccounting::on,
            .effects = laws.effects && laws.effects->changes_forces()};
}

PENDULAR_SIMD_CLONES
PairSums pair_forces(const Grains& grains, Pairs& pairs, Stretch stretch, const PairLaws& laws,
                     const PairNeeds& needs, std::vector<Grains::ForceAndTorque>& net_force) {
    return sum_forces<>(grains, pairs, stretch, laws, net_force.data(), needs.sizes, needs.bridges,
                        needs.accounting, needs.effects);
}

PairSums pair_forces(const Grains& grains, Pairs& pairs, Stretch stretch, const PairLaws& laws,
                     std::vector<Grains::ForceAndTorque>& net_force) {
    return pair_forces(grains, pairs, stretch, laws, PairNeeds::of(grains, laws), net_force);
}

PairSums pair_forces(Grains& grains, Pairs& near, const PairLaws& laws) {
    std::ranges::fill(grains.net_force, Grains::ForceAndTorque{});
    return pair_forces(grains, near, {0, near.size()}, laws, grains.net_force);
}

}  // namespace pendular::dem
