#pragma once

#include <cstdint>
#include <vector>

#include "data/study/study.h"
#include "sim/lab/lab_plan.h"

namespace pendular::bench {

/// Returns the simulation settings of the benchmark's virtual laboratories and of the models fitted
/// to their recordings. The stiffness number of the grains is 1500, unlike that of the atlas (the
/// runs that come with the program).
Fidelity truth_fidelity();

/// Returns the experimental plan of a virtual laboratory of the benchmark. Set points, number of
/// grains, stiffness number and seeds differ from those of the runs in the atlas (the runs that
/// come with the program).
/// @param friction true friction coefficient [1]
/// @param world seed of the simulations of the virtual laboratory
LabPlan rig(double friction, std::uint64_t world);

/// Returns the conditions (normal stress, inertial number, liquid content) of all planned readings,
/// in the order of the recordings of the plan. The height of the sample is computed from a typical
/// solid fraction of 0.6.
std::vector<Condition> planned_conditions(const LabPlan& plan);

/// Returns the study (grains, liquid, cell and liquid contents) of the recordings that a plan
/// produces. The study has no files and no measured values.
Study study_of(const LabPlan& plan);

}  // namespace pendular::bench
