#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "sim/catalogue/effect.h"

namespace pendular::bench {

/// Truth that a laboratory hides.
struct Truth {
    enum class Kind { complete, effect, pair, outside };
    Kind kind = Kind::complete;
    std::string name;  ///< "lid-slip at 25"
    std::vector<ActiveEffect> hidden;
    double friction = 0.11;
    /// v, with the errors that were planned: squared length of what it changes, in standard errors,
    /// after the calibrated parameters (and, of an effect outside the catalogue, after the best
    /// pair of effects) have taken over what they can.
    double noncentrality = 0;
    /// v (1 - cos^2) about the effect that is most like it; of a single effect.
    double separation = 0;
    std::string most_like = {};  ///< that effect

    bool hides(const std::string& effect) const;
    /// Whether the effect is large, and its nearest rival leaves so much of it, that it ought to be
    /// named alone.
    bool well_separated() const;
};

std::string to_string(Truth::Kind kind);

/// Effects that the catalogue does not have: a lid that wobbles, a load cell that saturates, a
/// torque that steps up after some time, menisci that merge above a liquid content.
const std::vector<Effect>& outside_effects();

/// Descriptions of an effect outside the catalogue that are right: any of these quantities, varying
/// along any of these coordinates ("none": the same at all conditions). Several coordinates are
/// stated only where they describe one and the same change.
struct RightShape {
    std::vector<std::string> quantities, coordinates;
};

struct OutsideEffect {
    Effect effect;
    RightShape shape;
};

/// Further effects outside the catalogue, written without sight of the shapes that the program
/// proposes for unknown changes.
const std::vector<OutsideEffect>& more_outside_effects();

/// @throws std::invalid_argument for an effect that is in neither list
RightShape right_shape(std::string_view effect);

/// The table of truths, so that runs stay valid while the emulator, by which amplitudes were
/// chosen, gets better.
/// @throws InputError at what cannot be read
std::vector<Truth> read_truths(const std::filesystem::path& file);
void write_truths(const std::filesystem::path& file, const std::vector<Truth>& truths);

}  // namespace pendular::bench
