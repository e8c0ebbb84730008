#pragma once

#include "analysis/diagnosis/diagnosis.h"
#include "reports/figure.h"

namespace pendular {

/// Figure of up to nine effects that a study's model may lack, the largest reduction of chi2 first.
/// Above: reduction of chi2 if the effect is added, predicted and refitted. Below: estimated size
/// of each effect over its smallest size of interest [1], beside the smallest size that the
/// readings would reveal with a power of 0.8. Without panels where the readings could reveal no
/// effect.
Figure diagnosis_figure(const Diagnosis& diagnosis, const ModelSpace& space);

}  // namespace pendular
