#pragma once

#include <functional>
#include <string>
#include <vector>

#include "data/recordings/file_view.h"
#include "data/study/study.h"
#include "reports/page/page_recordings.h"
#include "workflow/session.h"

namespace pendular::app {

/// Reads each recording of a study, in the order of study.toml, and passes the recording to `take`
/// or, if the recording cannot be read, a sentence to `note`.
/// @param note function that receives a sentence which states why a recording cannot be drawn
/// @param take function that receives each recording that can be read
void for_each_recording(const Study& study, const std::function<void(const std::string&)>& note,
                        const std::function<void(const FileView&)>& take);

/// Returns the recordings of a session's study for the HTML page of the study. Each recording
/// includes the ranges of rows that are averaged to readings.
/// @param note function that receives a sentence which states why a recording cannot be drawn
std::vector<PageRecording> recordings_of(const Session& session,
                                         const std::function<void(const std::string&)>& note);

}  // namespace pendular::app
