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

/// Physical effect on the grains' forces or sizes that acts in a run. `change` and `parameters`
/// must outlive the run.
struct GrainEffect {
    std::variant<const ChangePairs*, const ChangeSample*> change;
    std::span<const EffectParameter> parameters;
    std::vector<double> values;  ///< values of `parameters`, reduced units
};

/// All effects on grains that act in a run, in the form that the solver calls.
class GrainEffects {
  public:
    GrainEffects() = default;
    explicit GrainEffects(const std::vector<GrainEffect>& on);

    /// Whether any effect changes or adds forces between grains, or lets bridges form without
    /// contact; the force loop then calls `bridge`, `limit` and `add`.
    bool changes_forces() const { return changes_forces_; }
    /// Whether any effect changes the forces between grains or their sizes.
    bool changes_pairs() const { return changes_forces_ || !samples_.empty(); }
    /// Number of values that all effects together store from step to step for each pair of grains.
    std::size_t contact_history() const { return contact_history_; }
    bool bridges_without_contact() const { return bridges_without_contact_; }
    BridgeLaw changed(BridgeLaw law) const;
    double damping_rate(const BridgeLaw& law) const;
    /// Random diameters of `count` grains over their mean [1]; empty where no effect changes sizes.
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
    /// Attraction by the liquid bridge between two grains at rest, changed by these effects
    /// [a^2 s22]. A negative gap [diameters] is an overlap; `diameter` is 2 d1 d2/(d1 + d2) for
    /// grains of the diameters d1 and d2, over the mean diameter.
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
