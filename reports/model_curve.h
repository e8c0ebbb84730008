#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "calib/fit/calibration.h"
#include "reports/figure.h"
#include "reports/figure_style.h"

namespace pendular {

// How figures draw the fitted model beside readings: what an instrument shows may depend on more
// than a figure's axis, such as normal stress, height of the sample and time.

/// Quantity of a condition along which a curve runs.
struct Coordinate {
    double (*of)(const Condition&);
    void (*set)(Condition&, double);
};
extern const Coordinate along_inertial_number;        ///< [1]
extern const Coordinate along_inverse_normal_stress;  ///< [1/Pa]

/// Conditions between those of readings: every number is interpolated linearly along a coordinate,
/// between the means of conditions whose coordinates agree within 5 %, and constant beyond them.
class ConditionPath {
  public:
    /// @param conditions at least one
    ConditionPath(std::vector<Condition> conditions, const Coordinate& along);
    Condition at(double coordinate) const;

  private:
    Coordinate along_;
    std::vector<Condition> nodes_;  ///< by rising coordinate
};

/// Quantity by which curves of the model are separated.
enum class Apart { normal_stress, bead_volume, file };

/// Readings that are drawn together.
struct CurveGroup {
    std::vector<std::size_t> members;  ///< by place in the calibration
    std::string name = {};  ///< what sets it apart, as "σ_{22} = 300 Pa"; empty of the only one
    /// A curve of the model along the coordinate, through the conditions of the members, passes the
    /// prediction of each within a quarter of its standard error.
    bool curve = false;

    ConditionPath path(const std::vector<Reading>& readings, const Coordinate& along) const;
};

/// Divides readings by what may set curves apart, one after the other, until a curve through each
/// part tells what the model predicts of its readings. Stops before there are more than 8 parts.
std::vector<CurveGroup> curve_groups(const std::vector<std::size_t>& members,
                                     const Predictor& model, const Calibration& calibration,
                                     const Coordinate& along, const std::vector<Apart>& apart);

/// The model along an axis, with its standard errors.
struct ModelCurve {
    std::vector<double> x;
    std::vector<Shown> y;

    /// Predictions at conditions whose places on the axis are these.
    ModelCurve(std::vector<double> at, const Prediction& predicted,
               const std::vector<Condition>& conditions);
    /// Adds its band and its line, for observable `o`, in the colour of `look`.
    void draw_in(Panel& panel, std::size_t o, const Curve& look,
                 const std::string& band_label) const;
};

}  // namespace pendular
