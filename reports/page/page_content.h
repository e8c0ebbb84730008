#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "analysis/diagnosis/impact.h"
#include "analysis/ladder.h"
#include "analysis/misfit/checks.h"
#include "data/reading.h"
#include "reports/page/page_curves.h"
#include "reports/page/page_data.h"
#include "workflow/fitted_study.h"
#include "workflow/study_diagnosis.h"
#include "workflow/switched_models.h"

namespace pendular {

/// Results, texts and settings that the HTML page of a study shows.
struct PageContent {
    std::string study;  ///< name of the study
    /// Path of the study as the user typed it, for commands; quoted if a shell needs quotes.
    std::string study_argument;
    const ResolvedStudy& resolved;
    const Measurements& measurements;
    const StudyDiagnosis& diagnosis;
    Checks checks;                            ///< tests of the residuals of the study's model
    std::optional<ImpactTable> impacts = {};  ///< empty: not computed
    Ladder ladder = {};                       ///< may be empty
    std::vector<std::string> steps = {};      ///< next steps (`step_lines`)
    std::string command = {};                 ///< `pendular` command to give next (`next_command`)
    /// Fitted models, one for each combination of the leading effects: those that the study lists
    /// or that the diagnosis finds most important. The reader can switch them on and off.
    SwitchedModels switched;
    std::vector<PagePanel> panels;  ///< with the curves of `switched`
    std::string version;            ///< of the program
    SessionOptions options;         ///< the page states the name of the fidelity and the seed
    std::size_t runs = 0;           ///< number of training simulations
    std::string runs_hash = {};     ///< of these simulations (`runs_json`)
    /// Calibration in the results folder; empty: none, or of an earlier study.
    std::optional<FittedStudy> calibrated = {};
    /// Version number of the page, by which a browser finds out that `pendular serve` has a newer
    /// page. Empty for a page without a server.
    std::optional<std::size_t> served_version = {};

    std::vector<PageRecording> recordings = {};  ///< may be empty
};

}  // namespace pendular
