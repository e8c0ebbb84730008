#pragma once

#include <string_view>
#include <vector>

#include "data/annular_cell.h"
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

/// Range of liquid contents [1] in which the liquid forms bridges, most of them separate.
/// Source: Badetti et al. (2018), section 3.1: their smallest liquid content is 0.003, the largest
/// that they measured 0.075.
constexpr double driest_pendular = 0.002, wettest_pendular = 0.075;

/// Returns 1 for a liquid content above the pendular range, -1 for one below, and 0 inside of it
/// and for dry grains.
int beyond_pendular_range(double liquid_content);

/// Returns the power of ten, at most 9, that leads from a value of a quantity to those of most
/// flows, the smallest one; 0 if none does.
int power_to_usual(std::string_view quantity, double value);

/// Finds readings whose solid fraction, stress ratio, inertial number, reduced pressure or liquid
/// content is impossible in steady shear: a remark of kind `impossible_reading` for each reading,
/// and one for each limit that readings violate.
std::vector<Remark> impossible_readings(const std::vector<Reading>& readings, const Study& study);

/// Finds a torque that is constant over all rows of a recording or, if the torque varies, a
/// constant gap, which may have been measured coarsely. Recordings of less than `shortest_step`
/// rows are not checked.
std::vector<Remark> constant_columns(const Recording& recording);

/// Finds an implausible solid fraction at the median gap of a recording. For recordings that gave
/// no reading: a wrong gap or volume of grains may be why no step became steady.
std::vector<Remark> impossible_filling(const Recording& recording, const AnnularCell& cell);

}  // namespace pendular
