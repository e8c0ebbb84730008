#pragma once

#include <functional>
#include <string>
#include <vector>

#include "data/recordings/file_view.h"
#include "data/study/study.h"
#include "reports/page/page_recordings.h"
#include "workflow/session.h"

namespace pendular::app {

/// Calls `take` with each recording of a study that can be drawn, in the order of study.toml, and
/// `note` with the reason for each that cannot, such as its length.
void for_each_recording(const Study& study, const std::function<void(const std::string&)>& note,
                        const std::function<void(const FileView&)>& take);

/// All recordings of a session's study with the rows that its readings average. Calls `note` for
/// each that is not drawn.
std::vector<PageRecording> recordings_of(const Session& session,
                                         const std::function<void(const std::string&)>& note);

}  // namespace pendular::app
