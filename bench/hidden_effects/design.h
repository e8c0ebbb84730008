#pragma once

#include <array>
#include <vector>

#include "bench/hidden_effects/truth.h"

namespace pendular::bench {

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
