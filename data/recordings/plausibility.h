#pragma once

#include <string>

#include "data/reading.h"
#include "data/recordings/recording.h"
#include "data/study/study.h"

namespace pendular {

/// Smallest and largest plausible solid fraction [1] of grains in steady shear. Equal spheres fill
/// at most pi/sqrt(18) = 0.7405 of space. Dry grains in steady shear under load stay above the
/// solid fraction of random loose packing, 0.55. Liquid bridges lower this limit by a few
/// hundredths, and the value 0.4 leaves a margin.
/// Source: Hales, Ann. Math. 162 (2005) 1065; Onoda and Liniger, Phys. Rev. Lett. 64 (1990) 2727.
constexpr double loosest_solid_fraction = 0.4, densest_solid_fraction = 0.74;

/// Smallest plausible stress ratio [1] of steady shear: half of 0.10, the stress ratio of
/// frictionless spheres, so that an offset of the torque is tolerated.
/// Source: Peyneau and Roux, Phys. Rev. E 78 (2008) 011307.
constexpr double least_stress_ratio = 0.05;

/// Returns the largest plausible stress ratio [1] of grains at a reduced pressure P* [1]. For dry
/// grains, P* is infinite.
///     1.5 (1 + 1/P*)
/// The stress ratio of dry grains stays below 1.5 (a slope of 56 degrees). A cohesion adds c*/P*,
/// with the reduced cohesion c*. Badetti et al. (2018) found c* of at most 0.6. The limit allows
/// for c* = 1.5.
double greatest_stress_ratio(double reduced_pressure);

/// Finds readings (measured states) whose solid fraction, stress ratio, inertial number, reduced
/// pressure or liquid content is impossible in steady shear, and adds messages about the impossible
/// readings to `measurements.doubts`. Unless the study keeps implausible readings, the impossible
/// readings are moved to `measurements.excluded`.
void doubt_impossible_readings(Measurements& measurements, const Study& study);

/// Adds a message to `part.doubts` if the torque of a recording is constant over all rows, or if
/// the torque varies and the gap is constant. If the torque is constant, all readings are moved to
/// `part.excluded`, unless `choice.keep_implausible` is set. If the gap is constant, the readings
/// stay, since the gap may have been measured coarsely. Recordings of less than `shortest_step`
/// rows are not checked.
/// @param part readings of the recording
void doubt_stuck_columns(const Recording& recording, Measurements& part,
                         const ImportSettings& choice);

/// Adds a message to `part.doubts` if the solid fraction at the median gap of a recording is below
/// `loosest_solid_fraction` or above `densest_solid_fraction`. The check is for recordings that
/// gave no reading: a wrong gap or volume of grains may be the reason why no step became steady.
void doubt_solid_fraction_of(const Recording& recording, const AnnularCell& cell,
                             Measurements& part);

/// Returns an entry for `Measurements::excluded` with the position of a reading's rows and the
/// reason why the reading is left out.
Excluded left_out(const Reading& reading, std::string reason);

}  // namespace pendular
