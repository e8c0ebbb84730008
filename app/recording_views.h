#pragma once

#include <functional>
#include <string>
#include <vector>

#include "data/recordings/file_view.h"
#include "data/study/study.h"
#include "reports/page/page_recordings.h"
#include "workflow/session.h"

namespace pendular::app {

/// Reads each recording of a study, in the order of study.toml, and passes it to `take` or, if it
/// cannot be read, a sentence that says why to `note`.
void for_each_recording(const Study& study, const std::function<void(const std::string&)>& note,
                        const std::function<void(const FileView&)>& take);

/// Returns the recordings of a study for its HTML page, with the ranges of rows that are averaged
/// to readings. Recordings that cannot be drawn give a sentence to `note`.
std::vector<PageRecording> recordings_of(const Session& session,
                                         const std::function<void(const std::string&)>& note);

}  // namespace pendular::app
