#pragma once

#include <cstdint>
#include <stop_token>

#include "sim/dem/beads.h"
#include "sim/dem/bridge_law.h"
#include "sim/dem/cell.h"
#include "sim/dem/pair_forces.h"
#include "sim/dem/pair_list.h"

namespace pendular::dem {

/// Stress over the imposed normal stress [1]; compression positive, pair forces plus kinetic term.
struct Stress {
    double s11 = 0, s22 = 0, s33 = 0, s12 = 0;
};

/// A sample in simple shear between Lees-Edwards images at a constant rate, its height free so that
/// s22 stays at 1. Reduced units: bead diameter, mass and imposed normal stress are 1, so that the
/// shear rate is the inertial number.
///
/// Height servo, first order: (dH/dt)/H = (s22 - 1)/(B t0), with B = 0.05 kappa, well below
/// the packing's modulus at stiffness number kappa, and t0 = sqrt(m/(a s22)), the time a bead needs
/// to move its own size. The stress then returns to its target within a fraction of t0 at every
/// stiffness and nothing is left to tune; as ln H is bounded, the time average of s22 is 1 exactly.
///
/// Time step: a fixed fraction of sqrt(m/K_N) of the stiffest contact, followed as it changes; less
/// where the damping is more than critical.
class ShearCell {
  public:
    /// `count` beads at random, without contact, at solid fraction 0.3 and at rest. Bridges form
    /// from the end of `compress` on.
    /// @throws std::invalid_argument for fewer than `fewest_beads`
    ShearCell(int count, const Material& material, double shear_rate, std::uint64_t seed,
              const BridgeLaw& bridges = {});

    /// Edge of the cube that so many beads fill once they flow [diameters].
    static double edge(int count);

    static constexpr int fewest_beads = 64;
    static constexpr double time_step_fraction = 0.2;

    /// One step of the leapfrog: forces at x(t) from v(t - dt/2), then velocities, then positions.
    /// @throws SimulationError where the state is no longer finite
    void step();

    /// Closes the gaps of the initial state at a constant rate until s22 first reaches its target.
    /// @return false where it was not reached before the beads would fill the cell
    /// @throws Interrupted when a stop is requested
    bool compress(const std::stop_token& stop = {});

    const Beads& beads() const { return beads_; }
    const Cell& cell() const { return cell_; }
    const PairList& pairs() const { return pairs_; }
    const Material& material() const { return material_; }
    const BridgeLaw& bridges() const { return bridges_; }
    const Stress& stress() const { return stress_; }
    double shear_rate() const { return flow_.shear_rate; }
    double strain() const { return strain_; }
    double time_step() const { return time_step_; }
    std::uint64_t steps() const { return steps_; }
    double solid_fraction() const;

    /// Makes the time step this fraction of sqrt(m/K_N) instead of the standard one, for tests of
    /// convergence.
    void set_time_step_fraction(double fraction) { fraction_ = fraction; }

  private:
    void place_at_random(std::uint64_t seed);
    void check_state() const;
    void measure_stress(const PairSums& sums);
    void advance();
    void follow_stiffest_contact();

    Beads beads_;
    Cell cell_;
    PairList pairs_;
    Material material_;
    BridgeLaw bridges_;
    Flow flow_;
    Stress stress_;
    bool servo_ = false;
    double fraction_ = time_step_fraction;
    double time_step_ = 0;
    double strain_ = 0;
    double largest_overlap_ = 0;  ///< of the last step
    double recent_overlap_ = 0;   ///< largest since the time step was last reconsidered
    std::uint64_t steps_ = 0;
};

}  // namespace pendular::dem
