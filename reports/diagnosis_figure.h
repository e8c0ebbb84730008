#pragma once

#include "analysis/diagnosis/diagnosis.h"
#include "reports/figure.h"

namespace pendular {

/// Figure of up to nine effects that a study's model may lack, the largest reduction of chi2 first.
/// Above: reduction of chi2 if the effect is added to the model, predicted and refitted. Below:
/// estimated size of each effect over its smallest size of interest [1], beside the smallest size
/// that 80 % of such studies would show. Without panels where no effect could show in the readings.
Figure diagnosis_figure(const Diagnosis& diagnosis, const ModelSpace& space);

}  // namespace pendular
