#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace pendular {

/// Named set of simulation settings that balances accuracy against computing time.
struct Fidelity {
    std::string name;  ///< "quick", "standard" or "paper"
    int grains = 0;
    double stiffness_number = 0;  ///< [1]
    /// Lowest inertial number that is simulated [1]; predictions below are extrapolated.
    double lowest_inertial_number = 0;
    double strain = 0;  ///< over which each simulation of a study is averaged [1]
};

/// Returns the settings named "quick", "standard" or "paper".
/// @throws InputError for any other name; the message lists the three names
Fidelity fidelity_named(std::string_view name);

/// Returns all sets of settings in the order of increasing computing time.
const std::vector<Fidelity>& fidelities();

/// Purpose for which random numbers are drawn. Seeds for different purposes differ, so that a
/// calibration can be tested on a virtual measurement without using its initial samples.
/// `run_places` is the choice of the parameters of calibration runs.
enum class SeedDomain : std::uint64_t { calibration, instrument, virtual_lab, run_places };

/// Returns the seed of run number `run`, counted from 0.
///     z = seed x A + (run + 1) x B + domain x 2^62 (mod 2^64),  A and B odd
/// The finalizer of splitmix64 then maps different z to different seeds. For one `seed`, two runs
/// of one purpose never have equal seeds, and two runs of different purposes only if their numbers
/// differ by a multiple of 2^62.
/// Source: Steele, Lea and Flood, OOPSLA (2014) 453, "Fast splittable pseudorandom number
/// generators".
constexpr std::uint64_t seed_of_run(std::uint64_t seed, std::uint64_t run,
                                    SeedDomain domain = SeedDomain::calibration) {
    std::uint64_t z = seed * 0x9E3779B97F4A7C15u + (run + 1) * 0xD1B54A32D192ED03u +
                      (static_cast<std::uint64_t>(domain) << 62);
    z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9u;
    z = (z ^ (z >> 27)) * 0x94D049BB133111EBu;
    return z ^ (z >> 31);
}

}  // namespace pendular
