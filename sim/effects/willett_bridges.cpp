#include <array>
#include <cmath>

#include "sim/catalogue/effect.h"
#include "sim/dem/bridge_law.h"

namespace pendular {
namespace {

/// a0 + a1 x + a2 x^2 + a3 x^3.
double polynomial(const std::array<double, 4>& a, double x) {
    return a[0] + x * (a[1] + x * (a[2] + x * a[3]));
}

/// Returns the force of a bridge over 2 pi R Gamma [1] at contact angle 0, from half the gap over
/// the grain radius, S* = h/(2 R), and the volume V* = V/R^3:
///     F = exp(f1 - f2 exp(f3 ln S+ + f4 ln^2 S+)),   S+ = S*/sqrt(V*)
/// with polynomials f1..f4 in ln V*, fitted to solutions of the Laplace-Young equation for
/// 1e-5 < V* < 0.1. At zero gap the inner exponential vanishes.
/// Source: Willett, Adams, Johnson, Seville, Langmuir 16 (2000) 9396, eq. A1.
double relative_force(double half_gap, double volume) {
    const double log_volume = std::log(volume);
    const double f1 = polynomial({-0.44507, -0.1119, -0.012101, -0.0005}, log_volume);
    const double f2 = polynomial({1.9222, -0.0668, -0.0013375, 0}, log_volume);
    const double f3 = polynomial({1.268, 0.198, 0.02232, 0.0008585}, log_volume);
    const double f4 = polynomial({-0.010703, 0.03345, 0.0018574, 0}, log_volume);
    if (!(half_gap > 0)) {
        return std::exp(f1);
    }
    const double scaled = std::log(half_gap / std::sqrt(volume));
    return std::exp(f1 - f2 * std::exp(f3 * scaled + f4 * scaled * scaled));
}

/// Replaces the attraction of the bridges of a batch of pairs by Willett's force. The radius for
/// unequal grains is Derjaguin's, half their harmonic mean diameter. As in the base law, the
/// rupture distance is V0^(1/3) and a contact angle scales F0.
void willett(const dem::PairBatch& batch, const dem::PairContext& context) {
    const double bridge_volume = context.bridges.volume;
    for (std::size_t k = 0; k < batch.size; ++k) {
        if (batch.joined[k] == 0) {
            continue;
        }
        const double radius = batch.diameter[k] / 2;
        const double half_gap = std::max(0.0, batch.gap[k]) / (2 * radius);
        batch.capillary[k] = context.bridges.pull_off_force * batch.diameter[k] *
                             relative_force(half_gap, bridge_volume / (radius * radius * radius));
    }
}

}  // namespace

/// Maugis' bridge attracts beads in contact with F0 at any volume. The force of a true meniscus
/// decreases with its volume (0.89 F0 at V0 = 5e-4 a^3, 0.80 F0 at 8e-3 a^3) and decays differently
/// with the gap.
Effect willett_bridges() {
    return {.summary = "the force of a bridge follows Willett's law instead of Maugis' law",
            .equation =
                "F = 2 pi R Gamma cos(theta) exp(f1 - f2 exp(f3 ln S+ + f4 ln^2 S+)),\n"
                "S+ = (h/2R)/sqrt(V0/R^3), f1..f4 polynomials in ln(V0/R^3)",
            .parameters = {on_switch("Willett's law of the bridge force instead of Maugis' law")},
            .change = dem::ChangePairs{.bridge = willett},
            .touches = Touches::wet,
            .fades_with_capillarity = true,
            .acts_through = {"liquid_content", "1/reduced_pressure"},
            .references = {"Willett, Adams, Johnson, Seville, Langmuir 16 (2000) 9396"}};
}

}  // namespace pendular
