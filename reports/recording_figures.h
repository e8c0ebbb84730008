#pragma once

#include <vector>

#include "data/reading.h"
#include "data/recordings/file_view.h"
#include "reports/figure.h"

namespace pendular {

/// Returns the figures of a file of measurements that belongs to no study: shear stress and normal
/// stress against the number of the row (`recording_figure`), and the yield loci
/// (`yield_locus_figures`). `recording_figure` is left out for a file that contains only results,
/// with at most one row per interval (step of constant set points).
std::vector<Figure> file_figures(const FileView& view);

/// Returns a figure of a recording with two panels, one above the other: shear stress and normal
/// stress [Pa] (torque [N m] and normal force [N] if the file has no stresses) against the row
/// number. Each averaged range of rows (`windows_of`) is drawn at its mean. The colour of a range
/// says whether the range is at a plateau, reached no plateau, or belongs to an excluded reading.
/// @param readings readings (measured shear stress and solid fraction) of a study; readings from
///        files other than `view` are ignored
/// @param excluded rows that the study excludes, with reasons
Figure recording_figure(const FileView& view, const std::vector<Reading>& readings = {},
                        const std::vector<Excluded>& excluded = {});

/// Returns one figure for each yield locus of a file through whose points of failure a straight
/// line was fitted. The figure shows the points of failure, the preshear point, the fitted line,
/// the Mohr circle of the preshear (for the major principal stress) and the Mohr circle of the
/// unconfined strength. Both axes have the same scale.
std::vector<Figure> yield_locus_figures(const FileView& view);

}  // namespace pendular
