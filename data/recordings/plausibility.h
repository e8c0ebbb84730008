#pragma once

#include <string>

#include "data/reading.h"
#include "data/recordings/recording.h"
#include "data/study/study.h"

namespace pendular {

/// Smallest and largest plausible solid fraction [1] in steady shear. Equal spheres fill at most
/// pi/sqrt(18) = 0.7405 of space. Dry grains under load stay above random loose packing, 0.55;
/// bridges lower this by a few hundredths, and 0.4 leaves a margin.
/// Source: Hales, Ann. Math. 162 (2005) 1065; Onoda and Liniger, Phys. Rev. Lett. 64 (1990) 2727.
constexpr double loosest_solid_fraction = 0.4, densest_solid_fraction = 0.74;

/// Smallest plausible stress ratio [1] of steady shear: half of that of frictionless spheres, 0.10,
/// so that an offset of the torque is tolerated.
/// Source: Peyneau and Roux, Phys. Rev. E 78 (2008) 011307.
constexpr double least_stress_ratio = 0.05;

/// Returns the largest plausible stress ratio [1] at a reduced pressure P* [1]; infinite P*: dry.
///     1.5 (1 + 1/P*)
/// Dry grains stay below 1.5 (a slope of 56 degrees). Cohesion adds c*/P*; Badetti et al. (2018)
/// found reduced cohesions c* of at most 0.6, and the limit allows for 1.5.
double greatest_stress_ratio(double reduced_pressure);

/// Adds doubts about readings whose solid fraction, stress ratio, inertial number, reduced pressure
/// or liquid content is impossible in steady shear. Unless the study keeps implausible readings,
/// they are moved to `measurements.excluded`.
void doubt_impossible_readings(Measurements& measurements, const Study& study);

/// Adds a doubt if the torque of a recording is constant over all rows, or if the torque varies and
/// the gap is constant. For a constant torque, all readings are moved to `part.excluded`, unless
/// `choice.keep_implausible`; for a constant gap they stay, since it may have been measured
/// coarsely. Recordings of less than `shortest_step` rows are not checked.
/// @param part readings of the recording
void doubt_stuck_columns(const Recording& recording, Measurements& part,
                         const ImportSettings& choice);

/// Adds a doubt if the solid fraction at the median gap of a recording is not plausible. For
/// recordings that gave no reading: a wrong gap or volume of grains may be why no step became
/// steady.
void doubt_solid_fraction_of(const Recording& recording, const AnnularCell& cell,
                             Measurements& part);

/// Returns an entry for `Measurements::excluded` with the rows of a reading.
Excluded left_out(const Reading& reading, std::string reason);

}  // namespace pendular
