#pragma once

#include <array>
#include <cstddef>
#include <string_view>

namespace pendular::dem {

/// Quantities that a run measures, as listed in data/quantities/observables.def. Capillary
/// observables are zero in dry runs.
enum class Observable {
#define OBSERVABLE(name, ...) name,
#include "data/quantities/observables.def"
};

/// Names of all observables in their order, as JSON and stores have them.
constexpr std::array observable_names = std::to_array<std::string_view>({
#define OBSERVABLE(name, ...) #name,
#include "data/quantities/observables.def"
});
constexpr std::size_t observable_count = observable_names.size();

/// Whether an observable exists for wet grains only.
bool needs_bridges(Observable which);

/// Observable with this name in `observable_names`.
/// @throws std::invalid_argument naming those there are
Observable observable_named(std::string_view name);

}  // namespace pendular::dem
