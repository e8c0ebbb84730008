#pragma once

#include <string>
#include <vector>

#include "analysis/proposals/propose.h"
#include "calib/model/model.h"
#include "data/reading.h"
#include "data/study/study.h"
#include "reports/figure.h"

namespace pendular {

/// Returns the end of a sentence, without a full stop, on a fitted change of unknown cause: "the
/// shown torque is 9.80 +- 0.40 % larger than in the model where the time since the first recording
/// began is above 12 s, and agrees elsewhere".
/// @param reference words for the values with which the changed values are compared
std::string phrase_on(const FittedShape& shape, const std::string& reference = "in the model");

/// Returns `phrase_on` with a capital, without a full stop.
std::string sentence_on(const FittedShape& shape);

/// Returns a sentence for each change of a proposal, without a full stop at the end.
std::string sentence_on(const Proposal& proposal);
std::vector<std::string> sentences_on(const std::vector<Proposal>& proposals);

/// Returns lines on proposals, the best first, with chi2/dof without and with the changes of the
/// best. Empty if `proposals` is empty.
/// @param chi2 chi2 of the model without the changes [1]
/// @param dof degrees of freedom of `chi2`
std::vector<std::string> proposal_lines(const std::vector<Proposal>& proposals, double chi2,
                                        int dof);

/// Returns a figure of a proposed change of unknown cause: the deviations of shear stress and of
/// solid fraction from the study's model [%], as measured and as predicted with the change. The x
/// axis is the quantity with which the change varies, or the normal stress if it is constant.
/// @param model predictions of the study's model without the change
Figure proposal_figure(const Proposal& proposal, const std::vector<Reading>& readings,
                       const Prediction& model);

/// Returns a text that asks to check a sensor with known values over the range of the readings.
/// @param target "torque", "normal_force" or "height"
/// @param change proposed change of the shown quantity, which gives the error to expect; may be
///        null
/// @param too_large suggested error over the shown value [1], positive if the sensor shows too
///        much; used if `change` is null; 0: unknown
std::string sensor_check(const std::string& target, const std::vector<Reading>& readings,
                         const Study& study, const FittedShape* change = nullptr,
                         double too_large = 0);

}  // namespace pendular
