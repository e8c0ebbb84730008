#include <cmath>
#include <numbers>

#include "sim/catalogue/effect.h"
#include "sim/dem/bridge_law.h"

namespace pendular {
namespace {

/// Gap [diameters] below which roughness drains the liquid: 5 um on beads of 500 um. It is added to
/// the gap and thereby limits the force.
constexpr double roughness = 0.01;

/// Returns the force over the speed of approach of two spheres that a bridge joins. It is the
/// normal lubrication coefficient of fully immersed spheres, 3 pi eta R^2/(2 h) with Derjaguin's
/// radius R, times (1 - h/He)^2, the force of the bridge over that of an unbounded film; 1 - h/He
/// is the relative capillary force of the bridge.
double coefficient(double viscosity, double radius, double gap, double relative_force) {
    return 1.5 * std::numbers::pi * viscosity * radius * radius / (gap + roughness) *
           relative_force * relative_force;
}

void lubrication(const dem::PairBatch& batch, const dem::PairContext& context) {
    const double viscosity = context.values["viscosity"];
    for (std::size_t k = 0; k < batch.size; ++k) {
        if (batch.joined[k] == 0) {
            continue;
        }
        const double gap = std::max(0.0, batch.gap[k]);
        const double force = -batch.normal_speed[k] *
                             coefficient(viscosity, batch.diameter[k] / 2, gap,
                                         context.bridges.of(batch.diameter[k]).relative_force(gap));
        batch.fx[k] += force * batch.nx[k];
        batch.fy[k] += force * batch.ny[k];
        batch.fz[k] += force * batch.nz[k];
    }
}

}  // namespace

/// A liquid bridge resists both approach and parting of its beads. The viscous stress is
/// proportional to the shear rate, not to the inertial number: at the same I it is larger at higher
/// normal stress.
Effect viscous_bridges() {
    return {
        .summary =
            "the viscosity of the liquid resists the relative motion of grains that a bridge joins",
        .equation =
            "F = -(3/2) pi viscosity R^2 X^2 v/(h + 0.01 a),  X = 1 - h/sqrt(h^2 + 4 V0/(pi a)),\n"
            "v the speed at which the gap h opens",
        .parameters = {{.name = "viscosity",
                        .unit = "Pa s",
                        .lower = 0,
                        .upper = 0.5,
                        .neutral = 0,
                        // Chosen: twenty times the viscosity of water.
                        .smallest_of_interest = 0.02,
                        .meaning = "viscosity of the liquid"}},
        .change = dem::ChangePairs{.add = lubrication,
                                   .damping_rate =
                                       [](const dem::BridgeLaw&, const Values& v) {
                                           return coefficient(v["viscosity"], 0.5, 0, 1);
                                       }},
        .touches = Touches::wet,
        .acts_through = {"shear_rate", "inertial_number", "liquid_content"},
        .directly = "a viscometer",
        .references = {
            "Pitois, Moucheront, Chateau, J. Colloid Interface Sci. 231 (2000) 26",
            "Cameron, The Principles of Lubrication (1966), for spheres fully immersed"}};
}

}  // namespace pendular
