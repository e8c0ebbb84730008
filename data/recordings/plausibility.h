#pragma once

#include <string>

#include "data/reading.h"
#include "data/recordings/recording.h"
#include "data/study/study.h"

namespace pendular {

/// Least and greatest solid fraction [1] of grains in steady shear. Equal spheres fill at most
/// pi/sqrt(18) = 0.7405 of space; steady shear under load keeps them above random loose packing,
/// 0.55, and cohesion of separate bridges lowers that by a few hundredths.
/// Source: Hales, Ann. Math. 162 (2005) 1065; Onoda and Liniger, Phys. Rev. Lett. 64 (1990) 2727.
constexpr double loosest_solid_fraction = 0.4, densest_solid_fraction = 0.74;

/// Least stress ratio [1] of steady shear: spheres without any friction have 0.10, by geometry
/// alone, and half of that leaves room for an offset of the torque.
/// Source: Peyneau and Roux, Phys. Rev. E 78 (2008) 011307.
constexpr double least_stress_ratio = 0.05;

/// Greatest stress ratio [1] of grains under a reduced pressure P* (infinite where they are dry):
///     1.5 (1 + 1/P*)
/// Dry grains stay below 1.5, a slope of 56 degrees, also where they are angular or flow fast.
/// A cohesion c adds c/s22 = c* / P*, with c* = 0.2 to 0.4, 0.6 at the most (Badetti et al. 2018):
/// 1.5 is 2.5 times that.
double greatest_stress_ratio(double reduced_pressure);

/// Adds what is doubtful about each reading: a solid fraction, stress ratio, inertial number,
/// reduced pressure or liquid content beyond what steady shear of (wet) grains can have. Such
/// readings go to `excluded`, or stay where the study keeps them.
void doubt_impossible_readings(Measurements& measurements, const Study& study);

/// Adds a doubt about a recording whose torque or gap is the same in every row. A stuck torque
/// makes no reading: what was made of it is set aside, unless the choice keeps it. A stuck gap may
/// have been measured coarsely; only its error is unknown.
void doubt_stuck_columns(const Recording& recording, Measurements& part,
                         const ImportSettings& choice);

/// Adds a doubt about a recording that makes no reading, where the solid fraction at its median gap
/// cannot be right: that may be the reason why.
void doubt_filling(const Recording& recording, const AnnularCell& cell, Measurements& part);

/// A reading as an entry of `excluded`.
Excluded left_out(const Reading& reading, std::string reason);

}  // namespace pendular
