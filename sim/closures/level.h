#pragma once

#include <string_view>

namespace pendular::closures {

/// Levels of accuracy at which the stress ratio of wet grains is computed, from the simplest
/// formula to the simulation. Each level replaces one approximation of the level below. Symbols:
/// P*: reduced pressure; mu*_0: stress ratio of dry grains; Phi: solid fraction; Z_c: contacts per
/// grain; Z_d: distant bridges per grain (bridges between grains that do not touch); F_d: mean
/// force of distant bridges; F0: pull-off force.
/// Source: Badetti et al. (2018).
enum class Level {
    /// Stress ratio of dry grains plus c*/P*, with reduced pressure P* and a constant reduced
    /// cohesion c* that is fitted to measured stress ratios (eq:mohrcoulomb2).
    mohr_coulomb,
    /// Stress ratio of wet grains with Rumpf's cohesion, from the approximate coordination number Z
    /// (eq:cohesion3):
    ///     mu*_0 [1 + Phi Z/(pi P*)],   Z = Z_c + 0.5 Z_d
    rumpf,
    /// Stress ratio of wet grains from the effective coordination number Z* (eq:strength3):
    ///     mu*_0 [1 + Phi Z*/(pi P*)],   Z* = Z_c + Z_d F_d/F0
    strength3,
    /// Stress ratio of level `strength3` minus the capillary shear stress divided by the normal
    /// stress (eq:strength2).
    strength2,
    /// Stress ratio of level `strength2` with the capillary normal stress itself in place of its
    /// estimate by the effective coordination number (eq:strength1).
    strength1,
    /// Stress ratio of wet grains from a simulation. In contrast to the formulas, the stress ratio
    /// of the contact forces may differ from that of dry grains.
    simulation
};

/// Returns the level of accuracy at which a study's base model computes the stress ratio of wet
/// grains: "mohr-coulomb" is `mohr_coulomb`, "rumpf" is `strength3`, and any other name ("dem") is
/// `simulation`.
Level level_of_base(std::string_view base);

}  // namespace pendular::closures
