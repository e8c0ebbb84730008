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

/// Stress averaged over the volume of a sample, over the imposed normal stress [1]: contribution of
/// the forces between grains plus kinetic contribution of velocity fluctuations. Compression is
/// positive. Direction 1 is the flow, 2 the velocity gradient, 3 the vorticity.
struct Stress {
    double s11 = 0, s22 = 0, s33 = 0, s12 = 0;

    template <typename Archive>
    void serialize(Archive& archive) {
        archive(s11, s22, s33, s12);
    }
};

struct Sample {
    Grains grains;
    Cell cell;
};

/// Returns a sample of `count` grains at rest, at random positions without contact, at a solid
/// fraction of 0.3. The cell is so tall that it becomes approximately a cube once the sample is
/// compressed and flows.
/// @param diameters over their mean [1]; if empty, all are 1
/// @throws std::invalid_argument for fewer than 64 grains
Sample random_gas(int count, std::uint64_t seed, const std::vector<double>& diameters = {});

/// Simulation of grains in simple shear at a constant rate, in a periodic cell with Lees-Edwards
/// boundary conditions. In reduced units, the grain diameter, the grain mass and the imposed normal
/// stress are 1. The shear rate in reduced units equals the inertial number. Velocities exclude the
/// imposed flow, so that a grain that leaves the cell through one face enters it through another
/// without a jump of velocity.
///
/// A servo changes the height H of the cell with time t and thereby keeps the normal stress s22 at
/// its imposed value:
///     (dH/dt)/H = (s22 - 1)/B      B: 0.05 times the stiffness number
/// Since ln H is bounded, the time average of s22 is 1. With a servo that is eight times softer,
/// the stress ratio is 0.2157 +- 0.0013 instead of 0.2150 +- 0.0011 and the solid fraction 0.6270
/// instead of 0.6266 (+- 0.0002), at friction 0.05 and I = 0.003.
///
/// The time step is a fixed fraction of sqrt(m/K_N), with grain mass m and normal stiffness K_N of
/// the stiffest contact. The time step is smaller if the damping is more than critical, if the
/// grains differ in size, or if an effect damps the motion of pairs strongly.
class ShearCell {
  public:
    /// Begins with `count` grains at random positions without contact (`random_gas`). Bridges form
    /// only from the end of `compress` on.
    /// @param parts number of threads among which each time step is divided; runs with equal
    ///         `parts` agree bit for bit
    /// @throws std::invalid_argument for fewer than 64 grains
    ShearCell(int count, const Material& material, double shear_rate, std::uint64_t seed,
              const BridgeLaw& bridges = {}, int parts = 1, const GrainEffects& effects = {});
    /// Begins with a state in a uniform flow, without the servo until `hold_normal_stress(true)`
    /// and without new bridges until `let_bridges_form(true)`.
    ShearCell(Sample sample, const Material& material, const Flow& flow,
              const BridgeLaw& bridges = {}, int parts = 1, const GrainEffects& effects = {});

    /// Returns the edge of the cube that `count` grains fill approximately once they flow.
    static double edge(int count);

    /// Chosen: a cube of four grains, in which two images of one grain are never close to another.
    static constexpr int fewest_grains = 64;
    /// Time step over sqrt(m/K_N). With a quarter of it, the stress ratio is 0.2846 +- 0.0007
    /// instead of 0.2855 +- 0.0005, and the solid fraction 0.6134 instead of 0.6135 (+- 0.0001).
    static constexpr double time_step_fraction = 0.2;

    /// Advances the sample by one leapfrog step of length dt (`time_step`): forces from the
    /// positions at time t and the velocities at t - dt/2, then velocities, positions and the cell,
    /// in this order.
    /// @throws SimulationError if the stress is not finite or an overlap exceeds half a grain
    ///         diameter
    void step(EnergyAccounting accounting = EnergyAccounting::off);

    /// Compresses the initial sample until the normal stress first reaches its imposed value. From
    /// then on, the servo keeps it, and bridges form.
    /// @return false if the solid fraction reaches 0.8 before
    /// @throws Interrupted if a stop is requested
    /// @throws SimulationError if the stress is not finite or an overlap exceeds half a grain
    ///         diameter
    bool compress(const std::stop_token& stop = {});

    const Grains& grains() const { return grains_; }
    const Cell& cell() const { return cell_; }
    const PairList& pairs() const { return pairs_; }
    const Material& material() const { return material_; }
    /// Returns the law of the bridges with the changes by effects.
    const BridgeLaw& bridges() const { return bridges_; }
    const GrainEffects& effects() const { return effects_; }
    /// Returns the stress in the last time step, computed from the positions before the step.
    const Stress& stress() const { return stress_; }
    const Flow& flow() const { return flow_; }
    double shear_rate() const { return flow_.shear_rate; }
    /// Returns the energies stored, and those lost in the last time step; zero without energy
    /// accounting.
    const PairEnergy& energy() const { return energy_; }
    /// Returns the kinetic energy of all grains in reduced units, without the imposed flow, half a
    /// time step after the last computation of the forces.
    double kinetic_energy() const { return motion_.energy(); }
    double strain() const { return strain_; }
    double time_step() const { return time_step_; }
    std::uint64_t steps() const { return steps_; }
    double solid_fraction() const;

    /// Sets the imposed velocity gradient. If the servo is on, it continues to adjust
    /// `height_rate`.
    void set_flow(const Flow& flow) { flow_ = flow; }
    /// Switches the servo on or off.
    void hold_normal_stress(bool held) { servo_ = held; }
    /// Switches the formation of bridges at contact on or off.
    void let_bridges_form(bool form) { bridging_ = form; }
    /// Replaces `time_step_fraction`, for tests of convergence.
    void set_time_step_fraction(double fraction) { fraction_ = fraction; }

    /// Saves or loads the state. The loading object must have the number of grains, material,
    /// bridge law, effects and number of threads (`parts`) of the saved one.
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
    /// Adds the forces of the pairs of one share to `net_forces`, and returns the sums over these
    /// pairs. If `moved` is given, each grain of the share is also moved once the forces on it are
    /// complete, and its kinetic energy and similar terms are added to `moved`.
    PairSums sum_forces(const Share& share, std::vector<Grains::ForceAndTorque>& net_forces,
                        const PairLaws& laws, MotionSums* moved = nullptr);
    /// Adds the forces that other threads summed for the grains of thread `part` to the net forces
    /// on them, and sets these sums to zero.
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
    std::size_t shares_made_at_ = 0;  ///< PairList::renewals when `shares_` were made
    /// For each thread except the first, its sums of forces and torques on each grain.
    std::vector<std::vector<Grains::ForceAndTorque>> other_net_forces_;
    Stress stress_;
    PairEnergy energy_;
    MotionSums motion_;
    bool servo_ = false, bridging_ = false;
    double fraction_ = time_step_fraction;
    double bead_volume_ = 0;
    double time_step_ = 0;
    double strain_ = 0;
    double largest_overlap_ = 0;  ///< in the last time step
    /// Largest overlap since `time_step_` was last updated, but at least that at a normal force of
    /// 0.1.
    double recent_overlap_ = 0;
    std::uint64_t steps_ = 0;
};

}  // namespace pendular::dem
