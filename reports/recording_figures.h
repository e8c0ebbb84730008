#pragma once

#include <vector>

#include "data/reading.h"
#include "data/recordings/file_view.h"
#include "reports/figure.h"

namespace pendular {

/// Returns the figures of a file of measurements, without a study: shear stress and normal stress
/// against the row (`recording_figure`) and the yield loci (`yield_locus_figures`).
/// `recording_figure` is left out for a file that contains only results, at most one row per
/// interval.
std::vector<Figure> file_figures(const FileView& view);

/// Figure of a recording with two panels, one above the other: shear stress and normal stress [Pa]
/// (torque [N m] and normal force [N] if the file has no stresses) against the number of the row.
/// Ranges of rows that are averaged are drawn at their means, in different colours for ranges at a
/// plateau, ranges that reached no plateau, and readings that were set aside. These ranges are the
/// steady parts that the readings of a study average or, without a study, the ends of preshears and
/// the smoothed peaks of intervals that were sheared to failure.
/// @param readings readings of a study; readings of other files are ignored
/// @param excluded rows that a study left out
Figure recording_figure(const FileView& view, const std::vector<Reading>& readings = {},
                        const std::vector<Excluded>& excluded = {});

/// Returns one figure for each yield locus of a file that has a fitted line: points of failure,
/// preshear point, fitted line, and the Mohr circles of the preshear (major principal stress) and
/// of the unconfined strength. Both axes have the same scale.
std::vector<Figure> yield_locus_figures(const FileView& view);

}  // namespace pendular
