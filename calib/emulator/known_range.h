#pragma once

#include <Eigen/Core>
#include <string>

#include "calib/emulator/emulator.h"

namespace pendular {

/// Range of states of steady shear in which the known runs support predictions. A state is
/// supported if
/// - it lies in the convex hull of the runs' states in the emulator's coordinates x = ln(friction +
///   0.02), q = sqrt(I), ln(1 + 10/P*) and ln(V0/a^3), or outside by at most `margin` of the range
///   that the runs cover (I: inertial number; P* = a^2 s22/F0: reduced pressure; V0: bridge volume;
///   a: grain diameter; s22: normal stress; F0: pull-off force of a bridge),
/// - the emulator's relative standard error is at most `largest_ratio_error` for the stress ratio
///   and `largest_fraction_error` for the solid fraction, and
/// - both predicted values are physical: stress ratio above 0, solid fraction of 0.4 to 0.74.
///
/// Each run enters the convex hull twice, at its own inertial number and at inertial number 0,
/// since the emulator also predicts the quasi-static limit, with a standard error. A dry run enters
/// it at 1/P* = 0 with every bridge volume. Runs with effects do not enter, since the changes that
/// effects cause are emulated separately.
class KnownRange {
  public:
    /// Largest distance of a supported state from the convex hull of the runs, in coordinates
    /// scaled by the range of the runs [1].
    static constexpr double margin = 0.01;
    /// Largest standard errors of the predicted stress ratio and solid fraction at a supported
    /// state, relative to the predicted values [1].
    static constexpr double largest_ratio_error = 0.15;
    static constexpr double largest_fraction_error = 0.02;
    /// Range of predicted solid fractions that count as physical in dense flow [1]: from far below
    /// loose packing to crystals.
    static constexpr double lowest_fraction = 0.4, highest_fraction = 0.74;

    /// Finds the range of states of steady shear that an emulator's training runs support. The
    /// emulator must outlive this object.
    explicit KnownRange(const Emulator& emulator);

    /// Whether any run without effects has liquid bridges.
    bool knows_wet() const { return wet_.runs > 0; }
    /// Whether any run without effects is dry.
    bool knows_dry() const { return dry_.runs > 0; }

    /// Reason why the training runs do not support predictions at a state of steady shear, as in
    /// "friction 0.9 is above 0.6"; empty if the runs support predictions at the state.
    std::string why_unsupported(const FlowState& state) const;

    /// Returns a supported state of steady shear close to the unsupported state `state`. It is the
    /// nearest point of the convex hull of the runs' states. If the prediction at this point is too
    /// uncertain or unphysical, it is the first supported point on the straight way from this point
    /// to the nearest run.
    /// @throws std::invalid_argument if the state is wet but no run without effects is wet, or the
    ///         state is dry but no run without effects is dry
    FlowState nearest_supported(const FlowState& state) const;

  private:
    using Point = Eigen::Vector4d;
    /// Points whose convex hull is the supported range of states of steady shear, in coordinates
    /// scaled to 0 to 1 over the range of the runs.
    struct Cloud {
        /// Coordinates of the points, scaled to 0 to 1: a column for each point.
        Eigen::Matrix<double, 4, Eigen::Dynamic> corners;
        /// Number of points that are states of runs; they are the first columns of `corners`.
        Eigen::Index runs = 0;
    };
    const Cloud& cloud_for(const FlowState& state) const { return state.dry() ? dry_ : wet_; }
    /// Coordinates of a state of steady shear, scaled to 0 to 1 over the range of the runs.
    Point place(const FlowState& state) const;
    /// State of steady shear with the coordinates `place`, which are scaled to 0 to 1 over the
    /// range of the runs.
    FlowState state_at(const Point& place) const;
    /// Point of the convex hull of `cloud` that is nearest to `place`, in scaled coordinates.
    Point nearest_in_hull(const Point& place, const Cloud& cloud) const;
    /// Reason why the emulator's prediction of stress ratio or solid fraction at a state of steady
    /// shear is too uncertain or unphysical; empty if both predictions are certain enough and
    /// physical.
    std::string why_unsure(const FlowState& state) const;

    const Emulator& emulator_;
    /// Smallest coordinates of the states of the runs, and the extent of these states along each
    /// coordinate.
    Point least_, range_;
    Cloud dry_, wet_;
};

}  // namespace pendular
