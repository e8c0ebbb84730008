#pragma once

#include "analysis/diagnosis/diagnosis.h"
#include "reports/figure.h"

namespace pendular {

/// Returns a figure of up to nine physical effects that a study's model may lack, the effect with
/// the largest reduction of chi2 first. The upper panel shows the reduction of chi2 [1], as
/// predicted from the residuals and as found by a refit. The lower panel shows the estimated size
/// of each effect, beside the smallest size that 80 % of repetitions of the study would detect.
/// Sizes are divided by the smallest size of interest of the effect [1]. The figure has no panels
/// if the readings could reveal none of the effects.
Figure diagnosis_figure(const Diagnosis& diagnosis, const ModelSpace& space);

}  // namespace pendular
