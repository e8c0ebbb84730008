#pragma once

#include <string>
#include <vector>

#include "data/reading.h"
#include "data/study/study.h"

namespace pendular {

/// Readings in a panel, with the points of a model curve along their conditions. The readings
/// differ mainly in the quantity on the x axis.
struct PageSeries {
    /// Values, with units, by which the series differs from the others, such as "normal stress 300
    /// Pa".
    std::string label;
    /// The part of `label` that is no number on a scale, such as "liquid content 0.03", and the
    /// value of `PagePanel::quantity`: for keys of panels with many series.
    std::string group;
    double value = 0;
    std::vector<std::size_t> members;  ///< indices of its readings, in the order of rising x
    std::vector<double> x;             ///< of the points of the curve; empty: no curve
    std::vector<Condition> along;      ///< conditions of the points of the curve
};

/// Two plots with a common x axis: measured and predicted stress ratios, and solid fractions.
struct PagePanel {
    std::string title, x_label;
    bool log_x = false;
    std::string quantity;   ///< name and unit of what tells the series of a group apart
    std::vector<double> x;  ///< of each reading of the study; NaN: in none of `series`
    std::vector<PageSeries> series;
};

/// Divides the readings into a dry and a wet panel. The x axis of the dry panel is the normal
/// stress or the inertial number, whichever varies by the larger factor; that of the wet panel is
/// 1/P* or the inertial number. Each series has one value of each quantity that is not on the x
/// axis, and either steady shear or points of failure. A series with several bead masses or heights
/// at equal x is divided further by bead mass or by file.
std::vector<PagePanel> page_panels(const std::vector<Reading>& readings, const Study& study);

/// Returns the conditions at the points of all curves, by panel, then series, then point.
std::vector<Condition> points_of_curves(const std::vector<PagePanel>& panels);

}  // namespace pendular
