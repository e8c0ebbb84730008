#include "sim/dem/observables.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <stdexcept>

namespace pendular::dem {

namespace {

/// Grains that an observable says something of.
enum class Grains { all, wet };

constexpr Grains grains_of[] = {
#define OBSERVABLE(name, symbol, unit, grains, ...) Grains::grains,
#include "data/quantities/observables.def"
};

}  // namespace

bool needs_bridges(Observable which) {
    return grains_of[static_cast<std::size_t>(which)] == Grains::wet;
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
