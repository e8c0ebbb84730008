#include "app/recording_views.h"

#include <fmt/format.h>

#include "data/input_error.h"

namespace pendular::app {

void for_each_recording(const Study& study, const std::function<void(const std::string&)>& note,
                        const std::function<void(const FileView&)>& take) {
    for (const Source& source : study.sources) {
        if (source.kind != Source::Kind::recording) continue;
        for (const std::filesystem::path& path : source.files) {
            try {
                take(view_of_file(path, source.format, study.cell));
            } catch (const InputError& error) {
                note(fmt::format("There is no figure of this recording: {}", error.what()));
            }
        }
    }
}

std::vector<PageRecording> recordings_of(const Session& session,
                                         const std::function<void(const std::string&)>& note) {
    std::size_t count = 0;
    for (const Source& source : session.study().sources) {
        if (source.kind == Source::Kind::recording) count += source.files.size();
    }
    const std::size_t most = points_of_recordings(count);
    const Measurements& measurements = session.measurements();
    const std::vector<Remark> left_out = measurements.left_out();
    std::vector<PageRecording> recordings;
    for_each_recording(session.study(), note, [&](const FileView& view) {
        recordings.push_back(page_recording(view, measurements.readings, left_out, most));
    });
    return recordings;
}

}  // namespace pendular::app
