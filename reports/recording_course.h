#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "data/reading.h"
#include "data/recordings/file_view.h"

namespace pendular {

/// Range of rows of a recording that are averaged. `kind` states whether the mean of the rows is
/// used as a reading (shear stress and solid fraction of one steady part).
struct AveragedWindow {
    enum class Kind { used, no_plateau, set_aside };
    /// First row of the range in the recording, counted from 0 (`begin`), and the row after the
    /// last row of the range (`end`).
    std::size_t begin = 0, end = 0;
    Kind kind = Kind::used;
    /// Line of the recording's file at which the range begins. The line identifies the reading that
    /// averages the range; 0: no reading averages the range.
    int line = 0;
};

/// Returns a text for the key (legend) of a figure that says how a range of averaged rows is used,
/// such as "averaged, no plateau".
const char* text_of(AveragedWindow::Kind kind);

/// Returns the ranges of rows of a recording that are averaged. For a recording in a study, the
/// ranges are the steady parts whose means are readings, readings that were set aside, and steps
/// that reach no plateau. If both `readings` and `excluded` are empty, the ranges are the ends of
/// preshears and the smoothed peaks of intervals that were sheared to failure.
/// @param readings readings of a study; readings from files other than `view` are ignored
/// @param excluded rows that the study left out, with reasons
std::vector<AveragedWindow> windows_of(const FileView& view, const std::vector<Reading>& readings,
                                       const std::vector<Excluded>& excluded);

/// Shear stress or normal stress [Pa] of a recording against the number of the row, over all
/// intervals (steps of constant set points). If the file has no stresses, torque [N m] or normal
/// force [N] takes the place of the stress.
class RecordingCourse {
  public:
    /// Reads the shear stress or the normal stress from a file of measurements.
    /// @param shear true: magnitude of the shear stress (or torque); false: normal stress (or
    ///        normal force)
    RecordingCourse(const FileView& view, bool shear);

    /// Returns the name of the quantity with its unit, such as "shear stress [Pa]".
    std::string label() const;
    /// Returns the number of rows of the recording.
    std::size_t size() const { return values_.size(); }

    /// Returns the points of a plot of the quantity in the order of the rows: pairs of row number,
    /// counted from 1, and value. Rows without a value are left out. If there are more than `most`
    /// values, the function divides the values into most/2 equal parts and returns the least and
    /// the greatest value of each part, so that no peak is lost.
    std::vector<std::pair<std::size_t, double>> points(std::size_t most) const;

    /// Returns the mean of the known values in a range of rows, in the unit of the quantity.
    /// Returns nothing if no value in the range is known.
    std::optional<double> mean(const AveragedWindow& window) const;

  private:
    /// Value of the quantity in each row of the recording, in the unit of the quantity. The value
    /// is NaN if it is unknown.
    std::vector<double> values_;
    bool shear_, is_stress_ = false;
};

}  // namespace pendular
