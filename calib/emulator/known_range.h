#pragma once

#include <Eigen/Core>
#include <string>

#include "calib/emulator/emulator.h"

namespace pendular {

/// Range of flow states in which the known runs support predictions. A state is supported where
/// - it lies in the convex hull of the runs' states in the emulator's coordinates x = ln(friction +
///   0.02), q = sqrt(I), ln(1 + 10/P*) and ln(V0/a^3), with V0 the bridge volume, or outside by at
///   most `margin` of the range that the runs cover,
/// - the emulator's standard error is at most `largest_ratio_error` of the stress ratio and
///   `largest_fraction_error` of the solid fraction, and
/// - both values are physical: stress ratio above 0, solid fraction of 0.4 to 0.74.
///
/// Each run counts at its own inertial number and at 0, since the emulator extrapolates to the
/// quasi-static limit with an error. Dry runs bound wet states of any bridge volume at 1/P* = 0.
/// Runs with effects do not count, since the changes by effects are emulated separately.
class KnownRange {
  public:
    /// Largest distance of a supported state from the hull, relative to the range of the runs [1].
    static constexpr double margin = 0.01;
    /// Largest relative standard errors of the stress ratio and of the solid fraction [1].
    static constexpr double largest_ratio_error = 0.15;
    static constexpr double largest_fraction_error = 0.02;
    /// Range of solid fractions of dense flow [1]: from far below loose packing to crystals.
    static constexpr double lowest_fraction = 0.4, highest_fraction = 0.74;

    /// Finds the range of an emulator's training runs. The emulator must outlive this object.
    explicit KnownRange(const Emulator& emulator);

    /// Whether any run without effects has liquid bridges.
    bool knows_wet() const { return wet_.runs > 0; }
    /// Whether any run without effects is dry.
    bool knows_dry() const { return dry_.runs > 0; }

    /// Reason why the runs do not support predictions at a state, as in "friction 0.9 is above
    /// 0.6"; empty where they do.
    std::string why_unsupported(const FlowState& state) const;

    /// Returns a supported state close to an unsupported one: the nearest point of the convex hull
    /// or, where the emulator's error is too large there, the first supported point on the way from
    /// that point to the nearest run.
    /// @throws std::invalid_argument for a wet state where no run is wet, and for a dry state where
    ///         no run is dry
    FlowState nearest_supported(const FlowState& state) const;

  private:
    using Point = Eigen::Vector4d;
    /// Points whose convex hull is supported, in scaled coordinates.
    struct Cloud {
        Eigen::Matrix<double, 4, Eigen::Dynamic> corners;  ///< a column for each point
        Eigen::Index runs = 0;  ///< number of runs, which are the first columns
    };
    const Cloud& cloud_for(const FlowState& state) const { return state.dry() ? dry_ : wet_; }
    /// Scaled coordinates of a state: 0 to 1 over the range of the runs.
    Point place(const FlowState& state) const;
    /// State with these scaled coordinates.
    FlowState state_at(const Point& place) const;
    /// Point of the convex hull of a cloud that is nearest to a place.
    Point nearest_in_hull(const Point& place, const Cloud& cloud) const;
    /// Reason why the emulator's prediction at a state is too uncertain or unphysical; else empty.
    std::string why_unsure(const FlowState& state) const;

    const Emulator& emulator_;
    Point least_, range_;  ///< smallest coordinates of the runs, and the range that they cover
    Cloud dry_, wet_;
};

}  // namespace pendular
