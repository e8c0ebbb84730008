// Laws of the force loop with effects on grains in it, for every effect of the registry, on random
// states with fixed seeds.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "sim/catalogue/effect.h"
#include "sim/dem/grain_effects.h"
#include "sim/dem/pair_forces.h"
#include "sim/dem/shear_cell.h"
#include "sim/runs/run_request.h"

namespace grain_effects_test {

using namespace pendular;
using namespace pendular::dem;

constexpr Material material{.modulus = 31622.8, .friction = 0.3};  // stiffness number 1000
const Wetting wetting{.reduced_pressure = 1, .bridge_volume = 4e-3};

/// Net forces and torques on grains.
using Loads = std::vector<Grains::ForceAndTorque>;

/// Grains at random in a sheared cell, some of them overlapping, some joined by bridges, with
/// velocities, remembered forces and, where an effect has them, remembered words.
struct State {
    Grains grains;
    Cell cell{7, 6, 8, 2.5};
    Flow flow{0.01, -0.002};
    GrainEffects effects;
    BridgeLaw bridges;
    Pairs pairs;

    explicit State(const std::vector<EffectValues>& on, bool wet, unsigned seed = 1)
        : grains(400),
          effects(grain_effects(on, wet)),
          bridges(wet ? effects.changed(BridgeLaw(wetting)) : BridgeLaw()) {
        grains.diameters = effects.diameters(grains.size(), seed);
        std::mt19937_64 random(seed);
        std::mt19937_64 of_memory(seed + 1);  // the rest is the same with and without
        std::uniform_real_distribution<double> at(0, 1), velocity(-0.1, 0.1);
        for (std::size_t i = 0; i < grains.size(); ++i) {
            grains.position(i) = {cell.length * at(random), cell.height * at(random),
                                  cell.width * at(random)};
            grains.velocity(i) = {velocity(random), velocity(random), velocity(random)};
            grains.angular_velocity(i) = {velocity(random), velocity(random), velocity(random)};
        }
        pairs = Pairs(find_pairs_by_brute_force(grains, cell, 0.3), effects.contact_history());
        pairs.fill_up(PairList::batch);
        for (std::size_t k = 0; k < pairs.size(); ++k) {
            pairs.sx[k] = velocity(random), pairs.sy[k] = velocity(random);
            pairs.sz[k] = velocity(random);
            pairs.root[k] = 0.1;
            pairs.bridge[k] = wet && at(random) < 0.5 ? 1 : 0;
            for (auto& word : pairs.contact_history) {
                word[k] = velocity(of_memory);
            }
            if (effects.volume_in_history()) {  // bridges get their volumes in the first step
                pairs.contact_history[*effects.volume_in_history()][k] = 0;
            }
        }
    }
    PairSums forces(EnergyAccounting accounting = EnergyAccounting::off) {
        const PairLaws laws{cell, flow, material, bridges, 1e-3, accounting, &effects};
        grains.net_force.assign(grains.size(), {});
        return pair_forces(grains, pairs, {0, pairs.size()}, laws, grains.net_force);
    }
    /// Forces of the sample by the loop for these needs.
    PairSums forces(EnergyAccounting accounting, PairNeeds needs) {
        const PairLaws laws{cell, flow, material, bridges, 1e-3, accounting, &effects};
        grains.net_force.assign(grains.size(), {});
        return pair_forces(grains, pairs, {0, pairs.size()}, laws, needs, grains.net_force);
    }
};

bool same(const Loads& a, const Loads& b) {
    return std::ranges::equal(a, b,
                              [](const Grains::ForceAndTorque& x, const Grains::ForceAndTorque& y) {
                                  return x.force == y.force && x.torque == y.torque;
                              });
}

/// Values of the smallest effect of interest, away from neutral, in the units of a run at 1 kPa.
std::vector<EffectValues> on(const Effect& effect) {
    EffectValues values{effect.name, effect.neutral()};
    for (std::size_t k = 0; k < values.values.size(); ++k) {
        const EffectParameter& p = effect.parameters[k];
        values.values[k] = p.is_switch() ? 1 : p.neutral + p.smallest_of_interest;
    }
    return {in_run_units(values, 1000, {.diameter = 500e-6, .density = 1050})};
}

std::vector<const Effect*> effects_on_grains() {
    std::vector<const Effect*> all;
    for (const Effect& effect : built_in_effects()) {
        if (effect.of_grains()) {
            all.push_back(&effect);
        }
    }
    return all;
}

bool wet(const Effect& effect) {
    return effect.touches != Touches::dry;
}

class OfEveryGrainEffect : public testing::TestWithParam<const Effect*> {};

INSTANTIATE_TEST_SUITE_P(Registry, OfEveryGrainEffect, testing::ValuesIn(effects_on_grains()),
                         [](const auto& test) {
                             std::string name = test.param->name;
                             std::ranges::replace(name, '-', '_');
                             return name;
                         });

TEST(ForceLoop, GivesTheSameBitsWhereASampleLacksWhatTheLoopIsMadeFor) {
    // Equal grains without effects go through the loops for unequal ones and for effects, all of
    // whose diameters are 1 then.
    for (const bool is_wet : {false, true}) {
        for (const auto accounting : {EnergyAccounting::off, EnergyAccounting::on}) {
            State plain({}, is_wet);
            const PairSums a = plain.forces(accounting);
            for (const auto& [sizes, effects] :
                 {std::pair(true, false), {false, true}, {true, true}}) {
                State state({}, is_wet);
                if (sizes) {
                    state.grains.diameters.assign(state.grains.size(), 1.0);
                }
                const PairSums b =
                    state.forces(accounting, {.sizes = sizes,
                                              .bridges = is_wet,
                                              .accounting = accounting == EnergyAccounting::on,
                                              .effects = effects});
                EXPECT_TRUE(same(plain.grains.net_force, state.grains.net_force));
                EXPECT_EQ(plain.pairs.sx, state.pairs.sx);
                EXPECT_EQ(plain.pairs.bridge, state.pairs.bridge);
                EXPECT_EQ(a.virial_12, b.virial_12);
                EXPECT_EQ(a.energy.elastic, b.energy.elastic);
                EXPECT_EQ(a.energy.capillary, b.energy.capillary);
                EXPECT_EQ(a.energy.friction, b.energy.friction);
                EXPECT_EQ(a.energy.bridges, b.energy.bridges);
                EXPECT_EQ(a.energy.unloading, b.energy.unloading);
            }
        }
    }
}

TEST_P(OfEveryGrainEffect, VanishesAtItsNeutralValue) {
    const Effect& effect = *GetParam();
    // Dropped, so that the loop has no hook at all.
    const GrainEffects neutral = grain_effects({{effect.name, effect.neutral()}}, wet(effect));
    EXPECT_FALSE(neutral.changes_pairs());
    EXPECT_TRUE(neutral.diameters(100, 1).empty());
    EXPECT_EQ(neutral.contact_history(), 0u);
    // A hair off neutral its stages run and change next to nothing. (Switches have nothing
    // between.)
    if (effect.is_switch()) {
        return;
    }
    EffectValues hair{effect.name, effect.neutral()};
    hair.values[0] += 1e-13;
    State off({}, wet(effect)), nearly({hair}, wet(effect));
    off.forces(), nearly.forces();
    double largest = 0, apart = 0;
    for (std::size_t i = 0; i < off.grains.size(); ++i) {
        largest = std::max(largest, std::abs(off.grains.force(i)[0]));
        apart = std::max(apart, std::abs(off.grains.force(i)[0] - nearly.grains.force(i)[0]));
    }
    EXPECT_LT(apart, 1e-8 * largest);
}

TEST_P(OfEveryGrainEffect, ChangesSomethingAtTheSizeThatMatters) {
    const Effect& effect = *GetParam();
    // Dry ones act where there is no bridge.
    State off({}, wet(effect)), active(on(effect), wet(effect));
    off.forces(), active.forces();
    EXPECT_FALSE(same(off.grains.net_force, active.grains.net_force));
}

TEST_P(OfEveryGrainEffect, HasForcesThatAreEqualAndOpposite) {
    State state(on(*GetParam()), wet(*GetParam()));
    state.forces();
    Vector sum;
    double scale = 0;
    for (const auto& load : state.grains.net_force) {
        sum += load.force;
        scale = std::max(scale, std::abs(load.force[0]));
    }
    for (std::size_t d = 0; d < 3; ++d) {
        EXPECT_NEAR(sum[d], 0, 1e-11 * scale * 400);
    }
}

/// Torques and moments of forces of all pairs add up to nothing where no pair crosses a face: no
/// angular momentum is made.
TEST_P(OfEveryGrainEffect, MakesNoAngularMomentum) {
    State state(on(*GetParam()), wet(*GetParam()));
    state.cell = {100, 100, 100, 0};
    state.flow = {};
    state.pairs = Pairs(find_pairs_by_brute_force(state.grains, state.cell, 0.3),
                        state.effects.contact_history());
    state.pairs.fill_up(PairList::batch);
    std::ranges::fill(state.pairs.bridge, state.bridges.wet() ? 1.0 : 0.0);
    state.forces();
    Vector sum;
    double scale = 0;
    for (std::size_t i = 0; i < state.grains.size(); ++i) {
        const Vector r = state.grains.position(i), f = state.grains.force(i);
        const Vector moment(r[1] * f[2] - r[2] * f[1], r[2] * f[0] - r[0] * f[2],
                            r[0] * f[1] - r[1] * f[0]);
        sum += moment + state.grains.torque(i);
        scale = std::max(scale, std::abs(moment[0]));
    }
    for (std::size_t d = 0; d < 3; ++d) {
        EXPECT_NEAR(sum[d], 0, 1e-10 * scale * 400);
    }
}

/// A state turned as a whole by a quarter about the vorticity has its forces turned alike; added a
/// common velocity, it has the same.
TEST_P(OfEveryGrainEffect, IsFrameIndependent) {
    State still(on(*GetParam()), wet(*GetParam()));
    const auto open = [](State& state) {
        state.cell = {100, 100, 100, 0};
        state.flow = {};
        state.pairs = Pairs(find_pairs_by_brute_force(state.grains, state.cell, 0.3),
                            state.effects.contact_history());
        state.pairs.fill_up(PairList::batch);
        for (auto& word : state.pairs.contact_history) {
            std::ranges::fill(word, 0.01);
        }
        std::ranges::fill(state.pairs.bridge, state.bridges.wet() ? 1.0 : 0.0);
    };
    open(still);
    State turned = still;
    const auto turn = [](const Vector& v) { return Vector(-v[1], v[0], v[2]); };
    for (auto& grain : turned.grains.motion) {
        grain.position = turn(grain.position) + Vector(50, 0, 0);
        grain.velocity = turn(grain.velocity) + Vector(0.3, -0.2, 0.1);
        grain.angular_velocity = turn(grain.angular_velocity);
    }
    for (std::size_t k = 0; k + 2 < turned.pairs.contact_history.size(); k += 3) {
        auto& contact_history = turned.pairs.contact_history;
        for (std::size_t p = 0; p < turned.pairs.size(); ++p) {
            const Vector v =
                turn({contact_history[k][p], contact_history[k + 1][p], contact_history[k + 2][p]});
            contact_history[k][p] = v[0], contact_history[k + 1][p] = v[1],
            contact_history[k + 2][p] = v[2];
        }
    }
    still.forces(), turned.forces();
    for (std::size_t i = 0; i < still.grains.size(); ++i) {
        const Vector force = turn(still.grains.force(i)), torque = turn(still.grains.torque(i));
        for (std::size_t d = 0; d < 3; ++d) {
            ASSERT_NEAR(turned.grains.force(i)[d], force[d], 1e-6 * (1 + std::abs(force[d])));
            ASSERT_NEAR(turned.grains.torque(i)[d], torque[d], 1e-6 * (1 + std::abs(torque[d])));
        }
    }
}

TEST_P(OfEveryGrainEffect, IsFiniteAtTheCornersOfItsBounds) {
    const Effect& effect = *GetParam();
    for (const bool upper : {false, true}) {
        EffectValues corner{effect.name, effect.neutral()};
        for (std::size_t k = 0; k < corner.values.size(); ++k) {
            corner.values[k] = upper ? effect.parameters[k].upper : effect.parameters[k].lower;
        }
        for (const double stress : {300.0, 3000.0}) {
            const GrainProperties grains{.diameter = 500e-6, .density = 1050};
            State state({in_run_units(corner, stress, grains)}, wet(effect));
            state.forces();
            for (const auto& load : state.grains.net_force) {
                for (std::size_t d = 0; d < 3; ++d) {
                    ASSERT_TRUE(std::isfinite(load.force[d]) && std::isfinite(load.torque[d]));
                }
            }
        }
    }
}

TEST_P(OfEveryGrainEffect, LosesNoContactThroughNewLists) {
    const Effect& effect = *GetParam();
    const GrainEffects effects = grain_effects(on(effect), wet(effect));
    const BridgeLaw bridges = wet(effect) ? BridgeLaw(wetting) : BridgeLaw();
    ShearCell kept(200, material, 0.05, 3, bridges, 1, effects);
    ASSERT_TRUE(kept.compress());
    for (int step = 0; step < 300; ++step) {
        kept.step();
    }
    EXPECT_GT(kept.pairs().renewals(), 3u);
    EXPECT_TRUE(std::isfinite(kept.stress().s12));
    std::size_t touching = 0;
    Grains wrapped = kept.grains();
    Cell cell = kept.cell();
    cell.reduce_offset();
    for (auto& grain : wrapped.motion) {
        grain.position = cell.wrapped(grain.position);
    }
    for (std::size_t k = 0; k < kept.pairs().live(); ++k) {
        touching += kept.pairs().narrow().root[k] > 0;
    }
    // One step lies between the forces and the positions: few pairs change their state in it.
    EXPECT_NEAR(static_cast<double>(touching),
                static_cast<double>(find_pairs_by_brute_force(wrapped, cell, 0.0).size()),
                0.02 * static_cast<double>(touching));
}

}  // namespace grain_effects_test
