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

/// Recording thinned to a few hundred points, with the ranges of rows that are averaged.
struct PageRecording {
    /// Shear stress or normal stress [Pa] (torque [N m] or normal force [N] if the file has no
    /// stresses) against the number of the row, from 1.
    struct Course {
        std::string label;  ///< name and unit, for the axis
        std::vector<std::pair<std::size_t, double>> points;
        /// Over each of `windows`; empty: no recorded value.
        std::vector<std::optional<double>> means;
    };
    std::string file;             ///< equal to `origin.file` of the readings from it
    std::vector<Course> courses;  ///< shear stress, then normal stress; only those with values
    std::vector<AveragedWindow> windows;
};

/// Returns the part of a recording that the page shows.
/// @param readings readings of the study; those from other files are ignored
/// @param left_out rows that the study left out, with reasons
/// @param most maximum number of points for each stress
PageRecording page_recording(const FileView& view, const std::vector<Reading>& readings,
                             const std::vector<Remark>& left_out, std::size_t most);

/// Returns the maximum number of points for each stress of a recording: 400, or fewer (at least 20)
/// if many recordings would make the page large.
std::size_t points_of_recordings(std::size_t recordings);

/// Returns the JSON of recordings, each with the name of its file, `parts` and `windows`:
/// - A part is a stress against the number of the row: a label, the keys `low`, `range` and
///   `width`, and the points as base64. A point is two unsigned little-endian numbers: rows since
///   the previous point (`width` bytes), and a 16-bit k. Its value is low + range k/65535.
/// - A window is a range of averaged rows: first and last row (from 1), its kind as text, the index
///   of the reading that averages it (null: none), and the mean of each part.
/// @param readings all readings that the page shows
nlohmann::ordered_json recordings_json(const std::vector<PageRecording>& recordings,
                                       const std::vector<Reading>& readings);

}  // namespace pendular
