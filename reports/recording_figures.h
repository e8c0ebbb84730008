#pragma once

#include <vector>

#include "data/reading.h"
#include "data/recordings/file_view.h"
#include "reports/figure.h"

namespace pendular {

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
