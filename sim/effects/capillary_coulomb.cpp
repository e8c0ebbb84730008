#include <algorithm>

#include "sim/catalogue/effect.h"
#include "sim/dem/contact_law.h"

namespace pendular {
namespace {

void net_limit(const dem::PairBatch& batch, const dem::PairContext& context) {
    for (std::size_t k = 0; k < batch.size; ++k) {
        batch.coulomb_limit[k] =
            context.material.friction * std::max(0.0, batch.elastic[k] - batch.capillary[k]);
    }
}

}  // namespace

/// In the base law the Coulomb limit is proportional to the elastic force of the contact, which the
/// attraction of the bridge increases as an external load would. This effect makes it proportional
/// to the total normal force, elastic force less attraction. Lightly loaded contacts then slide
/// more easily, and capillary forces add no strength through the Coulomb limit.
Effect capillary_coulomb() {
    return {
        .summary =
            "the Coulomb limit of a contact is proportional to the net normal force (elastic minus "
            "capillary) instead of the elastic force alone",
        .equation = "|F_T| <= friction max(0, F_N - F_capillary)",
        .parameters = {on_switch(
            "the tangential force of a contact is at most the friction coefficient "
            "times the net normal force (elastic minus capillary), instead of "
            "times the elastic force alone")},
        .change = dem::ChangePairs{.limit = net_limit},
        .touches = Touches::wet,
        .fades_with_capillarity = true,
        .acts_through = {"1/reduced_pressure", "liquid_content"},
        .references = {
            "Badetti et al. (2018), section 2.2, for the limit on the elastic force",
            "Richefeu, El Youssoufi, Radjai, Phys. Rev. E 73 (2006) 051304: both limits"}};
}

}  // namespace pendular
