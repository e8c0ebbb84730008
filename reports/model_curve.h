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

/// Quantity of a condition, such as the inertial number, along which a figure draws the curve of a
/// model.
struct Coordinate {
    /// Function that returns the value of the quantity at a condition.
    double (*of)(const Condition&);
    /// Function that sets the value of the quantity of a condition.
    void (*set)(Condition&, double);
};
extern const Coordinate along_inertial_number;        ///< inertial number of a condition [1]
extern const Coordinate along_inverse_normal_stress;  ///< 1/(normal stress) of a condition [1/Pa]

/// Conditions along which a model curve is computed: they lead through the conditions of some
/// readings in the order of one quantity, the coordinate. Nodes are means of conditions whose
/// coordinates agree within 5 %. All other quantities of a condition are interpolated linearly
/// between nodes, and are constant before the first node and after the last.
class ConditionPath {
  public:
    /// Makes a path through the conditions of readings.
    /// @param conditions conditions of readings, at least one
    /// @param along quantity in whose order the path leads through the conditions
    ConditionPath(std::vector<Condition> conditions, const Coordinate& along);
    /// Returns the condition at a value of the coordinate, in the coordinate's unit.
    Condition at(double coordinate) const;

  private:
    Coordinate along_;
    /// Conditions between which the path interpolates, in the order of rising coordinate.
    std::vector<Condition> nodes_;
};

/// Quantity by which readings are divided into groups, each of which has a model curve of its own.
enum class Apart { normal_stress, bead_volume, file };

/// Group of readings that a figure draws as one series, with a model curve if `curve` is true.
struct CurveGroup {
    /// Indices of the group's readings in the list of all readings of the calibration.
    std::vector<std::size_t> members;
    /// Text of the quantity by which the group differs from the others, such as "σ_{22} = 300 Pa"
    /// with gnuplot markup; empty if there is one group only.
    std::string name = {};
    /// Whether one model curve represents the group: the curve at interpolated conditions differs
    /// from the prediction of each reading by at most a quarter of the standard error of the
    /// reading.
    bool curve = false;

    /// Returns the path through the conditions of the group's readings, along which a model curve
    /// is computed.
    /// @param readings all readings of the calibration
    ConditionPath path(const std::vector<Reading>& readings, const Coordinate& along) const;
};

/// Divides readings into at most 8 groups such that one model curve represents the predictions of
/// each group. Tries one group, then division by one quantity of `apart`, then by several
/// quantities in the order of `apart`. `CurveGroup::curve` states for each group whether a curve
/// represents it. Points of failure and readings of steady shear are divided separately; if the
/// readings contain both kinds, the names of groups of points of failure say so.
/// @param members indices of the readings to divide in the calibration
/// @param along quantity along the x axis of the figure
std::vector<CurveGroup> curve_groups(const std::vector<std::size_t>& members,
                                     const Predictor& model, const Calibration& calibration,
                                     const Coordinate& along, const std::vector<Apart>& apart);

/// Curve of stress ratio and solid fraction that a model predicts along the x axis of a figure,
/// with standard errors.
struct ModelCurve {
    std::vector<double> x;
    std::vector<Shown> y;

    /// Makes the curve from predicted shear stresses [Pa] and solid fractions [1].
    /// @param at value on the x axis for each condition
    /// @param predicted predictions at `conditions`, in their order
    ModelCurve(std::vector<double> at, const Prediction& predicted,
               const std::vector<Condition>& conditions);
    /// Adds the curve to a panel, with a band of one standard error.
    /// @param o quantity that is drawn: 0 for the stress ratio, 1 for the solid fraction
    /// @param look colour and label of the line, and whether the key shows it
    /// @param band_label name of the band in the CSV file of the figure
    void draw_in(Panel& panel, std::size_t o, const Curve& look,
                 const std::string& band_label) const;
};

}  // namespace pendular
