#pragma once

#include <cstddef>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "app/options.h"
#include "workflow/session.h"

namespace pendular::app {

/// Page of a study as HTML, and the results that the console prints when the page is made.
struct StudyPage {
    std::string html;
    /// Verdict of the diagnosis in one to three sentences: which physical effect the model lacks,
    /// or that none is missing.
    std::string answer;
    /// Name of the verdict of the diagnosis as in JSON, such as "missing".
    std::string verdict;
    /// Command that the user should give next, after reading the page.
    std::string next;
    /// Text of the first step to take after the diagnosis, such as a measurement, a check of a
    /// sensor or a change of the model.
    std::string measure;
    /// Names of physical effects that a reader of the page can switch on and off.
    std::vector<std::string> switches;
    /// Number of combinations of the effects in `switches` for which a fitted model exists.
    std::size_t models = 0;
    /// Number of readings (pairs of measured shear stress and solid fraction) that the diagnosis
    /// tested.
    std::size_t readings = 0;
    nlohmann::ordered_json runs = {};  ///< simulations behind the page (`runs_json`)
    /// Sentences on recordings that the page cannot draw, with the reasons.
    std::vector<std::string> notes;
};

/// Makes the page of a study. Diagnoses which physical effect the model lacks, plans the next
/// measurement, and fits the model with each combination of the leading effects (effects that the
/// study lists or that the diagnosis finds most important). Nothing is simulated, and no file is
/// written.
/// @param switches largest number of leading effects that a reader of the page can switch on and
///        off
/// @param version version number of the page, by which a browser finds out that `pendular serve`
///        has a newer page; empty: a page that needs no server
/// @throws InputError if the study cannot be diagnosed, such as with too few readings, or if
///         ladder.json cannot be read
/// @throws dem::Interrupted if the user requests a stop
StudyPage study_page(const Session& session, const CommonOptions& common, std::size_t switches,
                     std::optional<std::size_t> version = {});

/// Returns the name of a study on its page: the name of the folder that contains study.toml.
/// @param file path of study.toml, or of the folder of the study
std::string study_name(const std::filesystem::path& file);

}  // namespace pendular::app
