#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "calib/fit/calibration.h"
#include "reports/figure.h"
#include "reports/figure_style.h"

namespace pendular {

// Curves of the fitted model in figures. What an instrument shows may depend on more than the
// quantity along the x axis, such as normal stress, height of the sample and time. A curve then
// follows the conditions of the readings.

/// Quantity of a condition along which a curve is drawn, in its unit.
struct Coordinate {
    double (*of)(const Condition&);
    void (*set)(Condition&, double);
};
extern const Coordinate along_inertial_number;        ///< inertial number of a condition [1]
extern const Coordinate along_inverse_normal_stress;  ///< 1/(normal stress) of a condition [1/Pa]

/// Path through the conditions of readings in the order of a coordinate. Its nodes are means of
/// conditions whose coordinates agree within 5 %. All other quantities are interpolated linearly
/// between nodes and constant beyond the first and the last.
class ConditionPath {
  public:
    /// Makes the path through conditions, at least one.
    ConditionPath(std::vector<Condition> conditions, const Coordinate& along);
    /// Returns the condition at a value of the coordinate, in its unit.
    Condition at(double coordinate) const;
    /// Whether a quantity both rises and falls along the path, by more than 5 %.
    bool turns(double (*quantity)(const Condition&)) const;

  private:
    Coordinate along_;
    std::vector<Condition> nodes_;  ///< in the order of rising coordinate
};

/// Quantity that divides readings into groups, each with its own curve.
enum class Apart { normal_stress, bead_volume, file };

/// Readings drawn as one series.
struct CurveGroup {
    std::vector<std::size_t> members;  ///< indices in the readings of the calibration
    /// Quantities by which the group differs from the others, such as "σ_{22} = 300 Pa", with
    /// gnuplot markup. Empty for a group that needs no name.
    std::string name = {};
    /// Whether one curve represents the group: it differs from each prediction by at most a quarter
    /// of the standard error of the reading.
    bool curve = false;

    /// Returns the path through the conditions of the group.
    /// @param readings all readings of the calibration
    ConditionPath path(const std::vector<Reading>& readings, const Coordinate& along) const;
};

/// Divides readings into groups that one curve each represents, if possible: tries one group, then
/// division by one quantity of `apart`, then by several in the order of `apart`. A curve represents
/// a group better if the normal stress does not go up and down along it, where the model depends on
/// the normal stress. No group mixes steady shear and points of failure; each of them has at most 8
/// groups.
/// @param members indices in the calibration of the readings to divide
/// @param along quantity along the x axis
std::vector<CurveGroup> curve_groups(const std::vector<std::size_t>& members,
                                     const Predictor& model, const Calibration& calibration,
                                     const Coordinate& along, const std::vector<Apart>& apart);

/// Predicted stress ratio and solid fraction along the x axis, with standard errors.
struct ModelCurve {
    std::vector<double> x;
    std::vector<Shown> y;

    /// Makes the curve from predicted shear stresses [Pa] and solid fractions [1].
    /// @param at value on the x axis for each condition
    /// @param predicted predictions at `conditions`, in their order
    ModelCurve(std::vector<double> at, const Prediction& predicted,
               const std::vector<Condition>& conditions);
    /// Adds the curve to a panel, with a band of one standard error.
    /// @param o quantity drawn as y: 0 for the stress ratio, 1 for the solid fraction
    /// @param look colour and label of the line, and whether the key shows it
    /// @param band_label name of the band in the CSV file
    void draw_in(Panel& panel, std::size_t o, const Curve& look,
                 const std::string& band_label) const;
};

}  // namespace pendular
