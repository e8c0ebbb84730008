#pragma once

#include <Eigen/Core>
#include <vector>

#include "data/annular_cell.h"
#include "data/reading.h"
#include "sim/catalogue/cell_state.h"
#include "sim/catalogue/effect.h"

namespace pendular {

/// The instrument map: all instrument effects of a study as one map from the true state of the cell
/// to the shown one. Effects on the beads come before those on the transducers, by name within.
class InstrumentMap {
  public:
    InstrumentMap() = default;
    /// Takes the instrument effects among `effects` that are not neutral.
    explicit InstrumentMap(const std::vector<ActiveEffect>& effects);

    /// Whether what is shown is the truth.
    bool empty() const { return effects_.empty(); }

    /// State that the instrument shows for a true state; without effects the state itself, bit for
    /// bit.
    CellState show(CellState truth) const;

    /// The true state that is shown so, by Newton's method to 1e-12 of the size of each value:
    /// torque, normal force, height, angular velocity, liquid content and bead volume; geometry and
    /// time are the same on either side. Without effects the shown state itself, bit for bit.
    /// @throws std::domain_error naming the effects where no state with a positive normal force,
    ///         height and bead volume shows this
    CellState truth(const CellState& shown) const;

  private:
    std::vector<ActiveEffect> effects_;
};

/// The shown state of the cell at a recorded condition, shear stress [Pa] and solid fraction [1]:
/// what `import` made of the recording, undone. The bead volume is the condition's, else the
/// cell's; the height is the condition's, else the one that goes with the solid fraction; I = 0
/// is a lid at rest.
CellState shown_state(const Condition& shown, double shear_stress, double solid_fraction,
                      AnnularCell cell, const GrainProperties& grains);

/// The condition that is truly imposed where `shown` is recorded and `truth` is the state of the
/// cell: normal stress, inertial number, liquid content, height and bead volume. The inertial
/// number goes with the true rate omega (Ri + Re)/(2 H) and the true normal stress,
///     I/I_shown = (omega/omega_shown) (H_shown/H) sqrt(s22_shown/s22)
/// and stays 0 where it is. What no effect touches is as shown, bit for bit.
Condition true_condition(const Condition& shown, const CellState& truth, const InstrumentMap& map);

/// Apparent (shear stress [Pa], solid fraction [1]) of beads whose true ones are `predicted` at the
/// true normal force, angular velocity, liquid content and bead volume of `truth`: the height
/// follows from the predicted solid fraction and the true bead volume, and what the instrument then
/// shows is converted as `import` converts it, with the shown bead volume. `predicted` itself, bit
/// for bit, where the map is empty.
Eigen::Vector2d shown_reading(const Eigen::Vector2d& predicted, CellState truth,
                              const InstrumentMap& map, const AnnularCell& cell);

/// The true state of the cell in which beads flow as `flow` says (mu*, Phi_S), where the normal
/// stress, inertial number, liquid content and time of `asked` are what the instrument shows. The
/// gap is where the beads put it, so that the lid turns at the rate that the shown gap needs.
/// @throws std::domain_error as InstrumentMap::truth
CellState truth_at_set_points(const Condition& asked, const FlowPoint& flow,
                              const InstrumentMap& map, const AnnularCell& cell,
                              const GrainProperties& grains);

}  // namespace pendular
