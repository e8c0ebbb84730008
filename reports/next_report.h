#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "analysis/next_measurement.h"
#include "reports/figure.h"

namespace pendular {

/// What to measure next, and why, of one study.
struct NextMeasurement {
    const Study& study;
    std::vector<Rival> rivals;  ///< models that stand; one: nothing to tell apart
    std::vector<Point> points;
    std::vector<Plan> plans;                  ///< of rivals, the most telling first
    std::vector<Sharpening> sharpenings;      ///< where there is one model
    Series series = {};                       ///< to measure; empty: nothing tells them apart
    int most_repeats = 1, most_readings = 1;  ///< at one point, in all
};

/// The measurement in one line, then what each rival says of it, or the parameters' errors after
/// it.
std::vector<std::string> next_lines(const NextMeasurement& next);

/// What `next` prints and `out/next.json` holds.
nlohmann::ordered_json to_json(const NextMeasurement& next);

/// What the rivals say along the normal stress, through the point to measure.
Figure next_figure(const NextMeasurement& next);

}  // namespace pendular
