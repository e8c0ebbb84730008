#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "sim/catalogue/effect.h"

namespace pendular::bench {

/// Hidden truth of a virtual laboratory: the friction and the effects with which its recordings are
/// simulated.
struct Truth {
    enum class Kind { complete, effect, pair, outside };
    Kind kind = Kind::complete;
    /// Name, such as "lid-slip at 25": the effect, and its planned noncentrality.
    std::string name;
    std::vector<ActiveEffect> hidden;
    double friction = 0.11;
    /// Noncentrality v [1]: squared length of the change of the readings by the hidden effects, in
    /// units of the planned standard errors. The part that the calibrated parameters can imitate
    /// does not count. For an effect outside the catalogue, the part that the best pair of known
    /// effects can imitate does not count either. For a pair of effects, the smaller of the two
    /// noncentralities.
    double noncentrality = 0;
    /// Part v (1 - cos^2) of the noncentrality v that the most similar other effect cannot imitate
    /// [1], where cos is the cosine of the angle between the changes by both effects. 0 for a pair.
    double separation = 0;
    std::string most_like = {};  ///< name of the most similar other effect; empty for a pair

    bool hides(const std::string& effect) const;
    /// Whether the diagnosis should name the effect alone: a single effect with a noncentrality of
    /// at least 59, of which the most similar other effect leaves at least 15 unexplained.
    bool well_separated() const;
};

std::string to_string(Truth::Kind kind);

/// Effects that the program's catalogue does not contain: a lid that wobbles, a load cell that
/// saturates, a torque that steps up after some time, menisci that merge above a liquid content.
const std::vector<Effect>& outside_effects();

/// Right answers for an effect outside the catalogue: the change of one of `quantities`, varying
/// with one of `coordinates` ("none": equal at all conditions). Several coordinates are stated only
/// where they describe the same change.
struct RightShape {
    std::vector<std::string> quantities, coordinates;
};

struct OutsideEffect {
    Effect effect;
    RightShape shape;
};

/// Further effects that the program's catalogue does not contain. Their formulas were written
/// without knowledge of the formulas that the program proposes for unknown changes.
const std::vector<OutsideEffect>& more_outside_effects();

/// Returns the right answers for an effect outside the catalogue.
/// @throws std::invalid_argument where `effect` is in neither `outside_effects` nor
///         `more_outside_effects`
RightShape right_shape(std::string_view effect);

/// Reads the table of hidden truths. The table is stored because the sizes of the effects were
/// chosen with an emulator: a better emulator would choose other sizes, and earlier runs would be
/// lost.
/// @throws InputError where the file cannot be read or has a wrong entry
std::vector<Truth> read_truths(const std::filesystem::path& file);
void write_truths(const std::filesystem::path& file, const std::vector<Truth>& truths);

}  // namespace pendular::bench
