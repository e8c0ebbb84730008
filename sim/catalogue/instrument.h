#pragma once

#include <Eigen/Core>
#include <vector>

#include "data/annular_cell.h"
#include "data/reading.h"
#include "sim/catalogue/cell_state.h"
#include "sim/catalogue/effect.h"

namespace pendular {

/// Map from the true state of the cell to the state that the instrument shows. The map combines all
/// effects on the instrument in a study. Effects on the grains in the cell are applied first, then
/// effects on the transducers. Each of the two groups of effects is sorted by name.
class InstrumentMap {
  public:
    InstrumentMap() = default;
    /// Combines the effects of a list that act on the instrument. An effect is ignored if all its
    /// parameters have their neutral values, at which the effect changes nothing, or if the effect
    /// does not act on the instrument.
    explicit InstrumentMap(const std::vector<ActiveEffect>& effects);

    /// Whether no effect on the instrument acts, so that the instrument shows the true state of the
    /// cell.
    bool empty() const { return effects_.empty(); }

    /// Returns the state of the cell that the instrument shows if `truth` is the true state. If no
    /// effect acts on the instrument, the true state is returned bit for bit.
    CellState show(CellState truth) const;

    /// Returns the true state of the cell if the instrument shows the state `shown`. The function
    /// is the inverse of `show` to a relative accuracy of 1e-11. Radii, grain properties and time
    /// do not change. If no effect acts on the instrument, the function returns `shown` bit for
    /// bit.
    /// @throws std::domain_error if the instrument shows `shown` for no true state with positive
    ///         normal force, height and volume of grains; the message names the effects
    CellState truth(const CellState& shown) const;

  private:
    std::vector<ActiveEffect> effects_;
};

/// Returns the state of the cell that the instrument showed for a reading. The torque follows from
/// the shear stress. The angular velocity of the lid follows from the inertial number. If the
/// condition has no height, the height follows from the solid fraction. If the condition has no
/// volume of grains, the function uses the volume that `cell` states.
/// @param shown recorded condition
/// @param shear_stress shear stress of the reading [Pa]
/// @param solid_fraction solid fraction of the reading [1]
CellState shown_state(const Condition& shown, double shear_stress, double solid_fraction,
                      AnnularCell cell, const GrainProperties& grains);

/// Returns the true condition of the grains for a recorded condition: normal stress, inertial
/// number, liquid content, height and volume of grains. The inertial number I follows from the
/// angular velocity omega of the lid, the sample height H and the normal stress s22:
///     I/I_shown = (omega/omega_shown) (H_shown/H) sqrt(s22_shown/s22)
/// Symbols without an index are true values. An inertial number of 0 stays 0. Quantities that no
/// effect changes stay equal bit for bit.
/// @param shown recorded condition
/// @param truth true state of the cell
Condition true_condition(const Condition& shown, const CellState& truth, const InstrumentMap& map);

/// Returns the reading that the instrument shows if `predicted` is the true reading. A reading is a
/// vector of shear stress [Pa] and solid fraction [1]. The shown solid fraction follows from the
/// height and the volume of grains that the instrument shows. If no effect acts on the instrument,
/// the function returns `predicted` bit for bit.
/// @param predicted true reading
/// @param truth true state of the cell; the function replaces torque and height by the values that
///         follow from `predicted`
Eigen::Vector2d shown_reading(const Eigen::Vector2d& predicted, CellState truth,
                              const InstrumentMap& map, const AnnularCell& cell);

/// Returns the true state of the cell at which the instrument shows the normal stress, inertial
/// number, liquid content and time of a requested condition. The true height follows from the true
/// solid fraction. The angular velocity of the lid gives the requested inertial number at the
/// height that the instrument shows.
/// @param asked requested condition
/// @param flow true stress ratio [1] and true solid fraction [1] of the grains
/// @throws std::domain_error if the instrument shows the requested values for no true state
CellState truth_at_set_points(const Condition& asked, const FlowPoint& flow,
                              const InstrumentMap& map, const AnnularCell& cell,
                              const GrainProperties& grains);

}  // namespace pendular
