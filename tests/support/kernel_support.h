#pragma once

#include <cstdint>
#include <random>
#include <string>
#include <vector>

#include "calib/emulator/kernel.h"

namespace pendular {

/// Returns the name of a domain for use in the name of a test. A domain is a kind of emulated
/// quantity, by its behaviour for dry grains.
inline std::string name_of(Domain domain) {
    return domain == Domain::all_flow   ? "AllFlow"
           : domain == Domain::contacts ? "Contacts"
                                        : "Bridges";
}

/// Returns hyperparameters of a kernel that all have different values, so that a test fails if the
/// kernel confuses two hyperparameters.
inline Hyperparameters uneven_hyperparameters() {
    return {.dry_amplitude = 0.3,
            .dry_x = 0.7,
            .dry_q = 0.25,
            .wet_amplitude = 0.2,
            .wet_x = 1.1,
            .wet_q = 0.4,
            .wet_u = 0.9,
            .wet_v = 1.3,
            .noise = 1.2,
            .between_run_scatter = 0.01};
}

/// Returns `count` random coordinates of wet states, spread over the range of the emulator.
inline std::vector<Coordinates> scattered_places(std::size_t count, std::uint64_t seed) {
    std::mt19937_64 random(seed);
    std::uniform_real_distribution<double> uniform;
    std::vector<Coordinates> places;
    for (std::size_t k = 0; k < count; ++k) {
        const double x = 2 * uniform(random) - 1, q = 0.5 * uniform(random);
        const double u = 0.05 + uniform(random), v = 2 * uniform(random) - 1;
        places.push_back({.x = x, .q = q, .u = u, .v = v});
    }
    return places;
}

/// Returns the coordinates `at` of a state, with one coordinate increased by `by`.
/// @param coordinate the coordinate to increase: 0, x; 1, q; 2, u; 3, v
inline Coordinates moved(Coordinates at, int coordinate, double by) {
    double* const all[] = {&at.x, &at.q, &at.u, &at.v};
    *all[coordinate] += by;
    return at;
}

/// Returns the inputs (prepared functionals) from which a kernel computes covariances. For each
/// state in `places`, they are the value of the function and then its derivative with respect to
/// each coordinate.
inline std::vector<Kernel::Prepared> prepared_with_derivatives(
    const Kernel& kernel, const std::vector<Coordinates>& places) {
    std::vector<Kernel::Prepared> prepared;
    for (const Coordinates& at : places) {
        for (int derivative = Functional::value; derivative < coordinate_count; ++derivative) {
            prepared.push_back(kernel.prepare({at, derivative}));
        }
    }
    return prepared;
}

}  // namespace pendular
