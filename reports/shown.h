#pragma once

#include <array>
#include <string>
#include <vector>

#include "data/reading.h"

namespace pendular {

// What the figures share: names of axes, colours, and how readings are shown.

inline const std::string stress_ratio_label = "stress ratio μ* = |σ_{12}|/σ_{22}";
inline const std::string solid_fraction_label = "solid fraction Φ_S";
inline const std::string measured_colour = "#1b1b1b", model_colour = "#0b62a4",
                         calibrated_colour = "#c0392b", run_colour = "#5b9bd5";

/// (stress ratio, solid fraction) with their standard errors.
struct Shown {
    std::array<double, 2> value, error;
};
Shown shown(const Reading& reading);

/// Weighted mean of readings, where one value stands for all of them.
Shown mean_of(const std::vector<Reading>& readings);

/// "capillary-", "shear-", "stress": broken behind hyphens where a line would become long.
std::vector<std::string> broken_name(const std::string& name);

/// Whether values span more than a decade and none of them is zero.
bool spans_decade(const std::vector<double>& values);

/// What a figure says of an inertial number.
std::string inertial_text(double inertial_number);

}  // namespace pendular
