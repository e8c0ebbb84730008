#pragma once

#include <string>
#include <vector>

#include "data/reading.h"
#include "data/study/study.h"

namespace pendular {

/// Readings of a page's panel that differ in one quantity along the x axis only, with points of a
/// curve through their conditions.
struct PageSeries {
    std::string label;                 ///< quantity that tells the series from others, with unit
    std::vector<std::size_t> members;  ///< indices of the readings, by rising x
    std::vector<double> x;             ///< x of the points of the curve; empty: no curve
    std::vector<Condition> along;      ///< conditions of these points
};

/// Panel of a page that shows measured and predicted stress ratios or solid fractions.
struct PagePanel {
    std::string title, x_label;
    bool log_x = false;
    std::vector<double> x;  ///< x of each reading of the study; NaN where it is in no series
    std::vector<PageSeries> series;
};

/// Divides the readings of a study into panels: dry readings against normal stress or inertial
/// number, whichever varies more, and wet readings against 1/P*, the inverse reduced pressure. A
/// panel has a series for each value of the other quantities. Readings at one place along the x
/// axis whose beads or heights differ are divided by the mass of the beads or by file, since
/// a curve through their mean would pass none of them.
std::vector<PagePanel> page_panels(const std::vector<Reading>& readings, const Study& study);

/// Conditions of the points of all curves of panels, in the order of panels and series.
std::vector<Condition> points_of_curves(const std::vector<PagePanel>& panels);

}  // namespace pendular
