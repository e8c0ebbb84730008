#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "app/options.h"
#include "workflow/session.h"

namespace pendular::app {

/// Page on a study, and what a console says about it.
struct StudyPage {
    std::string html;
    std::string answer;   ///< verdict of the diagnosis in a sentence
    std::string verdict;  ///< verdict of the diagnosis by its name in JSON
    std::string next;     ///< command to give next
    std::string measure;  ///< next measurement to make, or why there is none, in a sentence
    std::vector<std::string> switches;  ///< names of the effects that the page switches on and off
    std::size_t models = 0;             ///< number of fitted combinations of these effects
    std::size_t readings = 0;           ///< number of readings
    std::vector<std::string> notes;     ///< why recordings are not drawn
};

/// Diagnoses the study of a session, plans the next measurement, fits all combinations of the
/// leading effects, and writes the page with these results. Nothing is simulated; no file is
/// written.
/// @param switches largest number of effects with a switch
/// @param version version of the page of `pendular serve`, with which open browsers know whether
///        they show the newest one; empty: a page that needs no server
/// @throws InputError where `Session::diagnose` and `read_ladder` do
/// @throws dem::Interrupted where the user stops the work
StudyPage study_page(const Session& session, const CommonOptions& common, std::size_t switches,
                     std::optional<std::size_t> version = {});

/// Name of a study for its page: the name of the folder of its file study.toml.
std::string study_name(const std::filesystem::path& file);

}  // namespace pendular::app
