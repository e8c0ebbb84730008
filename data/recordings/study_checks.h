#pragma once

#include <vector>

#include "data/reading.h"
#include "data/study/study.h"

namespace pendular {

/// Checks of a study and its readings, on which readings a model may hold. Each returns at most one
/// remark unless stated otherwise.

/// Finds patterns of study.toml that match no file: one remark for each.
std::vector<Remark> patterns_without_file(const Study& study);

/// Finds readings whose liquid content is beyond separate bridges, with the saturation of their
/// pores.
std::vector<Remark> merging_bridges(const std::vector<Reading>& readings);

/// Finds a cell in which few beads fit side by side, or on one another.
std::vector<Remark> few_beads(const Study& study, const std::vector<Reading>& readings);

/// Finds readings that are points of failure.
std::vector<Remark> points_of_failure(const std::vector<Reading>& readings);

/// Finds readings whose step is known and in which the weight of the grains over the area of the
/// cell, which raises the normal stress at the base of the sample, exceeds 10 % of the normal
/// stress. None without a cell, and if the model has the effect grain-weight.
std::vector<Remark> grain_weight(const Study& study, const std::vector<Reading>& readings);

}  // namespace pendular
