#pragma once

#include <cstdint>
#include <stop_token>

#include "sim/dem/bridge_law.h"
#include "sim/dem/cell.h"
#include "sim/dem/grain_effects.h"
#include "sim/dem/grains.h"
#include "sim/dem/integrator.h"
#include "sim/dem/liquid_exchange.h"
#include "sim/dem/pair_laws.h"
#include "sim/dem/pair_list.h"
#include "sim/dem/shares.h"

namespace pendular::dem {

/// Stress, averaged over the volume of a sample, divided by the imposed normal stress [1]. The
/// stress is the sum of the contribution of the forces between grains and of the kinetic
/// contribution of velocity fluctuations. Compression is positive. Direction 1 is the flow, 2 the
/// velocity gradient, 3 the vorticity.
struct Stress {
    double s11 = 0, s22 = 0, s33 = 0, s12 = 0;

    template <typename Archive>
    void serialize(Archive& archive) {
        archive(s11, s22, s33, s12);
    }
};

/// Grains of a sample, with the periodic cell that contains them.
struct Sample {
    Grains grains;
    Cell cell;
};

/// Returns a sample of `count` grains at rest, at random positions without contact, at a solid
/// fraction of 0.3. The cell is so tall that it becomes approximately a cube once the sample is
/// compressed and flows.
/// @param seed seed of the random positions
/// @param diameters diameters of the grains divided by their mean [1]; if empty, all diameters are
///         1
/// @throws std::invalid_argument for fewer than 64 grains
Sample random_gas(int count, std::uint64_t seed, const std::vector<double>& diameters = {});

/// Simulation of grains in simple shear at a constant rate, in a periodic cell with Lees-Edwards
/// boundary conditions. In reduced units, the grain diameter, the grain mass and the imposed normal
/// stress are 1. The shear rate in reduced units equals the inertial number.
///
/// A servo changes the height H of the cell with time t and thereby keeps the normal stress s22 at
/// its imposed value. In reduced units:
///     (dH/dt)/H = (s22 - 1)/B      B: 0.05 times the stiffness number
/// The time average of s22 is therefore 1.
///
/// The time step is a fixed fraction of sqrt(m/K_N), with grain mass m and normal stiffness K_N of
/// the stiffest contact. The time step is smaller if the damping is more than critical, if the
/// grains differ in size, or if an effect damps the motion of pairs strongly.
class ShearCell {
  public:
    /// Makes a simulation that begins with `count` grains at random positions without contact
    /// (`random_gas`). Liquid bridges form only from the end of `compress` on.
    /// @param shear_rate shear rate in reduced units, equal to the inertial number
    /// @param parts number of threads among which each time step is divided; runs with equal
    ///         `parts` agree bit for bit
    /// @throws std::invalid_argument for fewer than 64 grains
    ShearCell(int count, const Material& material, double shear_rate, std::uint64_t seed,
              const BridgeLaw& bridges = {}, int parts = 1, const GrainEffects& effects = {});
    /// Makes a simulation that begins with the state `sample` in the uniform flow `flow`. The servo
    /// that keeps the normal stress is off until `hold_normal_stress(true)`. No liquid bridges form
    /// until `let_bridges_form(true)`.
    ShearCell(Sample sample, const Material& material, const Flow& flow,
              const BridgeLaw& bridges = {}, int parts = 1, const GrainEffects& effects = {});

    /// Returns the edge of the cube that `count` grains fill approximately once the grains flow
    /// [grain diameters].
    static double edge(int count);

    static constexpr int fewest_grains = 64;
    static constexpr double time_step_fraction = 0.2;

    /// Advances the sample by one leapfrog step of length dt (`time_step`). The function computes
    /// the forces from the positions at time t and the velocities at t - dt/2. The function then
    /// advances velocities, positions and the cell, in this order.
    /// @param accounting whether the stored and lost energies of pairs of grains are summed too
    ///         (`energy`)
    /// @throws SimulationError if the stress is not finite or an overlap exceeds half a grain
    ///         diameter
    void step(EnergyAccounting accounting = EnergyAccounting::off);

    /// Compresses the initial sample until the normal stress first reaches its imposed value. From
    /// then on, a servo keeps this normal stress, and liquid bridges form.
    /// @return false if the solid fraction reaches 0.8 before the normal stress reaches its imposed
    ///         value
    /// @throws Interrupted if a stop is requested
    /// @throws SimulationError if the stress is not finite or an overlap exceeds half a grain
    ///         diameter
    bool compress(const std::stop_token& stop = {});

