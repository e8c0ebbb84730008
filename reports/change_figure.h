#pragma once

#include "reports/figure.h"
#include "workflow/study_change.h"

namespace pendular {

/// Returns the figure `change`: measured minus predicted shear stress and solid fraction [%] of
/// each reading against the normal stress, before a change of the study's effects in the left
/// column and after it in the right one. Both columns share their axes, so that one sees the error
/// fall.
Figure change_figure(const ChangedStudy& changed);

}  // namespace pendular
