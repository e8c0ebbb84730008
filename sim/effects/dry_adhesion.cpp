#include "sim/catalogue/effect.h"

namespace pendular {
namespace {

void pull(const dem::PairBatch& batch, const dem::PairContext& context) {
    const double force = context.values["force"];
    for (std::size_t k = 0; k < batch.size; ++k) {
        if (batch.gap[k] >= 0 || batch.joined[k] > 0) {
            continue;
        }
        batch.fx[k] -= force * batch.diameter[k] * batch.nx[k];
        batch.fy[k] -= force * batch.diameter[k] * batch.ny[k];
        batch.fz[k] -= force * batch.diameter[k] * batch.nz[k];
    }
}

}  // namespace

/// Van der Waals or electrostatic attraction of touching beads, which gives dry beads a cohesion.
/// In the limit of stiff beads (Derjaguin, Muller and Toporov) the attraction equals the pull-off
/// force while the beads touch; its range of nanometres is negligible. The pull-off force is
/// proportional to the radius. In a contact filled with liquid the attraction is about ten times
/// weaker, by the ratio of Hamaker constants, and is neglected: the effect acts only in contacts
/// without a bridge.
Effect dry_adhesion() {
    return {.summary = "dry grains in contact attract each other",
            .equation = "F_N -> F_N - force  in contacts without a bridge",
            .parameters = {{.name = "force",
                            .unit = "N",
                            .lower = 0,
                            .upper = 1e-4,
                            .neutral = 0,
                            // Chosen: a tenth of F0 of silicone oil on beads of 500 um.
                            .smallest_of_interest = 3e-6,
                            .meaning = "pull-off force of two equal grains"}},
            .change = dem::ChangePairs{.add = pull},
            .touches = Touches::dry,
            .acts_through = {"1/normal_stress"},
            .references = {"Derjaguin, Muller, Toporov, J. Colloid Interface Sci. 53 (1975) 314",
                           "Israelachvili, Intermolecular and Surface Forces (2011), chapter 13"}};
}

}  // namespace pendular
