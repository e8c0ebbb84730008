#include "sim/dem/liquid_exchange.h"

#include <cmath>

namespace pendular::dem {
namespace {

/// Calls `use` with the grains i and j and the volume of each bridge that holds liquid.
void each_bridge(PairList& pairs, std::size_t volume, const auto& use) {
    for (Pairs* list : {&pairs.narrow(), &pairs.distant()}) {
        std::vector<double>& volumes = list->contact_history[volume];
        for (std::size_t k = 0; k < list->size(); ++k) {
            if (list->bridge[k] > 0 && volumes[k] != 0) {
                use(static_cast<std::size_t>(list->first[k]),
                    static_cast<std::size_t>(list->second[k]), volumes[k]);
            }
        }
    }
}

}  // namespace

void LiquidExchange::flow(PairList& pairs, std::size_t volume, std::size_t grains, double strain) {
    volumes_.assign(grains, 0);
    counts_.assign(grains, 0);
    each_bridge(pairs, volume, [&](std::size_t i, std::size_t j, double& v) {
        for (const std::size_t grain : {i, j}) {
            volumes_[grain] += std::abs(v);
            counts_[grain] += 1;
        }
    });
    const double share = -std::expm1(-strain);
    each_bridge(pairs, volume, [&](std::size_t i, std::size_t j, double& v) {
        const double wanted = (volumes_[i] / counts_[i] + volumes_[j] / counts_[j]) / 2;
        const double own = std::abs(v);  // the sign follows the order of the two grains
        v = std::copysign(own + share * (wanted - own), v);
    });
}

}  // namespace pendular::dem
