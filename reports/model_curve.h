#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "calib/fit/calibration.h"
#include "reports/figure.h"
#include "reports/figure_style.h"

namespace pendular {

// Curves of the fitted model in figures. The values that an instrument shows may depend on more
// quantities than the quantity along the x axis of the figure, such as normal stress, height of the
// sample and time. A curve then follows the conditions of the readings.

/// Quantity of a condition (normal stress, inertial number and liquid content) along which a figure
/// draws the curve of a model, such as the inertial number.
struct Coordinate {
    /// Function that returns the value of the quantity at a condition, in the unit of the quantity.
    double (*of)(const Condition&);
    /// Function that sets the quantity of a condition to a value, in the unit of the quantity.
    void (*set)(Condition&, double);
};
extern const Coordinate along_inertial_number;        ///< inertial number of a condition [1]
extern const Coordinate along_inverse_normal_stress;  ///< 1/(normal stress) of a condition [1/Pa]

/// Sequence of conditions (normal stress, inertial number, liquid content and others) along which a
/// model curve is computed. The path leads through the conditions of some readings in the order of
/// one quantity, the coordinate. Nodes of the path are means of conditions whose coordinates agree
/// within 5 %. All other quantities are interpolated linearly between nodes, and are constant
/// beyond the first and the last node.
class ConditionPath {
  public:
    /// Makes a path through the conditions of readings.
    /// @param conditions conditions of readings, at least one
    /// @param along quantity in whose order the path leads through the conditions
    ConditionPath(std::vector<Condition> conditions, const Coordinate& along);
    /// Returns the condition of the path at a value of the coordinate, in the unit of the
    /// coordinate.
    Condition at(double coordinate) const;
    /// Whether a quantity both rises and falls along the path, by more than 5 %.
    bool turns(double (*quantity)(const Condition&)) const;

  private:
    Coordinate along_;
    /// Conditions between which the path interpolates, in the order of rising coordinate.
    std::vector<Condition> nodes_;
};

/// Quantity by which a figure divides readings into groups, each with a model curve of its own:
/// normal stress, volume of beads, or file.
enum class Apart { normal_stress, bead_volume, file };

/// Group of readings that a figure draws as one series, with a model curve if `curve` is true.
struct CurveGroup {
    /// Indices of the group's readings in the list of all readings of the calibration.
    std::vector<std::size_t> members;
    /// Text of the quantities by which the group differs from the remaining groups, such as "σ_{22}
    /// = 300 Pa" with gnuplot markup. The text is empty for a group that needs no name, such as the
    /// only group of all readings.
    std::string name = {};
    /// Whether one model curve represents the group. If true, the curve differs from the prediction
    /// of each reading by at most a quarter of the standard error of the reading.
    bool curve = false;

    /// Returns the path through the conditions of the group's readings, along which a model curve
    /// is computed.
    /// @param readings all readings of the calibration
    ConditionPath path(const std::vector<Reading>& readings, const Coordinate& along) const;
};

/// Divides readings into groups such that one model curve represents each group, if possible. The
/// function tries one group, then division by one quantity of `apart`, then division by several
/// quantities in the order of `apart`. A curve represents a group better if the normal stress does
/// not go up and down along it, where the model depends on the normal stress. `CurveGroup::curve`
/// states whether a curve represents the group. No group has both readings of steady shear and
/// points of failure. There are at most 8 groups of either state.
/// @param members indices in the calibration of the readings to divide
/// @param along quantity along the x axis of the figure
std::vector<CurveGroup> curve_groups(const std::vector<std::size_t>& members,
                                     const Predictor& model, const Calibration& calibration,
                                     const Coordinate& along, const std::vector<Apart>& apart);

/// Curve of the stress ratio and the solid fraction that a model predicts along the x axis of a
/// figure, with standard errors.
struct ModelCurve {
    std::vector<double> x;
    std::vector<Shown> y;

    /// Makes the curve from shear stresses [Pa] and solid fractions [1] that the model predicts.
    /// @param at value on the x axis for each condition
    /// @param predicted predictions at `conditions`, in the order of `conditions`
    ModelCurve(std::vector<double> at, const Prediction& predicted,
               const std::vector<Condition>& conditions);
    /// Adds the curve to a panel, with a band of one standard error.
    /// @param o quantity that is drawn as y: 0 for the stress ratio, 1 for the solid fraction
    /// @param look colour and label of the line; also states whether the key (legend) shows the
    ///        line
    /// @param band_label name of the band in the CSV file of the figure
    void draw_in(Panel& panel, std::size_t o, const Curve& look,
                 const std::string& band_label) const;
};

}  // namespace pendular
