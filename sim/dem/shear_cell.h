#pragma once

#include <cstdint>
#include <stop_token>

#include "sim/dem/bridge_law.h"
#include "sim/dem/cell.h"
#include "sim/dem/grain_effects.h"
#include "sim/dem/grains.h"
#include "sim/dem/integrator.h"
#include "sim/dem/pair_laws.h"
#include "sim/dem/pair_list.h"
#include "sim/dem/shares.h"

namespace pendular::dem {

/// Stress over the imposed normal stress [1]; compression positive, pair forces plus kinetic term.
struct Stress {
    double s11 = 0, s22 = 0, s33 = 0, s12 = 0;

    template <typename Archive>
    void serialize(Archive& archive) {
        archive(s11, s22, s33, s12);
    }
};

/// Grains in their cell.
struct Sample {
    Grains grains;
    Cell cell;
};

/// `count` grains at random, without contact, at solid fraction 0.3 and at rest, in a cell that is
/// a cube once they flow; of these diameters, or all of 1.
/// @throws std::invalid_argument for fewer than 64 grains
Sample random_gas(int count, std::uint64_t seed, const std::vector<double>& diameters = {});

/// A sample in simple shear between Lees-Edwards images at a constant rate, its height free so that
/// s22 stays at 1. Reduced units: grain diameter, mass and imposed normal stress are 1, so that the
/// shear rate is the inertial number.
///
/// Height servo, first order: (dH/dt)/H = (s22 - 1)/(B t0), with B = 0.05 kappa, well below
/// the packing's modulus at stiffness number kappa, and t0 = sqrt(m/(a s22)), the time a grain
/// needs to move its own size. The stress then returns to its target within a fraction of t0 at
/// every stiffness and nothing is left to tune; as ln H is bounded, the time average of s22 is 1
/// exactly.
///
/// Time step: a fixed fraction of sqrt(m/K_N) of the stiffest contact, followed as it changes; less
/// where the damping is more than critical.
class ShearCell {
  public:
    /// Starts from a random gas. Bridges form from the end of `compress` on. Each step is done in
    /// `parts` side by side, a thread each; forces are summed part by part, so that a run is the
    /// same for the same number of parts.
    /// @throws std::invalid_argument as random_gas
    ShearCell(int count, const Material& material, double shear_rate, std::uint64_t seed,
              const BridgeLaw& bridges = {}, int parts = 1, const GrainEffects& effects = {});
    /// Starts from any sample in any uniform flow; its stress is not controlled, and no bridges
    /// form until requested.
    ShearCell(Sample sample, const Material& material, const Flow& flow,
              const BridgeLaw& bridges = {}, int parts = 1, const GrainEffects& effects = {});

    /// Edge of the cube that so many grains fill once they flow [diameters].
    static double edge(int count);

    static constexpr int fewest_grains = 64;
    static constexpr double time_step_fraction = 0.2;

    /// One step of the leapfrog: forces at x(t) from v(t - dt/2), then velocities, then positions.
    /// @throws SimulationError where the state is no longer finite
    void step(EnergyAccounting accounting = EnergyAccounting::off);

    /// Closes the gaps of the initial state at a constant rate until s22 first reaches its target.
    /// @return false where it was not reached before the grains would fill the cell
    /// @throws Interrupted when a stop is requested
    bool compress(const std::stop_token& stop = {});

    const Grains& grains() const { return grains_; }
    const Cell& cell() const { return cell_; }
    const PairList& pairs() const { return pairs_; }
    const Material& material() const { return material_; }
    /// Law of the bridges with the changes that effects make.
    const BridgeLaw& bridges() const { return bridges_; }
    const GrainEffects& effects() const { return effects_; }
    /// Stress of the last step, from the forces at its beginning.
    const Stress& stress() const { return stress_; }
    const Flow& flow() const { return flow_; }
    double shear_rate() const { return flow_.shear_rate; }
    /// Energies of the last step, if it was made with energy accounting.
    const PairEnergy& energy() const { return energy_; }
    /// Kinetic energy of the peculiar motion, half a step after the last forces.
    double kinetic_energy() const { return motion_.energy(); }
    double strain() const { return strain_; }
    double time_step() const { return time_step_; }
    std::uint64_t steps() const { return steps_; }
    double solid_fraction() const;

    /// Changes the imposed flow; its height rate is the servo's while the stress is held.
    void set_flow(const Flow& flow) { flow_ = flow; }
    /// Whether the servo holds s22 at 1.
    void hold_normal_stress(bool held) { servo_ = held; }
    /// Whether contacts form bridges from now on.
    void let_bridges_form(bool form) { bridging_ = form; }
    /// Makes the time step this fraction of sqrt(m/K_N) instead of the standard one, for tests of
    /// convergence.
    void set_time_step_fraction(double fraction) { fraction_ = fraction; }

    /// Saves or loads the state; the sample loaded into must have the same grains, laws and parts.
    template <typename Archive>
    void serialize(Archive& archive) {
        archive(grains_, cell_, pairs_, flow_, stress_, motion_, servo_, bridging_, fraction_,
                time_step_, strain_, largest_overlap_, recent_overlap_, steps_);
        shares_made_at_ = 0;  // of other lists
    }

  private:
    void adjust_height_rate();
    void check_state() const;
    PairSums sum_forces(const PairLaws& laws);
    /// Sums the forces of one share; moves its grains too where requested, each grain once its last
    /// pair is done.
    PairSums sum_forces(const Share& share, std::vector<Grains::ForceAndTorque>& net_forces,
                        const PairLaws& laws, MotionSums* moved = nullptr);
    /// Adds the forces that other parts summed for the grains of this part.
    void collect_net_forces(int part);
    std::vector<Grains::ForceAndTorque>& net_forces_of(int part);
    std::vector<Grains::ForceAndTorque> all_net_forces();
    void measure(const PairSums& sums);
    MotionSums move_grains();
    void advance_cell();
    void follow_stiffest_contact();

    Grains grains_;
    Cell cell_;
    PairList pairs_;
    Material material_;
    GrainEffects effects_;
    BridgeLaw bridges_;
    Flow flow_;
    int parts_ = 1;
    std::vector<Share> shares_;
    std::size_t shares_made_at_ = 0;  ///< renewals of the lists
    std::vector<std::vector<Grains::ForceAndTorque>>
        other_net_forces_;  ///< of the parts after the first
    Stress stress_;
    PairEnergy energy_;
    MotionSums motion_;
    bool servo_ = false, bridging_ = false;
    double fraction_ = time_step_fraction;
    double bead_volume_ = 0;
    double time_step_ = 0;
    double strain_ = 0;
    double largest_overlap_ = 0;  ///< of the last step
    double recent_overlap_ = 0;   ///< largest since the time step was last reconsidered
    std::uint64_t steps_ = 0;
};

}  // namespace pendular::dem
