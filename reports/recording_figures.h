#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "data/reading.h"
#include "data/recordings/file_view.h"
#include "reports/figure.h"

namespace pendular {

/// Averaged rows of a recording; `kind` states whether their mean is used as a reading.
struct AveragedWindow {
    enum class Kind { used, no_plateau, set_aside };
    std::size_t begin = 0, end = 0;  ///< first row, from 0, and the row after the last
    Kind kind = Kind::used;
    int line = 0;  ///< line of the file at which it begins; 0: no reading averages it
};

/// Returns words for the key of a figure, such as "averaged, no plateau".
const char* text_of(AveragedWindow::Kind kind);

/// Returns the averaged ranges of rows. In a study, they are the steady parts that are readings,
/// readings that were set aside, and steps without a plateau. If both lists are empty, they are the
/// ends of preshears and the smoothed peaks of intervals sheared to failure.
/// @param readings readings of a study; those from files other than `view` are ignored
/// @param left_out rows that the study left out, with reasons
std::vector<AveragedWindow> windows_of(const FileView& view, const std::vector<Reading>& readings,
                                       const std::vector<Remark>& left_out);

/// Shear stress or normal stress [Pa] (torque [N m] or normal force [N] if the file has no
/// stresses) against the number of the row, over all intervals.
class RecordingCourse {
  public:
    /// Reads the magnitude of the shear stress (or torque) if `shear` is true, otherwise the normal
    /// stress (or force).
    RecordingCourse(const FileView& view, bool shear);

    /// Returns name and unit, such as "shear stress [Pa]".
    std::string label() const;
    std::size_t size() const { return values_.size(); }

    /// Returns pairs of row number, from 1, and value, without rows that have no value. Of more
    /// than `most` values, it keeps the least and the greatest in each of most/2 parts, so that no
    /// peak is lost.
    std::vector<std::pair<std::size_t, double>> points(std::size_t most) const;

    /// Returns the mean of the known values in a window; nothing if none is known.
    std::optional<double> mean(const AveragedWindow& window) const;

  private:
    std::vector<double> values_;  ///< of each row; NaN: unknown
    bool shear_, is_stress_ = false;
};

/// Returns a name that no figure has: with a number at its end if one has it.
std::string unused_name(const std::string& name, const std::vector<Figure>& figures);

/// Returns the figures of a file that belongs to no study: `recording_figure`, unless the file
/// contains only results (at most one row per interval), and `yield_locus_figures`.
std::vector<Figure> file_figures(const FileView& view);

/// Returns shear stress and normal stress [Pa] (torque [N m] and normal force [N] if the file has
/// no stresses) against the row number, one panel above the other. Each averaged range of rows
/// (`windows_of`) is drawn at its mean, in a colour that tells its kind.
/// @param readings readings of a study; those from files other than `view` are ignored
/// @param left_out rows that the study left out, with reasons
Figure recording_figure(const FileView& view, const std::vector<Reading>& readings = {},
                        const std::vector<Remark>& left_out = {});

/// Returns a figure for each yield locus with a fitted line: points of failure, preshear point,
/// line, and the Mohr circles of the preshear (major principal stress) and of the unconfined
/// strength. Both axes have the same scale.
std::vector<Figure> yield_locus_figures(const FileView& view);

}  // namespace pendular
