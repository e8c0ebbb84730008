#pragma once

#include <vector>

#include "analysis/proposals/propose.h"
#include "calib/model/model.h"
#include "data/reading.h"
#include "reports/figure.h"

namespace pendular {

/// Returns a figure of a proposed change of unknown cause: the deviations of shear stress and of
/// solid fraction from the study's model [%], as measured and as predicted with the change. The x
/// axis is the quantity with which the change varies, or the normal stress if it is constant.
/// @param model predictions of the study's model without the change
Figure proposal_figure(const Proposal& proposal, const std::vector<Reading>& readings,
                       const Prediction& model);

}  // namespace pendular
