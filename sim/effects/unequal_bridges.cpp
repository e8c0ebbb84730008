#include <bit>
#include <cmath>
#include <cstdint>

#include "data/quantities/statistics.h"
#include "sim/catalogue/effect.h"
#include "sim/dem/bridge_law.h"

namespace pendular {
namespace {

/// Lognormal distribution of the volumes of bridges, of mean 1, cut off three standard deviations
/// of the logarithm from its median so that the rupture distance has a bound.
class Volumes {
  public:
    static constexpr double cut_off = 3;

    /// @param deviation standard deviation over the mean of the distribution before the cut [1]
    explicit Volumes(double deviation) : width_(std::sqrt(std::log1p(deviation * deviation))) {
        const double whole = normal_below(cut_off) - normal_below(-cut_off);
        mean_ = std::exp(width_ * width_ / 2) *
                (normal_below(cut_off - width_) - normal_below(-cut_off - width_)) / whole;
        largest_ = at(cut_off);
    }
    double largest() const { return largest_; }
    /// Volume below which a fraction `share` of the bridges lies, over the mean volume [1].
    double quantile(double share) const {
        const double lowest = normal_below(-cut_off);
        return at(normal_quantile(lowest + share * (1 - 2 * lowest)));
    }

  private:
    double at(double z) const { return std::exp(width_ * z) / mean_; }

    double width_;  ///< standard deviation of the logarithm
    double mean_ = 1, largest_ = 1;
};

/// Returns a random number between 0 and 1 from the direction of a pair. The direction at which two
/// grains touch is as good as random in its last digits, and equal for equal seeds of a run.
double random_share(double nx, double ny, double nz) {
    std::uint64_t hash = 0;
    for (const double component : {nx, ny, nz}) {
        // The mixing function of splitmix64 (Steele, Lea, Flood, OOPSLA 2014).
        hash += std::bit_cast<std::uint64_t>(component) + 0x9e3779b97f4a7c15u;
        hash = (hash ^ (hash >> 30)) * 0xbf58476d1ce4e5b9u;
        hash = (hash ^ (hash >> 27)) * 0x94d049bb133111ebu;
        hash ^= hash >> 31;
    }
    return (static_cast<double>(hash >> 11) + 0.5) / static_cast<double>(1ull << 53);
}

/// Returns the distribution of volumes of this deviation, which is computed once for all batches.
const Volumes& volumes_of(double deviation) {
    thread_local double computed = 0;
    thread_local Volumes volumes(computed);
    if (deviation != computed) {
        volumes = Volumes(deviation);
        computed = deviation;
    }
    return volumes;
}

/// Gives each bridge that forms its volume, breaks bridges beyond their own rupture distance, and
/// scales the force of each to its volume. In contact, the force does not depend on the volume. A
/// pair keeps its volume until the base law has no bridge for it: where bridges form without
/// contact, a pair would else draw volumes until one reaches.
void own_volumes(const dem::PairBatch& batch, const dem::PairContext& context) {
    if (batch.contact_history == nullptr) return;  // a bridge of the mean volume
    const Volumes& volumes = volumes_of(context.values["deviation"]);
    double* volume = batch.contact_history[0];
    for (std::size_t k = 0; k < batch.size; ++k) {
        if (batch.joined[k] == 0) {
            volume[k] = 0;
            continue;
        }
        if (volume[k] == 0) {
            volume[k] = volumes.quantile(random_share(batch.nx[k], batch.ny[k], batch.nz[k]));
        }
        const double own = std::abs(volume[k]);  // the sign follows the order of the two grains
        const double gap = batch.gap[k], reach = context.bridges.rupture_distance;
        if (gap <= 0) continue;
        if (gap * gap * gap * volumes.largest() > reach * reach * reach * own) {
            batch.joined[k] = batch.capillary[k] = 0;
            continue;
        }
        dem::BridgeLaw law = context.bridges.of(batch.diameter[k]);
        const double base = law.relative_force(gap);
        law.curvature *= own;
        batch.capillary[k] *= law.relative_force(gap) / base;
    }
}

}  // namespace

/// In the base law all bridges have the volume V0, as if the liquid evened out at once. In a
/// sheared sample a bridge takes up the liquid that it finds where it forms, so that volumes
/// differ. The force in contact does not depend on the volume; a small bridge attracts less and
/// breaks earlier, a large one attracts more and reaches further. Bridges break sooner when they
/// are small, so that those without contact are larger than the mean. Simulations may let liquid
/// flow between the bridges of a grain; if it flows fast, volumes become equal, as in the base law.
/// The readings hardly tell this exchange from a smaller deviation, so that studies fit the
/// deviation alone. While the deviation is small, the readings change with the variance of the
/// volumes, its square.
Effect unequal_bridges() {
    return {
        .summary = "liquid bridges differ in volume",
        .equation =
            "volume V of a bridge lognormal of mean V0 as it forms; then, of bridge k between "
            "grains i and j,\n"
            "dV_k/d(strain) = exchange [(m_i + m_j)/2 - V_k],  m_i: mean of grain i's bridges;\n"
            "F = F0 [1 - h/sqrt(h^2 + 4 V/(pi a))],  rupture distance V^(1/3)",
        .parameters =
            {{.name = "deviation",
              .unit = "1",
              .lower = 0,
              .upper = 1,
              .neutral = 0,
              // Chosen: by the square, a quarter of the change at the bound.
              .smallest_of_interest = 0.5,
              .meaning =
                  "standard deviation of the bridges' volumes as they form, divided by their mean",
              .amplitude = [](double deviation) { return deviation * deviation; }},
             {.name = "exchange",
              .unit = "1",
              .lower = 0,
              .upper = 1000,
              .neutral = 0,
              .smallest_of_interest = 1,
              .meaning = "rate per unit of shear strain at which liquid evens out "
                         "between the bridges of a grain; in simulations only",
              .only_simulated = true}},
        .change = dem::ChangePairs{.contact_history = 1,
                                   .volume_in_history = true,
                                   .exchange_rate = [](const Values& v) { return v["exchange"]; },
                                   .bridge_law =
                                       [](dem::BridgeLaw law, const Values& v) {
                                           law.rupture_distance *=
                                               std::cbrt(Volumes(v["deviation"]).largest());
                                           return law;
                                       },
                                   .bridge = own_volumes},
        .touches = Touches::wet,
        .fades_with_capillarity = true,
        .acts_through = {"liquid_content", "1/reduced_pressure"},
        .references = {
            "Scheel, Seemann, Brinkmann, Di Michiel, Sheppard, Breidenbach, Herminghaus, "
            "Nature Materials 7 (2008) 189: volumes of bridges in wet beads",
            "Mani, Kadau, Or, Herrmann, Phys. Rev. Lett. 109 (2012) 248001: volumes of bridges "
            "under shear"}};
}

}  // namespace pendular
