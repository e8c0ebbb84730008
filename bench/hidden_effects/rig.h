#pragma once

#include <cstdint>
#include <vector>

#include "data/study/study.h"
#include "sim/lab/lab_plan.h"

namespace pendular::bench {

/// Fidelity of the truth and of the model fitted to it: its grains have their own stiffness, which
/// differs from that of the atlas.
Fidelity truth_fidelity();

/// Plan of every laboratory of the benchmark. Set points, number of grains (1.5 times the
/// fidelity's), stiffness and seeds are none of the atlas'. `world`: seeds of the simulations.
LabPlan rig(double friction, std::uint64_t world);

/// The conditions it asks for, a reading each, as `import` will describe them.
std::vector<Condition> conditions_asked(const LabPlan& plan);

/// The study that its recordings make, without files.
Study study_of(const LabPlan& plan);

}  // namespace pendular::bench
