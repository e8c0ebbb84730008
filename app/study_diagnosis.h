#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "analysis/compare.h"
#include "analysis/diagnosis.h"
#include "analysis/next_measurement.h"
#include "analysis/unit_mistakes.h"
#include "app/options.h"
#include "app/study_input.h"
#include "calib/study_models.h"

namespace pendular::app {

/// A study with everything its diagnosis is made from.
struct StudyDiagnosis {
    StudyInput input;
    std::vector<Reading> readings;  ///< dry first
    std::unique_ptr<StudyModels> models;
    Evidence evidence;
    Diagnosis diagnosis;
    std::optional<UnitMistake> mistake = {};  ///< that would mend the misfit

    /// Of the model as it is.
    Misfit misfit() const { return {diagnosis.chi2, diagnosis.dof, freedom_behind(readings)}; }
};

/// Reads and diagnoses a study for a command that writes `output`, from the atlas and all stored
/// runs, with its stages on standard error.
/// @throws InputError for what is wrong in its files or cannot be diagnosed
/// @throws dem::Interrupted after Ctrl-C
StudyDiagnosis diagnosed(const CommonOptions& options, std::uint64_t seed,
                         const std::filesystem::path& output);

/// The models that stand, to be told apart; where none does, the one as it is.
std::vector<Rival> rivals_of(const Diagnosis& diagnosis, const StudyModels& models);

}  // namespace pendular::app
