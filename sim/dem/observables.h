#pragma once

#include <array>
#include <cstddef>
#include <string_view>

namespace pendular::dem {

/// Quantity that a run averages over time, such as the stress ratio: all those of the table
/// data/quantities/observables.def. Observables of bridges are zero in runs with dry grains.
enum class Observable {
#define OBSERVABLE(name, ...) name,
#include "data/quantities/observables.def"
};

/// Names in JSON and in files of runs, in the order of `Observable`.
constexpr std::array observable_names = std::to_array<std::string_view>({
#define OBSERVABLE(name, ...) #name,
#include "data/quantities/observables.def"
});
constexpr std::size_t observable_count = observable_names.size();

/// Whether an observable is a property of bridges.
bool needs_bridges(Observable which);

/// Returns the observable of a given name.
/// @throws std::invalid_argument for an unknown name; the message lists all names
Observable observable_named(std::string_view name);

}  // namespace pendular::dem
