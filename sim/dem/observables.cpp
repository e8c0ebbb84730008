#include "sim/dem/observables.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <stdexcept>

namespace pendular::dem {

namespace {

/// Kind of grains for which an observable is defined: all grains, or only grains with liquid
/// bridges.
enum class Wetness { all, wet };

constexpr Wetness grains_of[] = {
#define OBSERVABLE(name, symbol, unit, grains, ...) Wetness::grains,
#include "data/quantities/observables.def"
};

}  // namespace

bool needs_bridges(Observable which) {
    return grains_of[static_cast<std::size_t>(which)] == Wetness::wet;
}

Observable observable_named(std::string_view name) {
    const auto found = std::ranges::find(observable_names, name);
    if (found == observable_names.end()) {
        throw std::invalid_argument(fmt::format("unknown observable '{}'; use one of {}", name,
                                                fmt::join(observable_names, ", ")));
    }
    return static_cast<Observable>(found - observable_names.begin());
}

}  // namespace pendular::dem
