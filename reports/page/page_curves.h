#pragma once

#include <string>
#include <vector>

#include "data/reading.h"
#include "data/study/study.h"

namespace pendular {

/// One series of readings in a panel of a study's HTML report, with the points of a model curve
/// along the conditions of these readings. The readings differ only in the quantity on the x axis.
struct PageSeries {
    /// Quantity by which the series differs from others, with its unit.
    std::string label;
    /// Indices of the readings in the study, in the order of rising x.
    std::vector<std::size_t> members;
    /// Values on the x axis of the points of the curve; empty: no curve.
    std::vector<double> x;
    /// Conditions of the points of the curve, in the order of `x`.
    std::vector<Condition> along;
};

/// Panel (pair of axes) of a study's HTML report. It shows measured and predicted stress ratios or
/// solid fractions.
struct PagePanel {
    std::string title, x_label;
    bool log_x = false;
    /// Value on the x axis of each reading of the study; NaN for a reading that belongs to none of
    /// `series`.
    std::vector<double> x;
    std::vector<PageSeries> series;
};

/// Divides the readings of a study into panels of its HTML report: dry readings against normal
/// stress or inertial number, whichever varies more, and wet readings against 1/P*, the inverse of
/// the reduced pressure. A panel has one series for each value of the other quantities. If readings
/// with equal x have different bead masses or heights, the series is divided further by bead mass
/// or by file, since one curve at their mean condition would not describe any of these readings.
std::vector<PagePanel> page_panels(const std::vector<Reading>& readings, const Study& study);

/// Returns the conditions of the points of all model curves, in the order of panels, of series in a
/// panel, and of points in a series.
std::vector<Condition> points_of_curves(const std::vector<PagePanel>& panels);

}  // namespace pendular
