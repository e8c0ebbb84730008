#pragma once

#include <algorithm>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "calib/fit/fit.h"
#include "calib/model/model.h"
#include "calib/model/predictor.h"

namespace pendular {

/// Study's model with further effects, with other effects, or with an error of a part of the
/// measurement that may be wrong, fitted to the readings and direct measurements of the study.
/// Whoever ranks models needs the fit alone, whoever tells them apart the predictor too, and
/// whoever accepts or rejects them the tests; members that nobody asked for have their default
/// values.
struct FittedModel {
    /// Name in tables of rivals: `effects` joined by " + ", with "proposal 1: " before effects that
    /// Pendular proposed and " in place of NAME" after those that replace one; `present_model`
    /// without any. Empty for a model that is no rival.
    std::string name = {};
    EffectSet chosen = {};  ///< added effects, as indices into ModelSpace::candidates()
    /// Index of the suspect part of the measurement whose error is fitted with the parameters.
    std::optional<std::size_t> suspect = {};
    std::vector<std::string> effects = {};  ///< names of the added effects
    std::string in_place_of = {};           ///< listed effect that the model lacks; empty: none
    std::shared_ptr<const Predictor> predictor = {};  ///< null where only the fit is needed
    Fit fit = {};
    double criterion = 0;      ///< Akaike's criterion [1], where models are ranked by it
    double lack_of_fit_p = 0;  ///< p value [1] of the test for lack of fit
    /// p value [1] of the most significant effect or error of the measurement that the model does
    /// not contain, corrected for the number of tests; 1 if none was tested.
    double further_p = 1;
    /// Whether the model counts as fitting: the fit converged and determined all parameters, and
    /// p() is large enough.
    bool accepted = false;

    /// Returns the p value [1] of both tests together, by Bonferroni's inequality.
    double p() const { return std::min(1.0, 2 * std::min(lack_of_fit_p, further_p)); }
};

/// Name of the rival that is the study's model itself.
inline constexpr const char* present_model = "the model as it is";

}  // namespace pendular
