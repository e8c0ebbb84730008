#pragma once

#include <Eigen/Core>
#include <string>

#include "calib/emulator/emulator.h"

namespace pendular {

/// Range of states that the known runs support. A state is supported where
/// - it lies in the convex hull of the runs' states in the emulator's coordinates x = ln(friction +
///   0.02), q = sqrt(I), ln(1 + 10/P*) and ln(V0/a^3), with V0 the bridge volume, or no farther
/// outside than `margin` of the
///   range that the runs cover,
/// - the emulator's standard error is at most `largest_ratio_error` of the stress ratio and
///   `largest_fraction_error` of the solid fraction, and
/// - both values are physical: stress ratio above 0, solid fraction of 0.4 to 0.74.
///
/// Each run counts at its own inertial number and at 0, since the quasi-static limit is
/// extrapolated with its error. Dry runs bound wet states of any bridge volume at 1/P* = 0. Runs
/// with effects do not count: their changes are emulated apart.
class KnownRange {
  public:
    static constexpr double margin = 0.01;                  ///< distance over the runs' range [1]
    static constexpr double largest_ratio_error = 0.15;     ///< relative [1]
    static constexpr double largest_fraction_error = 0.02;  ///< relative [1]
    /// Solid fractions that dense flow can have: from far below loose packing to crystals.
    static constexpr double lowest_fraction = 0.4, highest_fraction = 0.74;

    /// Range of the emulator's training runs. The emulator must outlive it.
    explicit KnownRange(const Emulator& emulator);

    /// Whether any run has liquid bridges, or any has none.
    bool knows_wet() const { return wet_.runs > 0; }
    bool knows_dry() const { return dry_.runs > 0; }

    /// Why the runs do not support a state, as in "friction 0.9 is above 0.6"; empty where they do.
    std::string why_unsupported(const FlowState& state) const;

    /// A supported state close to one that is not: the point of the hull nearest to it or, where
    /// the emulator is too unsure of that too, the first supported one on the way from there to the
    /// nearest run.
    /// @throws std::invalid_argument for a wet state where no run is wet, and a dry one where none
    ///         is dry
    FlowState nearest_supported(const FlowState& state) const;

  private:
    using Point = Eigen::Vector4d;
    /// Cloud of runs as columns of scaled coordinates.
    struct Cloud {
        Eigen::Matrix<double, 4, Eigen::Dynamic> corners;  ///< whose hull is known
        Eigen::Index runs = 0;                             ///< the first of them
    };
    const Cloud& cloud_for(const FlowState& state) const { return state.dry() ? dry_ : wet_; }
    Point place(const FlowState& state) const;
    FlowState state_at(const Point& place) const;
    Point nearest_in_hull(const Point& place, const Cloud& cloud) const;
    std::string why_unsure(const FlowState& state) const;

    const Emulator& emulator_;
    Point least_, range_;
    Cloud dry_, wet_;
};

}  // namespace pendular
