#pragma once

#include "analysis/diagnosis/diagnosis.h"
#include "reports/figure.h"

namespace pendular {

/// The most telling candidates of a diagnosis: by how much each lowers chi2, predicted and
/// refitted, and how large each seems to be in units of the smallest effect of interest, beside the
/// size from which on it is seen.
Figure diagnosis_figure(const Diagnosis& diagnosis, const ModelSpace& space);

}  // namespace pendular
