#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <variant>
#include <vector>

#include "data/effect_parameter.h"
#include "sim/dem/bridge_law.h"
#include "sim/dem/change_pairs.h"
#include "sim/dem/contact_law.h"

namespace pendular::dem {

/// Effect on the forces between grains or on the grain sizes, with its parameter values in a run.
/// The objects to which `change` and `parameters` refer must outlive the run.
struct GrainEffect {
    std::variant<const ChangePairs*, const ChangeSample*> change;
    std::span<const EffectParameter> parameters;
    std::vector<double> values;  ///< in reduced units (diameter, mass and normal stress 1)
};

/// All effects on forces and sizes of grains that act in a run, as the solver applies them.
class GrainEffects {
  public:
    GrainEffects() = default;
    explicit GrainEffects(const std::vector<GrainEffect>& on);

    /// Whether any effect changes or adds a force between two grains, or lets bridges form between
    /// grains that do not touch. An effect that changes only the law of the bridges does not count.
    bool changes_forces() const { return changes_forces_; }
    /// Whether any effect changes the grain sizes or the forces.
    bool changes_pairs() const { return changes_forces_ || !samples_.empty(); }
    /// Returns the number of values that all effects together keep for each pair from step to step.
    std::size_t contact_history() const { return contact_history_; }
    bool bridges_without_contact() const { return bridges_without_contact_; }
    BridgeLaw changed(BridgeLaw law) const;
    double damping_rate(const BridgeLaw& law) const;
    /// Returns the rate [1 per unit of shear strain] at which the volumes of the bridges on a grain
    /// become equal by flow of liquid; 0 if bridges exchange no liquid.
    double exchange_rate() const;
    /// Returns random diameters of `count` grains over their mean [1]; empty if no effect changes
    /// sizes.
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
    /// Returns the index, in the contact history, of the bridge volume over the mean volume V0 of
    /// newly formed bridges; empty if all bridges have the volume V0.
    std::optional<std::size_t> volume_in_history() const { return volume_in_history_; }
    /// Returns the attraction of two grains at rest by a bridge, with all effects, in units of a^2
    /// s22 (a: grain diameter, s22: imposed normal stress).
    /// @param gap between the surfaces [grain diameters]; negative for an overlap
    /// @param diameter 2 d1 d2/(d1 + d2) of the diameters, over the mean grain diameter [1]
    /// @param history values that the effects keep for the pair; if empty, the bridge has the
    ///         volume V0
    double attraction(double gap, double diameter, const Material& material,
                      const BridgeLaw& bridges, std::vector<double> history = {}) const;

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
    std::optional<std::size_t> volume_in_history_;
    bool changes_forces_ = false, bridges_without_contact_ = false, changes_bridges_ = false;
};

}  // namespace pendular::dem
