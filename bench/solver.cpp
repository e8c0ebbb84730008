// Speed of the solver on one core, in bead-steps per second, for steady shear at friction 0.09,
// inertial number 0.003, stiffness number 1000: dry, and with bridges at P* = 2, V0 = 0.004 a^3.
#include <benchmark/benchmark.h>

#include <cmath>

#include "sim/dem/shear_cell.h"

using namespace pendular::dem;

namespace {

void shear_step(benchmark::State& state, const BridgeLaw& bridges) {
    const int beads = static_cast<int>(state.range(0));
    ShearCell sample(beads, {.modulus = std::pow(1000.0, 1.5), .friction = 0.09}, 0.003, 1,
                     bridges);
    sample.compress();
    for (int step = 0; step < 3000; ++step) {  // until contacts are those of a jammed sample
        sample.step();
    }
    for (auto _ : state) {
        sample.step();
    }
    state.counters["bead-steps/s"] = benchmark::Counter(
        static_cast<double>(state.iterations()) * beads, benchmark::Counter::kIsRate);
}

}  // namespace

BENCHMARK_CAPTURE(shear_step, dry, BridgeLaw())
    ->Arg(1000)
    ->Arg(4000)
    ->Arg(16000)
    ->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(shear_step, wet, BridgeLaw({.reduced_pressure = 2, .bridge_volume = 4e-3}))
    ->Arg(1000)
    ->Arg(4000)
    ->Arg(16000)
    ->Unit(benchmark::kMicrosecond);
