#pragma once

#include "analysis/diagnosis/diagnosis.h"
#include "reports/figure.h"

namespace pendular {

/// Returns a figure of up to nine candidate effects, the largest reduction of chi2 first. The upper
/// panel shows the reduction of chi2 [1], predicted and refitted. The lower panel shows the
/// estimated size of each effect beside the size that 80 % of repetitions of the study would
/// detect, both divided by the smallest size of interest [1]. Without panels if the readings could
/// reveal none of the effects.
Figure diagnosis_figure(const Diagnosis& diagnosis, const ModelSpace& space);

}  // namespace pendular
