#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "analysis/ladder.h"
#include "workflow/study_diagnosis.h"
#include "workflow/switched_models.h"

namespace pendular {

/// The study's model with the error of a suspect measurement corrected.
struct CorrectedModel {
    std::string of;  ///< what is suspect: "dry_2.csv"
    /// 100 (1 - model/measured) of each reading [%]: shear stress, then solid fraction.
    std::array<std::vector<double>, 2> deviations;
    std::array<double, 2> rms = {0, 0};  ///< of these [%]
};

/// How the error of a study's model fell, for the first picture of its page.
struct PageStory {
    Ladder ladder;  ///< may be empty
    /// Combination of `SwitchedModels` with the effects that the diagnosis finds missing; empty
    /// where nothing is missing or no switch has these effects.
    std::optional<std::size_t> proposed = {};
    std::string proposed_name = {};  ///< of this model in the picture: "+ wall-friction"
    std::string proposed_as = {};    ///< words below the name: "proposed", "1 of 3 rivals"
    std::optional<CorrectedModel> corrected = {};  ///< empty unless a measurement is suspect
};

PageStory page_story(const Ladder& ladder, const StudyDiagnosis& diagnosis,
                     const SwitchedModels& switched);

/// Returns the name of a step in a picture: "+ wall-friction", or "start".
std::string step_name(const LadderStep& step);

}  // namespace pendular
