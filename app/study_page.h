#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "app/options.h"
#include "data/recordings/file_view.h"
#include "data/study/study.h"
#include "reports/page/page_data.h"
#include "reports/page/page_paste.h"
#include "workflow/session.h"

namespace pendular::app {

/// Page of a study as HTML, and the results that the console prints when the page is made.
struct StudyPage {
    std::string html;
    /// Page that needs no server, for the results folder; empty where `html` needs none.
    std::string alone = {};
    std::string answer;   ///< verdict in one to three sentences
    PasteTexts paste;     ///< results as one copies them into a paper
    std::string verdict;  ///< as in JSON, such as "missing"
    std::string next;     ///< command to give next
    /// First step after the diagnosis, such as a measurement or a check of a sensor; may be empty.
    std::string measure;
    std::vector<std::string> switches;  ///< effects that a reader of the page can switch on and off
    std::size_t models = 0;             ///< combinations of `switches` that could be fitted
    std::size_t readings = 0;           ///< readings that the diagnosis tested
    nlohmann::ordered_json runs = {};   ///< simulations behind the page (`runs_json`)
    std::vector<std::string> notes;     ///< why recordings cannot be drawn
};

/// Makes the page of a study: diagnoses it, plans the next measurement, and fits the model with
/// each combination of its leading effects (`switched_models`). Nothing is simulated, and no file
/// is written.
/// @param switches largest number of these effects; empty: 6, or 5 for more than 60 readings, whose
///        pages would be larger than 1 MB
/// @param version version number of the page, by which a browser finds out that `pendular serve`
///        has a newer page; empty: a page that needs no server
/// @throws InputError if the study cannot be diagnosed, such as with too few readings, or if
///         ladder.json cannot be read
/// @throws dem::Interrupted if the user requests a stop
StudyPage study_page(const Session& session, const CommonOptions& common,
                     std::optional<std::size_t> switches, std::optional<std::size_t> version = {});

/// Returns the name of a study on its page: that of the folder that contains `file`, its
/// study.toml.
std::string study_name(const std::filesystem::path& file);

/// Reads each recording of a study, in the order of study.toml, and passes it to `take` or, if it
/// cannot be read, a sentence that says why to `note`.
void for_each_recording(const Study& study, const std::function<void(const std::string&)>& note,
                        const std::function<void(const FileView&)>& take);

/// Returns the recordings of a study for its HTML page, with the ranges of rows that are averaged
/// to readings. Recordings that cannot be drawn give a sentence to `note`.
std::vector<PageRecording> recordings_of(const Session& session,
                                         const std::function<void(const std::string&)>& note);

}  // namespace pendular::app
