#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "data/study/study.h"
#include "sim/catalogue/effect.h"

namespace pendular {

/// Name of the error that the friction of the side walls is not known: the key of [cell] that would
/// state it.
constexpr std::string_view unknown_wall_friction = "wall_friction";
/// Largest friction of the walls of a cell against beads [1] if nothing is known of it. Sliding
/// friction of beads on PTFE is about 0.05 to 0.1, on glass and polished metal 0.1 to 0.2, on
/// acrylic and worn metal up to 0.3. Rougher walls hardly add to the drag, since beads roll on them
/// (`mobilised`).
constexpr double largest_unknown_wall_friction = 0.3;

/// Whether an effect describes the friction of side walls, so that a study which fits, states or
/// measures its parameter knows something of it.
bool is_of_wall_friction(const std::string& effect);

/// Error that all readings share, by what a study does not say of its walls: an effect of which
/// nothing, or any share up to all that is likely, acts.
struct UnknownOfWalls {
    std::string name;
    double root_mean_square = 0;  ///< of the effect's parameter
    const Effect* effect = nullptr;
};

/// Whether an error of this name is by what a study does not say of its walls.
bool is_unknown_of_walls(std::string_view error);

/// Returns the errors of a study whose side walls are close (`walls_are_close`), by what it does
/// not say of them:
/// - `unknown_wall_friction`, unless [cell] states wall_friction, or [instrument] or [[direct]]
///   states an effect of it: all from 0 to the largest is taken for equally likely. Walls of
///   friction raise the torque of a bed that they do not let shear evenly (`shear-localisation`).
/// - `wall-layers`, as long as the model neglects them: all from no loss of strength, as beside
///   rough walls, to that of equal beads beside flat walls. Layers lower the torque.
std::vector<UnknownOfWalls> unknown_of_walls(const Study& study);

}  // namespace pendular
