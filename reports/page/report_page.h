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
#include "reports/page/page_recordings.h"
#include "workflow/study_diagnosis.h"
#include "workflow/switched_models.h"

namespace pendular {

/// Content of the HTML page of a study (the report): results, texts and settings.
struct PageContent {
    std::string study;  ///< name of the study
    /// Argument that names the study in the commands on the page: the path of the study as the user
    /// typed it, quoted if a shell needs quotes.
    std::string study_argument;
    /// Study with its catalogue of effects (list of known physical effects).
    const ResolvedStudy& resolved;
    /// Readings (measured shear stress and solid fraction) of the study, with notes and with
    /// reasons to doubt some of the readings.
    const Measurements& measurements;
    /// Verdict on the physical effects that the model lacks, with tests and refitted models.
    const StudyDiagnosis& diagnosis;
    Checks checks;  ///< tests of the residuals of the study's model
    /// Shifts of the fitted friction coefficient [1] that effects and errors of measurement cause.
    /// Empty if the shifts were not computed.
    std::optional<ImpactTable> impacts = {};
    /// Ladder: sequence of the study's models, with one effect more or fewer in each step. May be
    /// empty.
    Ladder ladder = {};
    /// Numbered lines below a heading that say what to do next (`step_lines`).
    std::vector<std::string> steps = {};
    std::string command = {};  ///< `pendular` command to give next (`next_command`)
    /// Fitted models, one for each combination of the leading effects (effects that the study lists
    /// or that the diagnosis finds most important). The reader of the page can switch these effects
    /// on and off.
    SwitchedModels switched;
    /// Panels that show readings, with the curves of the models in `switched`.
    std::vector<PagePanel> panels;
    /// Version of the program that made the page.
    std::string version;
    /// Options with which the results were computed. The page states the name of the fidelity (set
    /// of simulation settings) and the seed.
    SessionOptions options;
    /// Number of simulations on which the emulator (interpolation between simulations) was trained.
    std::size_t runs = 0;
    /// Hash of these simulations, as in the JSON of the results (`runs_json`).
    std::string runs_hash = {};
    bool calibrated = false;  ///< whether the results folder has a fit of the study
    /// Version number of the page, by which a browser finds out that `pendular serve` has a newer
    /// page. Empty for a page without a server.
    std::optional<std::size_t> served_version = {};

    /// Stresses of the study's recordings against the number of the row, with the ranges of rows
    /// that are averaged. The list may be empty.
    std::vector<PageRecording> recordings = {};
};

/// Returns the page of a study as one HTML file that needs no further files. The page shows the
/// verdict, figures, the fit, the effects, the shifts of the friction coefficient by the effects,
/// the ladder (sequence of the study's models), the next steps and the provenance. In the figures,
/// the reader can switch the leading effects on and off, and change parameters with sliders.
std::string report_page(const PageContent& content);

/// Returns the HTML page that a server shows until the first results on a study exist.
/// @param study name of the study
/// @param version version of the program
std::string waiting_page(const std::string& study, const std::string& version);

/// Returns the Content-Security-Policy of a page, which forbids the browser to load anything that
/// is not part of the page.
/// @param served whether the page's script may send requests to the server of the page
std::string page_policy(bool served);

}  // namespace pendular
