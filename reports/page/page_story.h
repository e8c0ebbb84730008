#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "analysis/ladder.h"
#include "workflow/study_diagnosis.h"
#include "workflow/switched_models.h"

namespace pendular {

/// How the error of a study's model fell, for the first picture of its page.
struct PageStory {
    Ladder ladder;  ///< may be empty
    /// Combination of `SwitchedModels` with the effects that the diagnosis finds missing, and its
    /// name in the picture; empty where nothing is missing or no switch has these effects.
    std::optional<std::size_t> proposed = {};
    std::string proposed_name = {};
};

PageStory page_story(const Ladder& ladder, const StudyDiagnosis& diagnosis,
                     const SwitchedModels& switched);

/// Returns the name of a step in a picture: "+ wall-friction", or "start".
std::string step_name(const LadderStep& step);

}  // namespace pendular
