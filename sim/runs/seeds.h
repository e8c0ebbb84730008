#pragma once

#include <cstdint>

namespace pendular {

/// Purpose of random numbers. Each purpose has its own seeds: a calibration whose runs started from
/// the same samples as its measurement would test nothing.
enum class SeedDomain : std::uint64_t { calibration, instrument, virtual_lab, run_places };

/// Seed of one of many runs, well mixed from the user's seed and the run's number.
///     z = seed x A + (run + 1) x B + domain x 2^62 (mod 2^64), A and B odd, then the finalizer of
///     splitmix64, which maps no two z to the same seed
/// At equal `seed`, runs of one domain never share a seed, and runs of two domains could only where
/// their numbers differ by a multiple of 2^62: B being odd, B n = k 2^62 demands n = k' 2^62.
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
