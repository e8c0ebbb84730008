#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "data/reading.h"
#include "data/recordings/file_view.h"

namespace pendular {

/// Rows of a recording that are averaged, counted from 0, and whether their mean is used as a
/// reading.
struct AveragedWindow {
    enum class Kind { used, no_plateau, set_aside };
    std::size_t begin = 0, end = 0;  ///< first row, and the row after the last one
    Kind kind = Kind::used;
    int line = 0;  ///< first line of the reading that averages the rows; 0: no reading
};

/// Text on a kind of window, for a key: "averaged, no plateau" for example.
const char* text_of(AveragedWindow::Kind kind);

/// Windows of a recording: the steady parts that the readings of a study average, readings that
/// were set aside, and steps that reach no plateau. Without readings and excluded rows: the ends of
/// preshears and the smoothed peaks of intervals that were sheared to failure.
/// @param readings readings of a study; those of other files are ignored
/// @param excluded rows that a study left out
std::vector<AveragedWindow> windows_of(const FileView& view, const std::vector<Reading>& readings,
                                       const std::vector<Excluded>& excluded);

/// Shear stress or normal stress of all intervals of a recording (torque or normal force, if the
/// file has no stresses) against the number of the row.
class RecordingCourse {
  public:
    /// @param shear whether the course is that of the shear stress, as a magnitude
    RecordingCourse(const FileView& view, bool shear);

    /// Name of the quantity with its unit.
    std::string label() const;
    /// Number of rows.
    std::size_t size() const { return values_.size(); }

    /// Rows from 1 and values of the course, in the order of the rows. Of more than `most` known
    /// values, the least and the greatest value of each of most/2 equal ranges of rows, so that no
    /// peak is lost.
    std::vector<std::pair<std::size_t, double>> points(std::size_t most) const;

    /// Mean over a window; empty if no value in it is known.
    std::optional<double> mean(const AveragedWindow& window) const;

  private:
    std::vector<double> values_;  ///< not a number: unknown
    bool shear_, is_stress_ = false;
};

}  // namespace pendular
