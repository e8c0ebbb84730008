#pragma once

#include <cstddef>
#include <vector>

#include "data/reading.h"

namespace pendular {

/// Whether two readings were taken at one condition: equal liquid contents, both steady shear or
/// both failure, and normal stresses, inertial numbers, preshear stresses and volumes of grains
/// that agree within 2 %.
bool are_replicates(const Reading& a, const Reading& b);

/// Returns the indices of the readings at each condition in ascending order, by the order of the
/// first readings. A reading joins the first group of whose first reading it is a replicate
/// (`are_replicates`), and otherwise begins a group.
std::vector<std::vector<std::size_t>> replicate_groups(const std::vector<Reading>& readings);

/// Averages readings of similar normal stress, inertial number, height and time, so that
/// statistical tests take no longer for many readings than for few. Returns one mean reading per
/// bin, in the order of the first members, with the position in the file of the first member; the
/// readings unchanged if there are at most `most`.
///
/// Readings of one bin agree in liquid content, volume of grains, state (steady or failure after
/// equal preshear) and estimate of the scatter. Files share a bin only if more than `most`/2 bins
/// would be needed otherwise; readings whose errors come only from the scatter within one run never
/// share one with other files. Averaging does not reduce errors that readings have in common.
/// @param most exceeded only if there are more kinds of readings that must not be averaged with
///         each other
std::vector<Reading> binned_readings(const std::vector<Reading>& readings, std::size_t most);

}  // namespace pendular
