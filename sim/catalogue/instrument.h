#pragma once

#include <Eigen/Core>
#include <vector>

#include "data/annular_cell.h"
#include "data/reading.h"
#include "sim/catalogue/cell_state.h"
#include "sim/catalogue/effect.h"

namespace pendular {

/// All effects on the instrument in a study, combined into one map from the true state of the cell
/// to the state that the instrument shows. Effects on the grains in the cell are applied first,
/// then effects on the transducers, each group sorted by name.
class InstrumentMap {
  public:
    InstrumentMap() = default;
    /// Combines the effects in a list that act on the instrument and have a parameter that differs
    /// from its neutral value (no effect). Other effects in the list are ignored.
    explicit InstrumentMap(const std::vector<ActiveEffect>& effects);

    /// True if no effect on the instrument acts, so that the instrument shows the true state of the
    /// cell.
    bool empty() const { return effects_.empty(); }

    /// State of the cell that the instrument shows if `truth` is the true state. If no effect acts
    /// on the instrument, the true state is returned bit for bit.
    CellState show(CellState truth) const;

    /// True state of the cell if the instrument shows the state `shown`; the inverse of `show`.
    /// Newton's method solves for torque, normal force, height, angular velocity, liquid content
    /// and volume of grains, until `show` returns the given values to a relative accuracy of 1e-11
    /// or better. Radii, grain properties and time do not change. Without effects, `shown` is
    /// returned bit for bit.
    /// @throws std::domain_error if no true state with positive normal force, height and volume of
    ///         grains is shown as `shown`; the message names the effects
    CellState truth(const CellState& shown) const;

  private:
    std::vector<ActiveEffect> effects_;
};

/// Returns the state of the cell that the instrument showed for a reading: converts shear stress
/// and solid fraction back to torque and gap, as the import of recordings converted torque and gap
/// to them. If the condition has no volume of grains, the volume in the cell is used; if it has no
/// height, the height follows from the solid fraction. At inertial number 0 the lid is at rest.
/// @param shown recorded condition
/// @param shear_stress shear stress of the reading [Pa]
/// @param solid_fraction solid fraction of the reading [1]
CellState shown_state(const Condition& shown, double shear_stress, double solid_fraction,
                      AnnularCell cell, const GrainProperties& grains);

/// Returns the true condition of the grains (normal stress, inertial number, liquid content, height
/// and volume of grains) for a recorded condition. The inertial number I follows from the true
/// angular velocity omega of the lid, sample height H and normal stress s22,
///     I/I_shown = (omega/omega_shown) (H_shown/H) sqrt(s22_shown/s22)
/// An inertial number of 0 stays 0. Quantities that no effect changes stay equal bit for bit.
/// @param shown recorded condition
/// @param truth true state of the cell
Condition true_condition(const Condition& shown, const CellState& truth, const InstrumentMap& map);

/// Returns the reading (shear stress [Pa], solid fraction [1]) that the instrument shows if
/// `predicted` is the true reading. The true height follows from the predicted solid fraction and
/// the true volume of grains. The torque and gap that the instrument shows are converted to a
/// reading like recorded values, with the volume of grains that the instrument shows. If no effect
/// acts, the prediction is returned bit for bit.
/// @param predicted true reading (shear stress [Pa], solid fraction [1])
/// @param truth true normal force, angular velocity, liquid content and volume of grains
Eigen::Vector2d shown_reading(const Eigen::Vector2d& predicted, CellState truth,
                              const InstrumentMap& map, const AnnularCell& cell);

/// Returns the true state of the cell at which the instrument shows a requested condition: normal
/// stress, inertial number, liquid content and time. The gap follows from the true solid fraction;
/// the angular velocity of the lid gives the requested inertial number at the gap that the
/// instrument shows.
/// @param asked requested condition
/// @param flow true stress ratio and solid fraction of the grains [1]
/// @throws std::domain_error if the instrument shows the requested values for no true state
CellState truth_at_set_points(const Condition& asked, const FlowPoint& flow,
                              const InstrumentMap& map, const AnnularCell& cell,
                              const GrainProperties& grains);

}  // namespace pendular
