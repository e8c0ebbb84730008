#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "calib/fit/calibration.h"
#include "reports/figure.h"
#include "reports/figure_style.h"

namespace pendular {

// Curves of the fitted model in figures. The values that an instrument shows may depend on more
// quantities than the one along the figure's axis, such as normal stress, height of the sample and
// time. A curve then follows the conditions of the readings.

/// Quantity of a condition, such as the inertial number, along which a model curve runs in a
/// figure.
struct Coordinate {
    double (*of)(const Condition&);   ///< returns the quantity of a condition
    void (*set)(Condition&, double);  ///< sets the quantity of a condition
};
extern const Coordinate along_inertial_number;        ///< inertial number of a condition [1]
extern const Coordinate along_inverse_normal_stress;  ///< 1/(normal stress) of a condition [1/Pa]

/// Conditions at which a model curve is computed, along a coordinate through the conditions of
/// readings. All other quantities of a condition are interpolated linearly between nodes, and are
/// constant before the first node and after the last. A node is the mean of conditions whose
/// coordinates agree within 5 %.
class ConditionPath {
  public:
    /// @param conditions conditions of readings, at least one
    ConditionPath(std::vector<Condition> conditions, const Coordinate& along);
    /// Returns the interpolated condition at a value of the coordinate, in the coordinate's unit.
    Condition at(double coordinate) const;

  private:
    Coordinate along_;
    std::vector<Condition> nodes_;  ///< conditions to interpolate between, by rising coordinate
};

/// Quantity by which readings are divided into groups with a model curve each.
enum class Apart { normal_stress, bead_volume, file };

/// Group of readings that a figure draws as one series, with a model curve if `curve` is true.
struct CurveGroup {
    std::vector<std::size_t> members;  ///< indices of the readings in the calibration
    /// Text of the quantity that tells the group from the others, as "σ_{22} = 300 Pa", with
    /// gnuplot markup; empty for the only group.
    std::string name = {};
    /// Whether one model curve along the coordinate, at interpolated conditions of the members,
    /// passes within a quarter of the standard error of each reading from the reading's prediction.
    bool curve = false;

    /// Returns the conditions of a model curve, along a coordinate through the conditions of the
    /// group's members. `readings`: all readings of the calibration.
    ConditionPath path(const std::vector<Reading>& readings, const Coordinate& along) const;
};

/// Divides readings into groups such that one model curve represents the predictions of each group.
/// Tries no division, then division by one quantity of `apart`, then by several in their order,
/// with at most 8 groups. Points of failure form groups apart from steady shear, with "points of
/// failure" in their names. `CurveGroup::curve` tells for each group whether a curve represents it.
/// @param members indices in the calibration of the readings to divide
std::vector<CurveGroup> curve_groups(const std::vector<std::size_t>& members,
                                     const Predictor& model, const Calibration& calibration,
                                     const Coordinate& along, const std::vector<Apart>& apart);

/// Curve of predicted stress ratio and solid fraction along the x axis of a figure, with standard
/// errors.
struct ModelCurve {
    std::vector<double> x;
    std::vector<Shown> y;

    /// Makes the curve from the predicted shear stresses and solid fractions at `conditions`, with
    /// one x value in `at` for each condition.
    ModelCurve(std::vector<double> at, const Prediction& predicted,
               const std::vector<Condition>& conditions);
    /// Adds the curve of the stress ratio (o = 0) or the solid fraction (o = 1) to a panel, with a
    /// band of one standard error. `look` gives the colour, the line's label and whether the key
    /// shows it; the CSV file of the figure calls the band `band_label`.
    void draw_in(Panel& panel, std::size_t o, const Curve& look,
                 const std::string& band_label) const;
};

}  // namespace pendular
