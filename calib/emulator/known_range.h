#pragma once

#include <Eigen/Core>
#include <string>

#include "calib/emulator/emulator.h"

namespace pendular {

/// Range of states of steady shear in which the training runs of the emulator support predictions.
/// A state is supported if
/// - the state lies in the convex hull of the states of the runs, or at most `margin` outside,
/// - the relative standard error of the emulator is at most `largest_ratio_error` for the stress
///   ratio and at most `largest_fraction_error` for the solid fraction, and
/// - both predicted values are physical: the stress ratio is above 0 and the solid fraction is
///   between 0.4 and 0.74.
///
/// The convex hull has the coordinates ln(friction + 0.02), sqrt(I), ln(1 + 10/P*) and ln(V0/a^3),
/// with the inertial number I, the reduced pressure P*, the bridge volume V0 and the grain diameter
/// a.
///
/// Each run enters the hull at its own inertial number and at inertial number 0. A dry run enters
/// the hull of the wet states at 1/P* = 0 with every bridge volume. Runs with effects on grains do
/// not enter the hull.
class KnownRange {
  public:
    /// Largest distance of a supported state from the convex hull of the runs [1], in coordinates
    /// that are scaled by the range of the runs.
    static constexpr double margin = 0.01;
    /// Largest standard errors of the predicted stress ratio (`largest_ratio_error`) and of the
    /// predicted solid fraction (`largest_fraction_error`) at a supported state, relative to the
    /// predicted values [1].
    static constexpr double largest_ratio_error = 0.15;
    static constexpr double largest_fraction_error = 0.02;
    /// Lowest and highest predicted solid fraction [1] that count as physical in dense flow. The
    /// range extends from far below loose packing to crystals.
    static constexpr double lowest_fraction = 0.4, highest_fraction = 0.74;

    /// Finds the range of states of steady shear at which the training runs of the emulator support
    /// predictions. The emulator must outlive the object.
    explicit KnownRange(const Emulator& emulator);

    /// Whether the emulator was trained on a simulation with liquid bridges, among the simulations
    /// without added physical effects on the grains.
    bool knows_wet() const { return wet_.runs > 0; }
    /// Whether any training run without effects on grains is dry.
    bool knows_dry() const { return dry_.runs > 0; }

    /// Returns the reason why the training runs do not support predictions at a state of steady
    /// shear, such as "friction 0.9 is above 0.6". The text is empty if the runs support
    /// predictions at the state.
    std::string why_unsupported(const FlowState& state) const;

    /// Returns a state of steady shear, close to the unsupported state `state`, at which the
    /// training runs support predictions. The function tries the nearest point of the convex hull
    /// of the runs. If the prediction at this point is too uncertain or unphysical, the function
    /// returns the first supported point on the way from this point to the nearest run. The
    /// returned state has no effects on grains.
    /// @throws std::invalid_argument if the state is wet but no run without effects is wet, or if
    ///         the state is dry but no run without effects is dry
    FlowState nearest_supported(const FlowState& state) const;

  private:
    using Point = Eigen::Vector4d;
    /// Points whose convex hull contains the supported states of steady shear. Each coordinate is
    /// scaled so that the range of the runs is 0 to 1.
    struct Cloud {
        /// Coordinates of the points, scaled so that the range of the runs is 0 to 1. The matrix
        /// has a column for each point.
        Eigen::Matrix<double, 4, Eigen::Dynamic> corners;
        /// Number of runs whose states are the first columns of `corners`. The runs are dry in
        /// `dry_` and wet in `wet_`. Further columns are states that the runs support in addition,
        /// such as the quasi-static limit.
        Eigen::Index runs = 0;
    };
    const Cloud& cloud_for(const FlowState& state) const { return state.dry() ? dry_ : wet_; }
    /// Returns the coordinates of a state of steady shear, scaled so that the range of the runs is
    /// 0 to 1.
    Point place(const FlowState& state) const;
    /// Returns the state of steady shear with the coordinates `place`, which are scaled so that the
    /// range of the runs is 0 to 1.
    FlowState state_at(const Point& place) const;
    /// Returns the point of the convex hull of `cloud` that is nearest to the point `place`, in
    /// scaled coordinates.
    Point nearest_in_hull(const Point& place, const Cloud& cloud) const;
    /// Returns the reason why the emulator's prediction of stress ratio or solid fraction at a
    /// state of steady shear is too uncertain or unphysical. The text is empty if both predictions
    /// are physical and their standard errors are small enough.
    std::string why_unsure(const FlowState& state) const;

    const Emulator& emulator_;
    /// Smallest coordinates among the states of the runs (`least_`), and the range of the states of
    /// the runs along each coordinate (`range_`).
    Point least_, range_;
    Cloud dry_, wet_;
};

}  // namespace pendular
