// Oblique impacts of two grains that do not angular velocity, against closed forms. The grains are
// so stiff that the contact hardly turns while it lasts.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "sim/dem/shear_cell.h"

namespace impacts_test {

using namespace pendular::dem;

constexpr double modulus = 1e9, friction = 0.2, approach = 0.1;

/// Two grains that meet along direction 1 with a relative velocity (-approach, tangential, 0).
class Impact {
  public:
    Impact(double tangential, double damping)
        : cell_(before(tangential), {.modulus = modulus, .friction = friction, .damping = damping},
                Flow{}) {
        cell_.set_time_step_fraction(1e-3);
    }
    void step() { cell_.step(); }
    void until_parted() {
        do {
            step();
        } while (overlap() == 0);
        while (overlap() > 0) {
            step();
        }
    }
    double overlap() const { return std::pow(cell_.pairs().narrow().root[0], 2); }
    double elastic() const { return Hertz::at(overlap(), modulus).elastic; }
    /// Tangential force that slows the second grain down.
    double tangential_force() const {
        const Pairs& pairs = cell_.pairs().narrow();
        return cell_.grains().number[static_cast<std::size_t>(pairs.second[0])] == 1 ? -pairs.sy[0]
                                                                                     : pairs.sy[0];
    }
    /// Velocity of the second grain relative to the first.
    Vector velocity() const { return motion(1).velocity - motion(0).velocity; }
    double angular_velocity(int grain) const { return motion(grain).angular_velocity[2]; }

  private:
    static Sample before(double tangential) {
        const double gap = 1e-3;  // they meet where the normal points along direction 1
        Sample sample{Grains(2), {20, 20, 20, 0}};
        sample.grains.position(0) = {9.5, 10, 10};
        sample.grains.position(1) = {10.5 + gap, 10 - tangential * gap / approach, 10};
        sample.grains.velocity(0) = {0.5 * approach, -0.5 * tangential, 0};
        sample.grains.velocity(1) = {-0.5 * approach, 0.5 * tangential, 0};
        return sample;
    }
    const Grains::Motion& motion(int grain) const {
        return cell_.grains().motion[cell_.grains().number[0] == grain ? 0 : 1];
    }
    ShearCell cell_;
};

/// e = exp(-pi z/sqrt(1 - z^2)), z = zeta sqrt(6/5).
double restitution(double damping) {
    const double z = damping * std::sqrt(1.2);
    return std::exp(-std::numbers::pi * z / std::sqrt(1 - z * z));
}

TEST(ObliqueImpact, SlidesThroughoutWithTheImpulseOfCoulomb) {
    // The viscous force is a function of h times dh/dt: over a whole impact its impulse vanishes,
    // so that the elastic force alone carries (1 + e) v/2 and friction mu times that. Both grains
    // angular velocity up alike, by the impulse times 1/2 over the moment of inertia 1/10.
    // The contact turns by 0.3 x 1.5e-3 while it lasts, which is 0.5 % of a speed of 0.1.
    for (const double damping : {0.0, 0.1, 0.3}) {
        const double tangential = 0.3, e = restitution(damping);
        Impact impact(tangential, damping);
        impact.until_parted();
        const double impulse = friction * (1 + e) * approach / 2;
        EXPECT_NEAR(impact.velocity()[0], e * approach, 5e-3 * approach) << damping;
        EXPECT_NEAR(tangential - impact.velocity()[1], 2 * impulse, 5e-3 * 2 * impulse) << damping;
        for (const int grain : {0, 1}) {
            EXPECT_NEAR(impact.angular_velocity(grain), impulse * 0.5 / 0.1, 5e-3 * 5 * impulse)
                << damping;
        }
        // Sliding to the end: the surfaces still move on, by u - 7 J of u.
        EXPECT_GT(
            impact.velocity()[1] - 0.5 * (impact.angular_velocity(0) + impact.angular_velocity(1)),
            0.5 * tangential);
    }
}

TEST(ObliqueImpact, SticksBelowTheSlopeThatMindlinAndCoulombSet) {
    // While approach and sliding speed hardly change, F_T = K_T/K_N (u/v) F_N, until that is
    // mu F_N: u/v = mu (2 - nu)/(2 - 2 nu) is where sticking ends.
    const double ratio = (2 - 2 * 0.3) / (2 - 0.3);
    const double deepest = std::pow(5 * 0.5 * approach * approach / (4 * modulus / 3), 0.4);
    for (const double part : {0.3, 0.9, 0.98, 1.02, 1.1, 3.0}) {
        Impact impact(part * friction / ratio * approach, 0);
        while (impact.overlap() < 0.1 * deepest) {  // 0.3 % of the energy is in the spring by then
            impact.step();
        }
        EXPECT_NEAR(impact.tangential_force() / impact.elastic(), friction * std::min(part, 1.0),
                    0.01 * friction)
            << part;
    }
}

TEST(ObliqueImpact, RollsOffWhereItStuck) {
    // Sliding friction would reverse the surfaces' motion, 7 times the impulse of Coulomb being
    // more than there is: the contact sticks, and gives back less than it would by sliding.
    const double tangential = 0.02;
    Impact impact(tangential, 0);
    impact.until_parted();
    const double change = tangential - impact.velocity()[1];
    EXPECT_GT(change, 0);
    EXPECT_LT(change, 0.9 * friction * 2 * approach);
    // Angular momentum about the point of contact: what the centres lose the angular velocities
    // have.
    EXPECT_NEAR(impact.angular_velocity(0), 2.5 * change, 5e-3 * 2.5 * change);
}

}  // namespace impacts_test
