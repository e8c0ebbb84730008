// Each channel of the instrument can have a wrong zero and a wrong gain: the catalogue must hold an
// effect for both, or there is a reason here why not. Effects are found by what they do to a state,
// not by their names.
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <string>

#include "sim/catalogue/effect.h"

namespace instrument_channels_test {

using namespace pendular;

constexpr std::array channels = {&CellState::torque, &CellState::normal_force, &CellState::height,
                                 &CellState::angular_velocity};

/// State that the instrument shows under an effect of the smallest size of interest.
CellState shown(const Effect& effect, const CellState& truth) {
    const EffectParameter& p = effect.parameters.front();
    double value = p.neutral + p.smallest_of_interest;
    if (value > p.upper) value = p.neutral - p.smallest_of_interest;
    const std::vector<double> values = {value};
    return std::get<ChangeInstrument>(effect.change).show(truth, Values(effect.parameters, values));
}

CellState typical() {
    return {.torque = 0.03,
            .normal_force = 4,
            .height = 0.019,
            .angular_velocity = 0.3,
            .liquid_content = 0.02,
            .bead_volume = 57e-6,
            .time = 100,
            .inner_radius = 0.021,
            .outer_radius = 0.045,
            .density = 1050,
            .diameter = 5e-4};
}

bool near(double a, double b) {
    return std::abs(a - b) <= 1e-9 * std::max(std::abs(a), std::abs(b));
}

/// Whether some effect on the instrument, without cross-talk from other channels, has the property.
bool some_effect(const std::function<bool(const Effect&)>& has) {
    return std::ranges::any_of(built_in_effects(), [&](const Effect& effect) {
        return effect.of_instrument() && effect.parameters.size() == 1 && has(effect);
    });
}

/// Change of one channel by an effect where that channel is `factor` times, and every other channel
/// `others` times, what it is in a typical state.
double change(const Effect& effect, double CellState::*channel, double factor, double others = 1) {
    CellState state = typical();
    for (const auto each : channels)
        state.*each *= each == channel ? factor : others;
    return shown(effect, state).*channel - state.*channel;
}

/// Whether an effect adds the same to a channel whatever the channels show.
bool is_offset(const Effect& effect, double CellState::*channel) {
    const double once = change(effect, channel, 1);
    return once != 0 && near(change(effect, channel, 2), once) &&
           near(change(effect, channel, 1, 2), once);
}

/// Whether an effect multiplies a channel by the same factor whatever the channels show.
bool is_gain(const Effect& effect, double CellState::*channel) {
    const double once = change(effect, channel, 1);
    return once != 0 && near(change(effect, channel, 2), 2 * once) &&
           near(change(effect, channel, 1, 2), once);
}

/// Whether one channel adds to another in proportion to its own value.
bool is_cross_talk(const Effect& effect, double CellState::*from, double CellState::*to) {
    CellState more = typical();
    more.*from *= 2;
    const double once = shown(effect, typical()).*to - typical().*to;
    return once != 0 && near(shown(effect, more).*to - more.*to, 2 * once) &&
           near(change(effect, to, 2), once);
}

/// Solid fraction that the instrument shows.
double solid_fraction(const CellState& state) {
    return state.bead_volume / (state.area() * state.height);
}

TEST(InstrumentChannels, TorqueHasAnOffsetAndAGain) {
    EXPECT_TRUE(some_effect([](const Effect& e) { return is_offset(e, &CellState::torque); }));
    EXPECT_TRUE(some_effect([](const Effect& e) { return is_gain(e, &CellState::torque); }));
}

TEST(InstrumentChannels, NormalForceHasAnOffsetAndAGain) {
    EXPECT_TRUE(
        some_effect([](const Effect& e) { return is_offset(e, &CellState::normal_force); }));
    EXPECT_TRUE(some_effect([](const Effect& e) { return is_gain(e, &CellState::normal_force); }));
}

// A gain of the gap changes solid fractions by one factor, and shear rates by the same, to which
// stress ratios hardly respond. A wrong mass of the beads does this too, so that a gain of the gap
// would be a second name for it.
TEST(InstrumentChannels, HeightHasAnOffsetAndTheMassOfTheBeadsForItsGain) {
    EXPECT_TRUE(some_effect([](const Effect& e) { return is_offset(e, &CellState::height); }));
    EXPECT_TRUE(some_effect([](const Effect& e) {
        CellState higher = typical();
        higher.height *= 2;
        const double factor = solid_fraction(shown(e, typical())) / solid_fraction(typical());
        return factor != 1 &&
               near(solid_fraction(shown(e, higher)), factor * solid_fraction(higher));
    }));
}

// The speed of a rheometer comes from counted pulses, so that it is 0 at rest: it needs no offset.
// Slip at the lid is its gain.
TEST(InstrumentChannels, SpeedHasAGain) {
    EXPECT_TRUE(
        some_effect([](const Effect& e) { return is_gain(e, &CellState::angular_velocity); }));
}

// Cross-talk from torque to normal force is a gain of the normal force, since the torque of sheared
// grains is proportional to the normal force: see sim/effects/cross_talk.cpp.
TEST(InstrumentChannels, NormalForceTalksIntoTorque) {
    EXPECT_TRUE(some_effect([](const Effect& e) {
        return is_cross_talk(e, &CellState::normal_force, &CellState::torque) &&
               change(e, &CellState::normal_force, 1) == 0;
    }));
}

TEST(InstrumentChannels, OfEachKindHaveADirectMeasurement) {
    for (const Effect& effect : built_in_effects()) {
        if (!effect.of_instrument() || effect.is_switch()) continue;
        for (const auto channel : channels) {
            if (is_offset(effect, channel) || is_gain(effect, channel)) {
                EXPECT_FALSE(effect.directly.empty()) << effect.name;
            }
        }
    }
}

}  // namespace instrument_channels_test
