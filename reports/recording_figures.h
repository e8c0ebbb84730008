#pragma once

#include <vector>

#include "data/reading.h"
#include "data/recordings/file_view.h"
#include "reports/figure.h"

namespace pendular {

/// Figures of a file of measurements by itself: the course of shear stress and normal stress with
/// the windows that are averaged (`recording_figure`), and a figure for each yield locus with a
/// line (`yield_locus_figures`).
std::vector<Figure> file_figures(const FileView& view);

/// Figure of a recording, one panel above the other: shear stress and normal stress (or torque and
/// force, if the file has no stresses) against the number of the row. Windows that are averaged are
/// drawn at their means, in one colour where a plateau was reached, in another where it was not and
/// in a third where the reading was set aside:
/// the steady parts that the readings of a study average, the ends of preshears, and the smoothed
/// peaks of intervals that were sheared to failure.
/// @param readings readings of a study; those of other files are ignored
/// @param excluded rows that a study left out
Figure recording_figure(const FileView& view, const std::vector<Reading>& readings = {},
                        const std::vector<Excluded>& excluded = {});

/// Figures of the yield loci of a file: points of failure, preshear point, fitted line, and the
/// Mohr circles of the preshear (major principal stress) and of the unconfined strength, with equal
/// scales of both axes.
std::vector<Figure> yield_locus_figures(const FileView& view);

}  // namespace pendular
