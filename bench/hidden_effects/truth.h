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
    /// Hidden effects of the truth: none (`complete`), one effect of the catalogue, a pair of
    /// effects of the catalogue, or one effect outside the catalogue.
    enum class Kind { complete, effect, pair, outside };
    Kind kind = Kind::complete;
    /// Name of the truth, such as "lid-slip at 25" for the effect lid-slip with the planned
    /// noncentrality 25.
    std::string name;
    std::vector<ActiveEffect> hidden;
    double friction = 0.11;
    /// Noncentrality v [1]: squared length of the vector of the changes of all readings by the
    /// hidden effects, in units of the planned standard errors. The part of the change that the
    /// calibrated parameters can imitate does not count. For an effect outside the catalogue, the
    /// part that the best pair of known effects can imitate does not count either. For a pair of
    /// hidden effects, v is the minimum of the noncentralities of both effects.
    double noncentrality = 0;
    /// Squared length [1] of the part of the change of the readings that the most similar other
    /// effect cannot imitate: |g|^2 (1 - cos^2). g is the change by the hidden effect, in units of
    /// the planned standard errors and without the part that the calibrated parameters can imitate.
    /// cos is the cosine of the angle between the changes by both effects. 0 for a pair and without
    /// hidden effects.
    double separation = 0;
    std::string most_like = {};  ///< name of the most similar other effect; empty for a pair

    bool hides(const std::string& effect) const;
    /// Whether the diagnosis should name the hidden effect alone. The truth must hide a single
    /// effect of the catalogue, with a noncentrality of at least 59 and a `separation` of at least
    /// 15.
    bool well_separated() const;
};

std::string to_string(Truth::Kind kind);

/// Returns four effects that the program's catalogue does not contain: a lid that wobbles, a load
/// cell that saturates, a measured torque that changes by a step at some time, and menisci that
/// merge above some liquid content.
const std::vector<Effect>& outside_effects();

/// Right answers of a diagnosis for a hidden effect outside the catalogue. An answer is right if it
/// states that one of `quantities` changes with one of `coordinates`. The coordinate "none" means
/// that the change is equal at all conditions. The first of `quantities` is the quantity that truly
/// changes.
struct RightShape {
    std::vector<std::string> quantities, coordinates;
};

/// Effect that the program's catalogue does not contain, with the right diagnosis.
struct OutsideEffect {
    Effect effect;
    RightShape shape;
};

/// Returns further effects that the program's catalogue does not contain, with the right diagnosis
/// of each. Their formulas were written without knowledge of the formulas that the program proposes
/// if no effect of the catalogue explains the readings.
const std::vector<OutsideEffect>& more_outside_effects();

/// Returns the right answers for an effect outside the catalogue.
/// @throws std::invalid_argument if `effect` is in neither `outside_effects` nor
///         `more_outside_effects`
RightShape right_shape(std::string_view effect);

/// Reads the table of hidden truths (true friction and effects). The table is stored because the
/// sizes of the effects were chosen with an emulator. A better emulator would choose other sizes,
/// and earlier simulation runs would be useless.
/// @throws InputError if the file cannot be read or has a wrong entry
std::vector<Truth> read_truths(const std::filesystem::path& file);
void write_truths(const std::filesystem::path& file, const std::vector<Truth>& truths);

}  // namespace pendular::bench
