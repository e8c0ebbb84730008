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

/// Mean stress in a sample over the imposed normal stress [1], from the forces between grains plus
/// the kinetic term of their velocity fluctuations; compression positive.
struct Stress {
    double s11 = 0, s22 = 0, s33 = 0, s12 = 0;

    template <typename Archive>
    void serialize(Archive& archive) {
        archive(s11, s22, s33, s12);
    }
};

/// Grains and the periodic cell that contains them.
struct Sample {
    Grains grains;
    Cell cell;
};

/// Returns `count` grains at rest at random positions, without contact, at solid fraction 0.3. The
/// cell is tall and becomes a cube once the grains flow. `diameters` are over their mean [1];
/// empty: all are 1.
/// @throws std::invalid_argument for fewer than 64 grains
Sample random_gas(int count, std::uint64_t seed, const std::vector<double>& diameters = {});

/// Simulation of a sample in simple shear at a constant rate between Lees-Edwards images. A servo
/// changes the height of the cell so that s22 stays at 1. Reduced units: grain diameter, mass and
/// imposed normal stress are 1, so that the shear rate is the inertial number.
///
/// Height servo, first order: (dH/dt)/H = (s22 - 1)/(B t0), with B = 0.05 kappa, well below
/// the packing's modulus at stiffness number kappa, and t0 = sqrt(m/(a s22)), the time a grain
/// needs to move its own size. The stress then returns to its target within a fraction of t0 at
/// every stiffness, without tuning. As ln H is bounded, the time average of s22 is 1 exactly.
///
/// Time step: a fixed fraction of sqrt(m/K_N) of the stiffest contact, updated as that contact
/// changes; smaller where the damping is more than critical.
class ShearCell {
  public:
    /// Starts from a random gas of `count` grains, sheared at the rate `shear_rate` (the inertial
    /// number). Bridges form from the end of `compress` on. Each time step is divided among `parts`
    /// threads. Forces are summed part by part, so that runs with the same number of parts agree
    /// bit for bit.
    /// @throws std::invalid_argument for fewer than 64 grains
    ShearCell(int count, const Material& material, double shear_rate, std::uint64_t seed,
              const BridgeLaw& bridges = {}, int parts = 1, const GrainEffects& effects = {});
    /// Starts from a given sample in a given uniform flow. The servo does not hold its normal
    /// stress until `hold_normal_stress(true)`, and no bridges form until `let_bridges_form(true)`.
    ShearCell(Sample sample, const Material& material, const Flow& flow,
              const BridgeLaw& bridges = {}, int parts = 1, const GrainEffects& effects = {});

    /// Edge of the cube that `count` grains fill once they flow [diameters].
    static double edge(int count);

    static constexpr int fewest_grains = 64;
    static constexpr double time_step_fraction = 0.2;

    /// Advances the sample by one leapfrog step of length dt: forces from the positions at t and
    /// the velocities at t - dt/2, then velocities, then positions, then the cell.
    /// @throws SimulationError where the stress is not finite or an overlap exceeds half a diameter
    void step(EnergyAccounting accounting = EnergyAccounting::off);

    /// Lowers the height of the initial random gas at a constant rate until s22 first reaches 1;
    /// from then on the servo holds s22, and bridges form.
    /// s22 is the normal stress across the height over its imposed value.
    /// @return false where the solid fraction reaches 0.8 before s22 reaches 1
    /// @throws Interrupted when a stop is requested; SimulationError where `step` does
    bool compress(const std::stop_token& stop = {});

    const Grains& grains() const { return grains_; }
    const Cell& cell() const { return cell_; }
    const PairList& pairs() const { return pairs_; }
    const Material& material() const { return material_; }
    /// Law of the liquid bridges, with the changes that effects on grains make to it.
    const BridgeLaw& bridges() const { return bridges_; }
    const GrainEffects& effects() const { return effects_; }
    /// Mean stress of the sample in the last time step, over the imposed normal stress [1], from
    /// the forces at the beginning of that step.
    const Stress& stress() const { return stress_; }
    const Flow& flow() const { return flow_; }
    double shear_rate() const { return flow_.shear_rate; }
    /// Energies that pairs of grains stored, and lost, in the last step [a^3 s22]; zero if that
    /// step was made without energy accounting.
    const PairEnergy& energy() const { return energy_; }
    /// Kinetic energy of all grains, of their peculiar motion (without the imposed flow) and their
    /// rotation, half a time step after the last forces [a^3 s22].
    double kinetic_energy() const { return motion_.energy(); }
    double strain() const { return strain_; }
    double time_step() const { return time_step_; }
    std::uint64_t steps() const { return steps_; }
    double solid_fraction() const;

    /// Sets the imposed flow. While the normal stress is held, the servo changes the height rate.
    void set_flow(const Flow& flow) { flow_ = flow; }
    /// Switches on or off the servo that holds the normal stress s22 at its imposed value, 1, by
    /// changing the height of the cell.
    void hold_normal_stress(bool held) { servo_ = held; }
    /// Switches on or off the liquid bridges, which form on contact.
    void let_bridges_form(bool form) { bridging_ = form; }
    /// Sets the time step to this fraction of sqrt(m/K_N) instead of `time_step_fraction`, for
    /// tests of convergence; m: grain mass, K_N: normal stiffness of the stiffest contact.
    void set_time_step_fraction(double fraction) { fraction_ = fraction; }

    /// Saves or loads the state. A state can be loaded only into a ShearCell with the same number
    /// of grains, the same laws and the same number of parts.
    template <typename Archive>
    void serialize(Archive& archive) {
        archive(grains_, cell_, pairs_, flow_, stress_, motion_, servo_, bridging_, fraction_,
                time_step_, strain_, largest_overlap_, recent_overlap_, steps_);
        shares_made_at_ = 0;  // the shares were made for other lists
    }

  private:
    void adjust_height_rate();
    void check_state() const;
    PairSums sum_forces(const PairLaws& laws);
    /// Adds the forces of the pairs of one share to `net_forces`. If `moved` is given, also moves
    /// each grain of the share after its last pair and adds to `moved`.
    PairSums sum_forces(const Share& share, std::vector<Grains::ForceAndTorque>& net_forces,
                        const PairLaws& laws, MotionSums* moved = nullptr);
    /// Adds to the net forces on the grains of thread `part` the forces that other threads summed
    /// for these grains, and sets the sums of the other threads to zero.
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
    std::size_t shares_made_at_ = 0;  ///< value of PairList::renewals when `shares_` were made
    /// Net forces on the grains as summed by each thread after the first.
    std::vector<std::vector<Grains::ForceAndTorque>> other_net_forces_;
    Stress stress_;
    PairEnergy energy_;
    MotionSums motion_;
    bool servo_ = false, bridging_ = false;
    double fraction_ = time_step_fraction;
    double bead_volume_ = 0;
    double time_step_ = 0;
    double strain_ = 0;
    double largest_overlap_ = 0;  ///< largest overlap of contacts in the last step [diameters]
    double recent_overlap_ = 0;   ///< largest overlap since `time_step_` was updated [diameters]
    std::uint64_t steps_ = 0;
};

}  // namespace pendular::dem
