// Speed of the solver in bead-steps per second, for steady shear at friction 0.09, inertial number
// 0.003, stiffness number 1000: dry, with bridges at P* = 2, V0 = 0.004 a^3, by number of beads and
// of threads, with the memory a bead takes.
#include <benchmark/benchmark.h>
#include <sys/resource.h>

#include <algorithm>
#include <cmath>

#include "sim/dem/shear_cell.h"

using namespace pendular::dem;

namespace {

/// Largest resident memory of the process so far [bytes].
double peak_memory() {
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    return 1024.0 * static_cast<double>(usage.ru_maxrss);
}

void shear_step(benchmark::State& state, const BridgeLaw& bridges) {
    const int beads = static_cast<int>(state.range(0)), threads = static_cast<int>(state.range(1));
    const double before = peak_memory();
    ShearCell sample(beads, {.modulus = std::pow(1000.0, 1.5), .friction = 0.09}, 0.003, 1, bridges,
                     threads);
    sample.compress();
    // Until contacts are those of a jammed sample; large ones, which take long, are near it
    // already.
    const int settling = std::clamp(12'000'000 / beads, 300, 3000);
    for (int step = 0; step < settling; ++step) {
        sample.step();
    }
    for (auto _ : state) {
        sample.step();
    }
    state.counters["bead-steps/s"] = benchmark::Counter(
        static_cast<double>(state.iterations()) * beads, benchmark::Counter::kIsRate);
    if (const double grown = peak_memory() - before; grown > 1e8) {  // else it was there already
        state.counters["bytes/bead"] = grown / beads;
    }
}

}  // namespace

BENCHMARK_CAPTURE(shear_step, dry, BridgeLaw())
    ->ArgNames({"beads", "threads"})
    ->ArgsProduct({{1000, 4000, 16000, 125000}, {1}})
    ->Args({4000, 2})
    ->Args({1000000, 1})
    ->Unit(benchmark::kMicrosecond)
    ->UseRealTime();
BENCHMARK_CAPTURE(shear_step, wet, BridgeLaw({.reduced_pressure = 2, .bridge_volume = 4e-3}))
    ->ArgNames({"beads", "threads"})
    ->ArgsProduct({{1000, 4000, 16000}, {1}})
    ->Args({4000, 2})
    ->Unit(benchmark::kMicrosecond)
    ->UseRealTime();
