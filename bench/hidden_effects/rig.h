#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "bench/hidden_effects/truth.h"
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

/// Chooses the hidden truths (true friction and effects) of the benchmark's virtual laboratories.
/// The truths are
/// - the complete model, which hides no effect;
/// - each effect of the catalogue, once for each of `noncentralities`, or once if the effect is a
///   switch (on or off);
/// - pairs of effects;
/// - each effect of `outside_effects`, with the last noncentrality.
/// If the bounds of an effect's parameter do not permit a noncentrality, one truth has the value at
/// the bound. Truths with a noncentrality below 5 are left out.
/// @param noncentralities values of the noncentrality [1] (`Truth::noncentrality`); an emulator
///        predicts the size of an effect that gives each value
std::vector<Truth> planned_truths(const std::vector<double>& noncentralities);

/// Returns hidden truths with the effects of `more_outside_effects`, one for each effect and each
/// of `noncentralities` [1] (`Truth::noncentrality`). If the bounds of an effect's parameter do not
/// permit a noncentrality, one truth has the value at the bound. Truths with a noncentrality below
/// 5 are left out.
std::vector<Truth> planned_outside_truths(const std::vector<double>& noncentralities);

/// Sets noncentrality and separation of the truths with one effect of the catalogue to those of
/// readings that scatter by these relative standard deviations [1] in shear stress and solid
/// fraction.
void set_separations(std::vector<Truth>& truths, const std::array<double, 2>& scatter);

}  // namespace pendular::bench