    const Grains& grains() const { return grains_; }
    const Cell& cell() const { return cell_; }
    const PairList& pairs() const { return pairs_; }
    const Material& material() const { return material_; }
    /// Returns the law of the attraction by liquid bridges, including the changes by physical
    /// effects.
    const BridgeLaw& bridges() const { return bridges_; }
    const GrainEffects& effects() const { return effects_; }
    /// Returns the stress in the last time step, averaged over the sample and divided by the
    /// imposed normal stress [1]. The stress is computed from the positions before the time step.
    const Stress& stress() const { return stress_; }
    const Flow& flow() const { return flow_; }
    double shear_rate() const { return flow_.shear_rate; }
    /// Returns the energies stored in pairs of grains, and the energies lost in the last time step,
    /// in units of a^3 s22, with grain diameter a and imposed normal stress s22. All energies are
    /// zero if the last time step was made without energy accounting.
    const PairEnergy& energy() const { return energy_; }
    /// Returns the kinetic energy of all grains in units of a^3 s22, with grain diameter a and
    /// imposed normal stress s22. The energy is computed from the velocity fluctuations (velocities
    /// minus the imposed shear flow) and the angular velocities, half a time step after the last
    /// computation of the forces.
    double kinetic_energy() const { return motion_.energy(); }
    double strain() const { return strain_; }
    double time_step() const { return time_step_; }
    std::uint64_t steps() const { return steps_; }
    double solid_fraction() const;

    /// Sets the imposed velocity gradient. If the servo that keeps the normal stress is on, the
    /// servo continues to adjust the rate of change of the height (`Flow::height_rate`).
    void set_flow(const Flow& flow) { flow_ = flow; }
    /// Switches on or off the servo that keeps the normal stress at its imposed value by changing
    /// the height of the cell.
    void hold_normal_stress(bool held) { servo_ = held; }
    /// Switches the liquid bridges on or off. If switched on, bridges form when grains touch.
    void let_bridges_form(bool form) { bridging_ = form; }
    /// Sets the time step to a fraction of sqrt(m/K_N) in place of `time_step_fraction`, with grain
    /// mass m and normal stiffness K_N of the stiffest contact. The function is for tests of
    /// convergence.
    void set_time_step_fraction(double fraction) { fraction_ = fraction; }

    /// Saves or loads the state of the simulation. The state can be loaded only into a ShearCell
    /// that has the number of grains, the material, the bridge law, the effects and the number of
    /// threads (`parts`) of the saved ShearCell.
    template <typename Archive>
    void serialize(Archive& archive) {
        archive(grains_, cell_, pairs_, flow_, stress_, motion_, servo_, bridging_, fraction_,
                time_step_, strain_, largest_overlap_, recent_overlap_, steps_);
        shares_made_at_ = 0;  // the shares belong to the previous neighbour lists
    }

  private:
    void adjust_height_rate();
    void exchange_liquid();
    void check_state() const;
    PairSums sum_forces(const PairLaws& laws);
    /// Adds the forces of the pairs of one share (work of one thread) to `net_forces`, and returns
    /// the sums of virials and energies over these pairs. If `moved` is given, the function also
    /// moves each grain of the share once the forces on it are complete, and adds the grain's
    /// kinetic energy and similar terms to `moved`.
    PairSums sum_forces(const Share& share, std::vector<Grains::ForceAndTorque>& net_forces,
                        const PairLaws& laws, MotionSums* moved = nullptr);
    /// Adds the forces that other threads summed for the grains of thread `part` to the net forces
    /// on these grains. Sets the sums of the other threads for these grains to zero.
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
    LiquidExchange exchange_;
    BridgeLaw bridges_;
    Flow flow_;
    int parts_ = 1;
    std::vector<Share> shares_;
    std::size_t shares_made_at_ = 0;  ///< value of PairList::renewals when `shares_` were made
    /// For each thread except the first, the forces and torques on each grain that the thread
    /// summed, in reduced units.
    std::vector<std::vector<Grains::ForceAndTorque>> other_net_forces_;
    Stress stress_;
    PairEnergy energy_;
    MotionSums motion_;
    bool servo_ = false, bridging_ = false;
    double fraction_ = time_step_fraction;
    double bead_volume_ = 0;
    double time_step_ = 0;
    double strain_ = 0;
    /// Largest overlap of contacts in the last time step [grain diameters].
    double largest_overlap_ = 0;
    /// Largest overlap of contacts since `time_step_` was last updated [grain diameters], but at
    /// least the overlap at a normal force of 0.1 in reduced units.
    double recent_overlap_ = 0;
    std::uint64_t steps_ = 0;
};

}  // namespace pendular::dem
