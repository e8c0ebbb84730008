#pragma once

#include <functional>
#include <string>
#include <vector>

#include "data/recordings/file_view.h"
#include "data/study/study.h"
#include "reports/page/page_recordings.h"
#include "workflow/session.h"

namespace pendular::app {

/// Calls `take` with every recording of a study, in the order of study.toml, or `note` with the
/// reason why a recording is not drawn, such as its length.
void for_each_recording(const Study& study, const std::function<void(const std::string&)>& note,
                        const std::function<void(const FileView&)>& take);

/// All recordings of a session's study with the rows that its readings average. Calls `note` for
/// each that is not drawn.
std::vector<PageRecording> recordings_of(const Session& session,
                                         const std::function<void(const std::string&)>& note);

}  // namespace pendular::app
