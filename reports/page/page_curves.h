#pragma once

#include <string>
#include <vector>

#include "data/reading.h"
#include "data/study/study.h"

namespace pendular {

/// Series of readings (measured shear stress and solid fraction) in a panel of a study's HTML
/// report, with the points of a model curve along the conditions of these readings. The readings
/// differ mainly in the quantity on the x axis.
struct PageSeries {
    /// Label of the series: the values, with units, by which the series differs from the other
    /// series of the panel, such as "normal stress 300 Pa".
    std::string label;
    /// Indices of the series' readings among all readings of the study, in the order of rising x.
    std::vector<std::size_t> members;
    /// Values on the x axis at the points of the curve, in the unit of the axis. The list is empty
    /// if the series has no curve.
    std::vector<double> x;
    /// Conditions (normal stress, inertial number and liquid content) of the points of the curve,
    /// in the order of `x`.
    std::vector<Condition> along;
};

/// Pair of plots with a common x axis in a study's HTML report. The first plot shows measured and
/// predicted stress ratios, the second shows measured and predicted solid fractions.
struct PagePanel {
    std::string title, x_label;
    bool log_x = false;
    /// Values on the x axis, one for each reading of the study. The value is NaN for a reading that
    /// belongs to none of `series`.
    std::vector<double> x;
    std::vector<PageSeries> series;
};

/// Divides the readings of a study into a dry and a wet panel of the study's HTML report. The x
/// axis of the dry panel is the normal stress or the inertial number, whichever varies by the
/// larger factor. The x axis of the wet panel is 1/P*, with the reduced pressure P*. Each series of
/// a panel has one value of each quantity that is not on the x axis, and either steady shear or
/// points of failure. A series with several bead masses or heights at equal x is divided further by
/// bead mass or by file.
std::vector<PagePanel> page_panels(const std::vector<Reading>& readings, const Study& study);

/// Returns the conditions (normal stress, inertial number and liquid content) at the points of all
/// model curves of a study's HTML report, ordered by panel, then by series, then by point.
std::vector<Condition> points_of_curves(const std::vector<PagePanel>& panels);

}  // namespace pendular
