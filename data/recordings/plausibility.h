#pragma once

#include <string>

#include "data/reading.h"
#include "data/recordings/recording.h"
#include "data/study/study.h"

namespace pendular {

/// Smallest and largest plausible solid fraction [1] of grains in steady shear. Equal spheres fill
/// at most pi/sqrt(18) = 0.7405 of space. Steady shear under load keeps them above random loose
/// packing, 0.55, and the cohesion of separate liquid bridges lowers this limit by a few
/// hundredths.
/// Source: Hales, Ann. Math. 162 (2005) 1065; Onoda and Liniger, Phys. Rev. Lett. 64 (1990) 2727.
constexpr double loosest_solid_fraction = 0.4, densest_solid_fraction = 0.74;

/// Smallest plausible stress ratio [1] of steady shear: half of the stress ratio 0.10 of
/// frictionless spheres, to leave room for an offset of the torque.
/// Source: Peyneau and Roux, Phys. Rev. E 78 (2008) 011307.
constexpr double least_stress_ratio = 0.05;

/// Largest plausible stress ratio [1] of grains at a reduced pressure P* [1] (infinite for dry
/// grains):
///     1.5 (1 + 1/P*)
/// Dry grains stay below 1.5, a slope of 56 degrees, even if they are angular or flow fast. A
/// cohesion c adds c/s22 = c*/P*, with c* = 0.2 to 0.4 and at most 0.6 (Badetti et al. 2018); the
/// limit allows for 2.5 times this maximum.
double greatest_stress_ratio(double reduced_pressure);

/// Adds doubts (reasons not to believe values, for the user) about readings whose solid fraction,
/// stress ratio, inertial number, reduced pressure or liquid content is impossible in steady shear.
/// Moves these readings to `excluded`, unless the study keeps implausible readings.
void doubt_impossible_readings(Measurements& measurements, const Study& study);

/// Adds a doubt about a recording whose torque or gap is the same in every row. With a constant
/// torque, all its readings are moved to `part.excluded`, unless `choice` keeps implausible
/// readings. With a constant gap the readings stay, since the gap may have been measured coarsely
/// and only its error is unknown.
void doubt_stuck_columns(const Recording& recording, Measurements& part,
                         const ImportSettings& choice);

/// Adds a doubt about a recording that makes no reading, if the solid fraction at its median gap is
/// impossible: a wrong gap or volume of grains may be the reason why no step became steady.
void doubt_filling(const Recording& recording, const AnnularCell& cell, Measurements& part);

/// Returns the entry of `Measurements::excluded`, with the reading's rows, for a reading that is
/// left out for this reason.
Excluded left_out(const Reading& reading, std::string reason);

}  // namespace pendular
