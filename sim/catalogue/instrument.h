#pragma once

#include <Eigen/Core>
#include <vector>

#include "data/annular_cell.h"
#include "data/reading.h"
#include "sim/catalogue/cell_state.h"
#include "sim/catalogue/effect.h"

namespace pendular {

/// The instrument map: all instrument effects of a study, combined into one map from the true state
/// of the cell to the shown state. Effects on the grains in the cell are applied first, then
/// effects on the transducers, each group sorted by name.
class InstrumentMap {
  public:
    InstrumentMap() = default;
    /// Constructs the map from the effects on the instrument among `effects` whose parameters are
    /// not all at their neutral values; other effects are ignored.
    explicit InstrumentMap(const std::vector<ActiveEffect>& effects);

    /// Whether no effect acts, so that the instrument shows the true state.
    bool empty() const { return effects_.empty(); }

    /// Returns the state that the instrument shows where `truth` is the true state of the cell.
    /// Without effects returns `truth`, bit for bit.
    CellState show(CellState truth) const;

    /// Returns the true state of the cell for which the instrument shows `shown`, the inverse of
    /// `show`. Newton's method solves for torque, normal force, height, angular velocity, liquid
    /// content and bead volume, until `show` gives the values of `shown` to 1e-11 of their size or
    /// better. Cell radii, grain properties and time are unchanged. Without effects returns
    /// `shown`, bit for bit.
    /// @throws std::domain_error, naming the effects, where no state with a positive normal force,
    ///         height and bead volume is shown as `shown`
    CellState truth(const CellState& shown) const;

  private:
    std::vector<ActiveEffect> effects_;
};

/// Returns the state of the cell that the instrument showed at a recorded condition, from the
/// reading's shear stress [Pa] and solid fraction [1]: the inverse of `import`, which converts
/// torque and gap to shear stress and solid fraction. If the condition states no bead volume, the
/// cell's is used; if it states no height, the height follows from the solid fraction. At I = 0 the
/// lid is at rest.
CellState shown_state(const Condition& shown, double shear_stress, double solid_fraction,
                      AnnularCell cell, const GrainProperties& grains);

/// Returns the condition that is truly imposed (normal stress, inertial number, liquid content,
/// height and bead volume) where `shown` is recorded and `truth` is the true state of the cell. The
/// inertial number follows from the true shear rate omega (Ri + Re)/(2 H) and normal stress,
///     I/I_shown = (omega/omega_shown) (H_shown/H) sqrt(s22_shown/s22)
/// A shown inertial number of 0 remains 0. Quantities that no effect changes are returned as shown,
/// bit for bit.
Condition true_condition(const Condition& shown, const CellState& truth, const InstrumentMap& map);

/// Returns the reading (shear stress [Pa], solid fraction [1]) that the instrument shows where
/// `predicted` is the true reading, at the true normal force, angular velocity, liquid content and
/// bead volume of `truth`. The true height follows from the predicted solid fraction and the true
/// bead volume. Shown torque and gap are converted to a reading as by `import`, with the shown bead
/// volume. Returns `predicted`, bit for bit, if the map is empty.
Eigen::Vector2d shown_reading(const Eigen::Vector2d& predicted, CellState truth,
                              const InstrumentMap& map, const AnnularCell& cell);

/// Returns the true state of the cell where the grains have the stress ratio and solid fraction of
/// `flow` and the instrument shows the normal stress, inertial number, liquid content and time of
/// `asked`. The gap follows from the solid fraction of `flow`, and the lid turns at the angular
/// velocity that gives the inertial number of `asked` at the shown gap.
/// @throws std::domain_error where InstrumentMap::truth finds no true state
CellState truth_at_set_points(const Condition& asked, const FlowPoint& flow,
                              const InstrumentMap& map, const AnnularCell& cell,
                              const GrainProperties& grains);

}  // namespace pendular
