#pragma once

#include <string_view>

namespace pendular::closures {

/// Levels of accuracy at which a model computes the stress ratio of wet grains, from the simplest
/// formula to the simulation. Each level replaces one approximation of the level below.
/// Source: Badetti et al. (2018).
enum class Level {
    /// Stress ratio of dry grains plus c*/P*. P* is the reduced pressure. The constant reduced
    /// cohesion c* is fitted to measured stress ratios.
    /// Source: Badetti et al. (2018), Eq. (16).
    mohr_coulomb,
    /// Stress ratio of wet grains with Rumpf's cohesion, from an approximate coordination number Z:
    ///     mu*_0 [1 + Phi Z/(pi P*)],   Z = Z_c + 0.5 Z_d
    /// mu*_0 is the stress ratio of dry grains, Phi the solid fraction, P* the reduced pressure,
    /// and Z_c the number of contacts per grain. Z_d is the number of distant bridges per grain
    /// (bridges between grains that do not touch).
    /// Source: Badetti et al. (2018), Eq. (24).
    rumpf,
    /// Stress ratio of wet grains from the effective coordination number Z*:
    ///     mu*_0 [1 + Phi Z*/(pi P*)],   Z* = Z_c + Z_d F_d/F0
    /// mu*_0 is the stress ratio of dry grains, Phi the solid fraction, P* the reduced pressure,
    /// and Z_c the number of contacts per grain. Z_d is the number of distant bridges per grain
    /// (bridges between grains that do not touch), F_d the mean force of distant bridges, and F0
    /// the pull-off force.
    /// Source: Badetti et al. (2018), Eq. (23).
    strength3,
    /// Stress ratio of level `strength3` minus the ratio of the capillary shear stress to the
    /// normal stress.
    /// Source: Badetti et al. (2018), Eq. (22).
    strength2,
    /// Stress ratio of level `strength2`, with the capillary normal stress itself in place of the
    /// estimate of this stress from the effective coordination number.
    /// Source: Badetti et al. (2018), Eq. (19).
    strength1,
    /// Stress ratio of wet grains from a simulation. In contrast to the formulas, a simulation
    /// allows the stress ratio of the contact forces to differ from the stress ratio of dry grains.
    simulation
};

/// Returns the level of accuracy at which a study's base model (the model before effects are added)
/// computes the stress ratio of wet grains. The level is `mohr_coulomb` for "mohr-coulomb",
/// `strength3` for "rumpf", and `simulation` for any other name, such as "dem".
/// @param base name of the base model
Level level_of_base(std::string_view base);

}  // namespace pendular::closures
