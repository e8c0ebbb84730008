#pragma once

#include <string>
#include <vector>

#include "data/reading.h"
#include "data/study/study.h"
#include "sim/lab/lab_plan.h"

namespace pendular {

/// Returns the plan of a virtual laboratory that measures like a study: with its grains, liquid and
/// cell, its set points in their order, as many replicates, rows and strain per step, and the
/// scatter of its readings. Effects, friction, seeds and settings of simulations are those of
/// `plan`.
///
/// Set points are the measured normal stresses and angular velocities, of which values that differ
/// by less than 2 % count as one; inertial numbers, if these have fewer different values. The
/// scatter of a step's mean is the median relative standard error of the readings. Its part from
/// row to row, with its correlation, comes from the steady rows of the recordings.
/// @param notes receives messages for the user on what could not be taken from the study
/// @throws InputError if the study has no reading of steady shear
LabPlan plan_like(const Study& study, const Measurements& measured, LabPlan plan,
                  std::vector<std::string>& notes);

}  // namespace pendular
