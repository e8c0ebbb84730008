#pragma once

#include "analysis/diagnosis/diagnosis.h"
#include "reports/figure.h"

namespace pendular {

/// Figure of up to nine effects that a study's model may lack, the largest reduction of chi2 first.
/// Upper panel: reduction of chi2 [1] if the effect is added to the model, as predicted and as
/// found by a refit. Lower panel: estimated size of each effect divided by its smallest size of
/// interest [1], beside the smallest size that a study of this kind would detect with 80 %
/// probability. Has no panels if the readings could reveal none of the effects.
Figure diagnosis_figure(const Diagnosis& diagnosis, const ModelSpace& space);

}  // namespace pendular
