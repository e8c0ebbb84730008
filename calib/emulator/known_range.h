#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "calib/emulator/emulator.h"

namespace pendular {

/// Range of states in which the emulator's training runs support predictions. A state is supported
/// if
/// - it lies in the convex hull of the states of the runs, or at most `margin` outside,
/// - the relative standard error of the emulator is at most `largest_ratio_error` for the stress
///   ratio and at most `largest_fraction_error` for the solid fraction, and
/// - both predicted values are physical: the stress ratio is above 0 and the solid fraction is
///   between 0.4 and 0.74.
///
/// The convex hull has the coordinates ln(friction + 0.02), sqrt(I), ln(1 + 10/P*) and ln(V0/a^3),
/// scaled so that the range of the runs is 0 to 1. Each run enters the hull at its own inertial
/// number and at inertial number 0. A dry run enters the hull of the wet states at 1/P* = 0 with
/// every bridge volume. Runs with effects on grains do not enter the hull.
class KnownRange {
  public:
    /// Largest distance of a supported state from the convex hull [1], in scaled coordinates: a
    /// hundredth of the range of the runs, far above the errors with which the hull is searched.
    static constexpr double margin = 0.01;
    /// Largest relative standard errors of the predictions at a supported state [1]. Chosen: a
    /// coarse guard, since the standard error of each prediction enters the fit anyway.
    static constexpr double largest_ratio_error = 0.15;
    static constexpr double largest_fraction_error = 0.02;
    /// Range of physical solid fractions [1] in dense flow: from far below loose packing to
    /// crystals.
    static constexpr double lowest_fraction = 0.4, highest_fraction = 0.74;

    /// @param emulator must outlive the object
    explicit KnownRange(const Emulator& emulator);

    /// Whether any training run without effects on grains is wet.
    bool knows_wet() const { return wet_.runs > 0; }
    /// Whether any training run without effects on grains is dry.
    bool knows_dry() const { return dry_.runs > 0; }

    /// Returns why a state is not supported, such as "friction 0.9 is above 0.6"; empty if it is.
    std::string why_unsupported(const FlowState& state) const;

    /// Returns the same for several states, which takes less time than one by one.
    std::vector<std::string> why_unsupported(const std::vector<FlowState>& states) const;

    /// Returns a supported state, without effects on grains, close to the unsupported state
    /// `state`: the nearest point of the convex hull or, if the prediction there is too uncertain
    /// or unphysical, the first supported point on the way from it to the nearest run.
    /// @throws std::invalid_argument if the state is wet but no run without effects is wet, or if
    ///         the state is dry but no run without effects is dry
    FlowState nearest_supported(const FlowState& state) const;

  private:
    using Point = Eigen::Vector4d;
    /// Points whose convex hull contains the supported states.
    struct Cloud {
        Eigen::Matrix<double, 4, Eigen::Dynamic> corners;  ///< scaled; a column for each point
        /// Number of runs, whose states are the first columns. Further columns are states that the
        /// runs support in addition, such as the quasi-static limit.
        Eigen::Index runs = 0;
    };
    const Cloud& cloud_for(const FlowState& state) const { return state.dry() ? dry_ : wet_; }
    Point place(const FlowState& state) const;
    FlowState state_at(const Point& place) const;
    Point nearest_in_hull(const Point& place, const Cloud& cloud) const;
    /// Returns why a state is too far from the runs; empty if it is not.
    std::string why_outside(const FlowState& state) const;
    /// Returns why each prediction is too uncertain or unphysical; empty if it is not.
    std::vector<std::string> why_unsure(const std::vector<FlowState>& states) const;
    std::string why_unsure(const FlowState& state) const {
        return why_unsure(std::vector{state}).front();
    }

    const Emulator& emulator_;
    /// Smallest coordinates of the runs, and their range along each coordinate.
    Point least_, range_;
    Cloud dry_, wet_;
};

}  // namespace pendular
