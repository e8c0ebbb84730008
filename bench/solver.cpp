// Speed of the solver in bead-steps per second, for steady shear at friction 0.09, inertial number
// 0.003, stiffness number 1000: dry, and with bridges at P* = 2, V0 = 0.004 a^3, by number of beads
// and of threads, with the memory a bead takes.
#include <benchmark/benchmark.h>
#include <sys/resource.h>

#include <cmath>
#include <cstddef>

#include "sim/dem/shear_cell.h"

using namespace pendular::dem;

namespace {

/// Largest resident memory of the process so far [bytes].
double peak_memory() {
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    return 1024.0 * static_cast<double>(usage.ru_maxrss);
}

constexpr Material material{.modulus = 31622.8, .friction = 0.09};  // stiffness number 1000
constexpr double shear_rate = 0.003, settling_strain = 0.3;
constexpr int most_settled = 4000;  ///< beads

/// The sample beside its own images, `count` times in every direction.
Sample tiled(const ShearCell& sample, int count) {
    const Cell& cell = sample.cell();
    const Grains& grains = sample.grains();
    Sample tiles{
        Grains(grains.size() * static_cast<std::size_t>(count * count * count)),
        {count * cell.length, count * cell.height, count * cell.width, count * cell.offset}};
    std::size_t to = 0;
    for (int tile = 0; tile < count * count * count; ++tile) {
        const Vector shift =
            Image{tile % count, tile / count % count, tile / count / count}.shift(cell);
        for (const Grains::Motion& bead : grains.motion) {
            tiles.grains.motion[to] = bead;
            tiles.grains.motion[to++].position += shift;
        }
    }
    return tiles;
}

/// A sample in steady flow. Large ones are tiles of a smaller one, as they would take hours.
ShearCell steady_sample(int grains, const BridgeLaw& bridges, int threads) {
    const int tiles = static_cast<int>(std::ceil(std::cbrt(1.0 * grains / most_settled)));
    const int small = grains / (tiles * tiles * tiles);
    ShearCell sample(small, material, shear_rate, 1, bridges, tiles > 1 ? 1 : threads);
    sample.compress();
    while (sample.strain() < settling_strain) {
        sample.step();
    }
    if (tiles == 1) {
        return sample;
    }
    ShearCell large(tiled(sample, tiles), material, sample.flow(), bridges, threads);
    large.hold_normal_stress(true);
    for (int step = 0; step < 100; ++step) {  // the tangential forces return
        large.step();
    }
    return large;
}

void shear_step(benchmark::State& state, const BridgeLaw& bridges) {
    const int grains = static_cast<int>(state.range(0)), threads = static_cast<int>(state.range(1));
    const double before = peak_memory();
    ShearCell sample = steady_sample(grains, bridges, threads);
    for (auto _ : state) {
        sample.step();
    }
    state.counters["bead-steps/s"] =
        benchmark::Counter(static_cast<double>(state.iterations() * sample.grains().size()),
                           benchmark::Counter::kIsRate);
    if (const double grown = peak_memory() - before; grown > 1e8) {  // else it was there already
        state.counters["bytes/bead"] = grown / static_cast<double>(sample.grains().size());
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
    ->ArgsProduct({{1000, 4000}, {1}})
    ->Args({4000, 2})
    ->Unit(benchmark::kMicrosecond)
    ->UseRealTime();
