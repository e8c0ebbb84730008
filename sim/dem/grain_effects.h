#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <variant>
#include <vector>

#include "data/effect_parameter.h"
#include "sim/dem/bridge_law.h"
#include "sim/dem/change_pairs.h"
#include "sim/dem/contact_law.h"

namespace pendular::dem {

/// An effect on grains that is on in a run. The effect it refers to must outlive the run.
struct GrainEffect {
    std::variant<const ChangePairs*, const ChangeSample*> change;
    std::span<const EffectParameter> parameters;
    std::vector<double> values;  ///< of the parameters [units of the run]
};

/// The effects on grains that are on in a run, as the solver calls them.
class GrainEffects {
  public:
    GrainEffects() = default;
    explicit GrainEffects(const std::vector<GrainEffect>& on);

    /// Whether the force loop must call effects between its stages.
    bool changes_forces() const { return changes_forces_; }
    /// Whether pairs follow other laws than equal grains without effects: forces or sizes differ.
    bool changes_pairs() const { return changes_forces_ || !samples_.empty(); }
    /// Numbers of contact history per pair, all effects together.
    std::size_t contact_history() const { return contact_history_; }
    bool bridges_without_contact() const { return bridges_without_contact_; }
    BridgeLaw changed(BridgeLaw law) const;
    double damping_rate(const BridgeLaw& law) const;
    /// Diameters of so many grains, of mean 1; empty where all are equal.
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
    /// Attraction [a^2 s22] by a bridge of grains at rest at this gap, `diameter` as in PairBatch.
    double attraction(double gap, double diameter, const Material& material,
                      const BridgeLaw& bridges) const;

  private:
    struct OnPairs {
        const ChangePairs* change;
        std::span<const EffectParameter> parameters;
        std::vector<double> values;
        std::size_t first_history_value;
    };
    struct OnSample {
        const ChangeSample* change;
        std::span<const EffectParameter> parameters;
        std::vector<double> values;
    };
    void stage(ChangePairs::Stage ChangePairs::*which, const PairBatch& batch,
               const Material& material, const BridgeLaw& bridges) const;

    std::vector<OnPairs> pairs_;
    std::vector<OnSample> samples_;
    std::size_t contact_history_ = 0;
    bool changes_forces_ = false, bridges_without_contact_ = false, changes_bridges_ = false;
};

}  // namespace pendular::dem
