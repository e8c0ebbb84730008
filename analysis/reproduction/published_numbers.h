#pragma once

#include <vector>

#include "analysis/reproduction/scoreboard.h"

namespace pendular {

/// Compares simulations with the numbers and statements of Badetti et al. (2018) about dry and wet
/// grains, and returns a row for each comparison that runs allow. The published numbers have the
/// following uncertainties:
/// - a number with an error: the error;
/// - a number without an error: half a unit of its last digit;
/// - a number of one digit with the word "about": 10 %;
/// - most ranges: half a unit of the last digit of the more precise end;
/// - ranges of the reduced cohesion, of its growth and of the ratio of capillary shear stresses,
///   and limits with a sign such as <=: none.
/// A statement without a number, such as "equal", is compared with a range that was chosen for the
/// comparison, such as 0.99 to 1.01.
std::vector<ScoreboardRow> compare_with_published(const PaperStudy& study);

}  // namespace pendular
