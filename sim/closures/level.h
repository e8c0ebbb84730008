#pragma once

#include <string_view>

namespace pendular::closures {

/// Levels of the ladder of formulas for the stress ratio mu* of wet grains at the reduced pressure
/// P*, from the simplest to the simulation. Each level replaces one approximation of the level
/// below. mu*_0: stress ratio of dry grains; Phi: solid fraction; Z_c contacts and Z_d bridges
/// without contact per grain; F_d: mean force of bridges without contact; F0: pull-off force.
/// Source: Badetti et al. (2018).
enum class Level {
    /// mu*_0 + c*/P* with a constant c* fitted to measured strengths (eq:mohrcoulomb2)
    mohr_coulomb,
    /// mu*_0 [1 + Phi Z/(pi P*)] with Z = Z_c + 0.5 Z_d, Rumpf's cohesion (eq:cohesion3)
    rumpf,
    /// the same with Z = Z* = Z_c + Z_d F_d/F0 (eq:strength3)
    strength3,
    /// the same less the capillary shear stress over the normal stress (eq:strength2)
    strength2,
    /// the capillary normal stress itself in place of its estimate by Z* (eq:strength1)
    strength1,
    /// the stress ratio of the simulation, whose contacts need not have that of dry grains
    simulation
};

/// Returns the level that a base model of studies is: "mohr-coulomb", "rumpf" (eq:strength3) or
/// "dem", the simulation.
Level level_of_base(std::string_view base);

}  // namespace pendular::closures
