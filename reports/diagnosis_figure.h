#pragma once

#include "analysis/diagnosis/diagnosis.h"
#include "reports/figure.h"

namespace pendular {

/// Figure of the most significant candidates of a diagnosis, the effects that the model may lack.
/// Above: reduction of chi2 by each effect, predicted and refitted. Below: estimated size of each
/// effect over the smallest size of interest, beside the smallest size that the readings would
/// reveal.
Figure diagnosis_figure(const Diagnosis& diagnosis, const ModelSpace& space);

}  // namespace pendular
