#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "data/reading.h"
#include "sim/dem/bridge_law.h"
#include "sim/dem/change_pairs.h"
#include "sim/dem/contact_law.h"

namespace pendular {
struct Effect;
}

namespace pendular::dem {

/// The effects on grains that are on in a run, as the solver wants them. Those at their neutral
/// value are not among them.
class GrainEffects {
  public:
    GrainEffects() = default;
    /// @throws std::invalid_argument for an effect that is unknown or not one on grains, for values
    ///         beyond its bounds, and where one needs bridges and there are none
    GrainEffects(const std::vector<EffectValues>& effects, bool wet);

    /// Whether the force loop must call anyone.
    bool hooked() const { return hooked_; }
    /// Words that a pair remembers for all of them.
    std::size_t memory() const { return memory_; }
    bool bridges_without_contact() const { return bridges_without_contact_; }
    BridgeLaw changed(BridgeLaw law) const;
    double damping_rate(const BridgeLaw& law) const;
    /// Diameters of so many beads, of mean 1; empty where all are equal.
    std::vector<double> diameters(std::size_t count, std::uint64_t seed) const;

    void bridge(const PairBatch& batch, const Material& material, const BridgeLaw& bridges) const {
        stage(&ChangePairs::bridge, batch, material, bridges);
    }
    void limit(const PairBatch& batch, const Material& material, const BridgeLaw& bridges) const {
        stage(&ChangePairs::limit, batch, material, bridges);
    }
    void add(const PairBatch& batch, const Material& material, const BridgeLaw& bridges) const {
        stage(&ChangePairs::add, batch, material, bridges);
    }
    bool changes_bridges() const { return changes_bridges_; }
    /// Attraction [a^2 s22] by a bridge of beads at rest at this gap, `diameter` as in PairBatch.
    double attraction(double gap, double diameter, const Material& material,
                      const BridgeLaw& bridges) const;

  private:
    struct OnPairs {
        const ChangePairs* change;
        const std::vector<EffectParameter>* parameters;
        std::vector<double> values;
        std::size_t first_word;
    };
    struct OnSample {
        const ChangeSample* change;
        const std::vector<EffectParameter>* parameters;
        std::vector<double> values;
    };
    void stage(ChangePairs::Stage ChangePairs::*which, const PairBatch& batch,
               const Material& material, const BridgeLaw& bridges) const;

    std::vector<OnPairs> pairs_;
    std::vector<OnSample> samples_;
    std::size_t memory_ = 0;
    bool hooked_ = false, bridges_without_contact_ = false, changes_bridges_ = false;
};

/// The effects of a run, as in "rolling-resistance.coefficient=0.1 willett-bridges.on=1", and back.
/// @throws std::invalid_argument for any other text
std::string effects_text(const std::vector<EffectValues>& effects);
std::vector<EffectValues> effects_from(const std::string& text);

}  // namespace pendular::dem
