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

/// Results on a study that its HTML page (the report) shows.
struct PageContent {
    std::string study;  ///< name of the study
    /// The study as the user named it, for the commands that the page shows.
    std::string study_argument;
    const ResolvedStudy& resolved;  ///< the study with its catalogue of effects
    /// Readings, with reasons to doubt some of them and notes.
    const Measurements& measurements;
    const StudyDiagnosis& diagnosis;  ///< verdict, tests and refitted models
    Checks checks;                    ///< tests of the residuals of the study's model
    /// Shifts of the fitted friction by effects and errors of measurement; empty: not computed.
    std::optional<ImpactTable> impacts = {};
    /// Ladder: sequence of the study's models, with one effect more or fewer in each step; may be
    /// empty.
    Ladder ladder = {};
    /// Lines of text on the next measurement to make; empty: not computed.
    std::vector<std::string> next = {};
    /// Fitted models, one for each combination of the leading effects; the reader of the page
    /// switches these effects on and off.
    SwitchedModels switched;
    /// Panels of readings, with the curves of the models in `switched`.
    std::vector<PagePanel> panels;
    /// Version of the program that made the page.
    std::string version;
    /// Options with which the results were computed; the page states the fidelity (settings of the
    /// simulations) and the seed.
    SessionOptions options;
    std::size_t runs = 0;     ///< number of simulation runs that the emulator was trained on
    bool calibrated = false;  ///< whether the results folder has a fit of the study
    /// Version number of the page, by which a browser finds out that `pendular serve` has a newer
    /// page; empty: a page without a server.
    std::optional<std::size_t> served_version = {};

    /// Stresses of the study's recordings against the row, with the rows that are averaged; may be
    /// empty.
    std::vector<PageRecording> recordings = {};
};

/// Returns the page of a study as one HTML file that needs no other files: verdict, figures with
/// switches for the leading effects and sliders for the parameters, fit, effects, impacts, ladder,
/// next measurement and provenance.
std::string report_page(const PageContent& content);

/// Returns the HTML page that a server shows until the first results on a study exist.
/// @param study name of the study
/// @param version version of the program
std::string waiting_page(const std::string& study, const std::string& version);

/// Returns the Content-Security-Policy of a page, which permits the browser to load nothing from
/// other sources.
/// @param served whether the page's script may send requests to the server that the page came from
std::string page_policy(bool served);

}  // namespace pendular
