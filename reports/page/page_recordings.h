#pragma once

#include <array>
#include <cstddef>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "reports/recording_course.h"

namespace pendular {

/// Recording as the page of a study shows it: stresses against the row, thinned to a few hundred
/// points, and the ranges of rows that are averaged.
struct PageRecording {
    /// Shear stress [Pa] or normal stress [Pa] (torque [N m] or normal force [N] if the file has no
    /// stresses) against the number of the row, from 1.
    struct Course {
        /// Quantity whose course is shown, with its unit.
        std::string label;
        std::vector<std::pair<std::size_t, double>> points;
        /// Mean of the course over each of `windows`, in the unit of the course; empty where no
        /// value in the window is known.
        std::vector<std::optional<double>> means;
    };
    /// Path of the recording's file, as in the origins of its readings.
    std::string file;
    /// Course of the shear stress, then of the normal stress; a course without a known value is
    /// left out.
    std::vector<Course> courses;
    /// Ranges of rows of the recording that are averaged.
    std::vector<AveragedWindow> windows;
};

/// Returns a recording as the page of a study shows it.
/// @param readings readings of the study; readings of other files are ignored
/// @param excluded rows that the study left out
/// @param most largest number of points of a course
PageRecording page_recording(const FileView& view, const std::vector<Reading>& readings,
                             const std::vector<Excluded>& excluded, std::size_t most);

/// Largest number of points of each course on a page with this number of recordings: 400, and down
/// to 20 where the page would become large.
std::size_t points_of_recordings(std::size_t recordings);

/// JSON of recordings for the page of a study. Each recording has its name, `parts` (courses) and
/// `windows` (ranges of rows that are averaged). A part has a label and the base64 of its points:
/// for each point, the number of rows since the point before it (`width` bytes) and a 16-bit number
/// k, both unsigned and little-endian; the value is low + range k/65535. A window has its first and
/// last row, a text on its kind, the index of the reading that averages the rows (null: none), and
/// the mean in each part.
/// @param readings all readings that the page shows
nlohmann::ordered_json recordings_json(const std::vector<PageRecording>& recordings,
                                       const std::vector<Reading>& readings);

}  // namespace pendular
