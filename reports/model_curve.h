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

/// Quantity of a condition along which a curve runs.
struct Coordinate {
    double (*of)(const Condition&);   ///< returns the quantity of a condition
    void (*set)(Condition&, double);  ///< sets the quantity of a condition
};
extern const Coordinate along_inertial_number;        ///< [1]
extern const Coordinate along_inverse_normal_stress;  ///< [1/Pa]

/// Conditions along a coordinate through the conditions of readings. Every number is interpolated
/// linearly between nodes, and is constant before the first node and after the last. A node is the
/// mean of conditions whose coordinates agree within 5 %.
class ConditionPath {
  public:
    /// @param conditions conditions of readings, at least one
    ConditionPath(std::vector<Condition> conditions, const Coordinate& along);
    /// Condition at a value of the coordinate.
    Condition at(double coordinate) const;

  private:
    Coordinate along_;
    std::vector<Condition> nodes_;  ///< sorted by rising coordinate
};

/// Quantity by which readings are divided into groups with a model curve each.
enum class Apart { normal_stress, bead_volume, file };

/// Group of readings that are drawn as one series.
struct CurveGroup {
    std::vector<std::size_t> members;  ///< indices of the readings in the calibration
    /// Quantity that distinguishes the group, as "σ_{22} = 300 Pa"; empty for the only group.
    std::string name = {};
    /// Whether one model curve along the coordinate, at interpolated conditions of the members,
    /// passes within a quarter of the standard error of each reading from the reading's prediction.
    bool curve = false;

    /// Conditions along a coordinate through the conditions of the members.
    ConditionPath path(const std::vector<Reading>& readings, const Coordinate& along) const;
};

/// Divides readings into groups such that one model curve represents the predictions of each group.
/// Tries no division, then division by one quantity of `apart`, then by several in their order,
/// with at most 8 groups. `CurveGroup::curve` tells for each group whether a curve represents it.
/// @param members indices of the readings in the calibration
std::vector<CurveGroup> curve_groups(const std::vector<std::size_t>& members,
                                     const Predictor& model, const Calibration& calibration,
                                     const Coordinate& along, const std::vector<Apart>& apart);

/// Curve of the model along the x axis of a figure, with its standard errors.
struct ModelCurve {
    std::vector<double> x;
    std::vector<Shown> y;

    /// Curve from predictions at `conditions`, drawn at the x values `at`.
    ModelCurve(std::vector<double> at, const Prediction& predicted,
               const std::vector<Condition>& conditions);
    /// Adds the curve and its band of one standard error to a panel, in the style of `look`, for
    /// observable `o`: 0 for the stress ratio, 1 for the solid fraction.
    void draw_in(Panel& panel, std::size_t o, const Curve& look,
                 const std::string& band_label) const;
};

}  // namespace pendular
