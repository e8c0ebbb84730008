#pragma once

#include <string_view>

namespace pendular::closures {

/// Levels of accuracy at which a model computes the stress ratio mu* of wet grains, from the
/// simplest formula to the simulation. Each level replaces one approximation of the level below.
/// mu*_0 is the stress ratio of dry grains, Phi the solid fraction, P* the reduced pressure, Z_c
/// the number of contacts per grain, Z_d that of bridges without contact, F_d their mean force, F0
/// the pull-off force.
/// Source: Badetti et al. (2018), the equations named.
enum class Level {
    mohr_coulomb,  ///< mu*_0 + c*/P* with constant reduced cohesion c*, which is fitted, Eq. (16)
    rumpf,         ///< mu*_0 [1 + Phi Z/(pi P*)],  Z = Z_c + 0.5 Z_d (Rumpf's cohesion), Eq. (24)
    strength3,     ///< mu*_0 [1 + Phi Z*/(pi P*)],  Z* = Z_c + Z_d F_d/F0, Eq. (23)
    strength2,     ///< `strength3` minus capillary shear stress over normal stress, Eq. (22)
    strength1,     ///< `strength2` with the capillary normal stress itself, not from Z*, Eq. (19)
    /// In contrast to the formulas, the stress ratio of the contact forces may differ from mu*_0.
    simulation
};

/// Returns the level of a base model, before effects: `mohr_coulomb` for "mohr-coulomb",
/// `strength3` for "rumpf", and `simulation` for any other name, such as "dem".
inline Level level_of_base(std::string_view base) {
    if (base == "mohr-coulomb") return Level::mohr_coulomb;
    return base == "rumpf" ? Level::strength3 : Level::simulation;
}

}  // namespace pendular::closures
