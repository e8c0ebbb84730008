#pragma once

#include <optional>

#include "analysis/diagnosis/where_it_fails.h"
#include "analysis/ladder.h"
#include "analysis/left_out.h"
#include "analysis/misfit/believable.h"
#include "analysis/misfit/compare.h"
#include "calib/fit/study_model.h"

namespace pendular {

/// Calibration of a study with the model whose parameters were fitted, and what follows from it.
struct FittedStudy {
    Calibration calibration;
    std::optional<StudyModel> model = {};  ///< empty in results that tests make up
    Comparison comparison = {};            ///< of all readings, fitted or not
    Belief belief = {};           ///< empty for the fit before a change, which is not judged
    LeftOut left_out = {};        ///< no conditions: no cross-validation was made
    LadderStep ladder_step = {};  ///< summary, set by `cross_validate`
};

/// Assembles the model of a calibration and compares all readings with its predictions, which it
/// computes if the calibration was read from a file.
/// @throws InputError if the calibration does not belong to the study (`check_parameters`)
FittedStudy fitted(const ResolvedStudy& study, Calibration calibration);

/// Summarises a fit as a step of the ladder, with the errors of the cross-validation.
/// @param refits whether to compute these errors, which takes a refit for each condition
void cross_validate(FittedStudy& fitted, bool refits = true);

/// Judges whether a fit can be believed. Reasons against it are a misfit larger than the errors
/// allow, a fitted parameter at the end of its range, implausible readings, and a column that was
/// probably read in a wrong unit.
Belief belief_in(const FittedStudy& fitted, const ResolvedStudy& study,
                 const Measurements& measurements);

/// Finds where the fitted model deviates significantly from the readings.
WhereItFails where_it_fails(const FittedStudy& fitted, const Measurements& measurements);

}  // namespace pendular
