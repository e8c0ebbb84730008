#pragma once

#include <Eigen/Core>
#include <vector>

#include "data/annular_cell.h"
#include "data/reading.h"
#include "sim/catalogue/effect.h"

namespace pendular {

/// Map from the true state of the cell to the state that the instrument shows, by all effects on
/// the instrument: first those on the grains in the cell, then those on the transducers, each group
/// sorted by name. Without such effects, all conversions of this file return their argument bit for
/// bit.
class InstrumentMap {
  public:
    InstrumentMap() = default;
    /// Combines the effects that act on the instrument and are not neutral; ignores the others.
    explicit InstrumentMap(const std::vector<ActiveEffect>& effects);

    /// Whether the instrument shows the true state.
    bool empty() const { return effects_.empty(); }

    /// Returns the state that the instrument shows if `truth` is the true state.
    CellState show(CellState truth) const;

    /// Returns the true state if the instrument shows `shown`: the inverse of `show`, to a relative
    /// accuracy of 1e-11. Radii, grain properties and time do not change.
    /// @throws std::domain_error if the instrument shows `shown` for no true state with positive
    ///         normal force, height and volume of grains; the message names the effects
    /// @param near state from which to search, close to the true one; null: `shown`
    CellState truth(const CellState& shown, const CellState* near = nullptr) const;

  private:
    std::vector<ActiveEffect> effects_;
};

/// Returns the state that the instrument showed for a reading: the torque follows from the shear
/// stress, the angular velocity from the inertial number, the height, if the condition has none,
/// from the solid fraction. A condition without volume of grains has the volume of `cell`.
/// @param shear_stress of the reading [Pa]
/// @param solid_fraction of the reading [1]
CellState shown_state(const Condition& shown, double shear_stress, double solid_fraction,
                      AnnularCell cell, const GrainProperties& grains);

/// Returns the true condition of the grains (normal stress, inertial number, liquid content, height
/// and volume of grains) for a recorded condition. The inertial number I follows from angular
/// velocity omega, height H and normal stress s22, which are true values without an index:
///     I/I_shown = (omega/omega_shown) (H_shown/H) sqrt(s22_shown/s22)
/// An inertial number of 0 stays 0. Quantities that no effect changes stay equal bit for bit.
Condition true_condition(const Condition& shown, const CellState& truth, const InstrumentMap& map);

/// Returns the reading (shear stress [Pa], solid fraction [1]) that the instrument shows for a true
/// reading. The solid fraction follows from the shown height and volume of grains.
/// @param truth true state of the cell; torque and height are replaced by those of `predicted`
Eigen::Vector2d shown_reading(const Eigen::Vector2d& predicted, CellState truth,
                              const InstrumentMap& map, const AnnularCell& cell);

/// Returns the true state at which the instrument shows normal stress, inertial number, liquid
/// content and time of a requested condition. The true height follows from the true solid fraction;
/// the angular velocity gives the requested inertial number at the height that the instrument
/// shows.
/// @param flow of the grains, true values
/// @throws std::domain_error if the instrument shows the requested values for no true state
CellState truth_at_set_points(const Condition& asked, const FlowPoint& flow,
                              const InstrumentMap& map, const AnnularCell& cell,
                              const GrainProperties& grains);

}  // namespace pendular
