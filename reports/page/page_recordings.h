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

/// A recording as a page shows it: its course, thinned, and the windows that are averaged.
struct PageRecording {
    /// Shear stress or normal stress against the number of the row, from 1.
    struct Course {
        std::string label;  ///< quantity with its unit
        std::vector<std::pair<std::size_t, double>> points;
        std::vector<std::optional<double>> means;  ///< one for each window
    };
    std::string file;                     ///< as in the origins of its readings
    std::vector<Course> courses;          ///< shear first; those without a known value left out
    std::vector<AveragedWindow> windows;  ///< rows that are averaged
};

/// A recording as a page shows it, from the file, the study's readings and the rows that the study
/// left out.
/// @param most largest number of points of a course (`points_of_recordings`)
PageRecording page_recording(const FileView& view, const std::vector<Reading>& readings,
                             const std::vector<Excluded>& excluded, std::size_t most);

/// Number of points of each course on a page with so many recordings: 400, and fewer where the page
/// would become large.
std::size_t points_of_recordings(std::size_t recordings);

/// JSON of recordings for a page: name; parts with label and base64 of points; windows with first
/// and last row, text on their kind, index of the reading that averages the rows (null: none), and
/// mean in each part. A point is the number of rows since the point before it (`width` bytes) and a
/// 16-bit number k, both unsigned and little-endian: the value is low + range k/65535.
/// @param readings all readings that the page shows
nlohmann::ordered_json recordings_json(const std::vector<PageRecording>& recordings,
                                       const std::vector<Reading>& readings);

}  // namespace pendular
