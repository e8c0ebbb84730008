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

/// Physical effect on the forces between grains or on the grain sizes, with its parameter values in
/// a run. The objects to which `change` and `parameters` refer must outlive the run.
struct GrainEffect {
    std::variant<const ChangePairs*, const ChangeSample*> change;
    std::span<const EffectParameter> parameters;
    /// Value of each parameter of the effect, in reduced units (grain diameter, grain mass and
    /// imposed normal stress are 1).
    std::vector<double> values;
};

/// All physical effects on the forces between grains and on the grain sizes that act in a
/// simulation run, with the functions by which the solver applies the effects.
class GrainEffects {
  public:
    GrainEffects() = default;
    explicit GrainEffects(const std::vector<GrainEffect>& on);

    /// Whether any effect of the run changes or adds a force between two grains, or lets bridges
    /// form between grains that do not touch. An effect that changes only the law of the bridges
    /// (`ChangePairs::bridge_law`) does not count.
    bool changes_forces() const { return changes_forces_; }
    /// Whether any effect of the run changes the grain sizes or the forces between grains
    /// (`changes_forces`).
    bool changes_pairs() const { return changes_forces_ || !samples_.empty(); }
    /// Returns the number of values that all effects together store for each pair of grains from
    /// one time step to the next, such as a tangential displacement.
    std::size_t contact_history() const { return contact_history_; }
    bool bridges_without_contact() const { return bridges_without_contact_; }
    BridgeLaw changed(BridgeLaw law) const;
    double damping_rate(const BridgeLaw& law) const;
    /// Returns the rate [1 per unit of shear strain] at which the volumes of the bridges on a grain
    /// become equal by flow of liquid. The rate is 0 if bridges exchange no liquid.
    double exchange_rate() const;
    /// Returns random diameters of `count` grains, divided by the mean diameter [1]; empty if no
    /// effect changes the grain sizes.
    /// @param seed seed of the random numbers
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
    /// Returns the index of the bridge volume in the contact history (values that effects store for
    /// each pair of grains); empty if all bridges have the volume V0. The stored bridge volume is
    /// divided by the mean volume V0 of newly formed bridges.
    std::optional<std::size_t> volume_in_history() const { return volume_in_history_; }
    /// Returns the attraction of two grains at rest by a liquid bridge, with all effects of the
    /// run, in units of a^2 s22, with grain diameter a and imposed normal stress s22.
    /// @param gap gap between the surfaces [grain diameters]; negative for an overlap
    /// @param diameter 2 d1 d2/(d1 + d2), with the grain diameters d1 and d2 divided by the mean
    ///         grain diameter [1]
    /// @param history values that the effects store for the pair (`contact_history`); if empty, the
    ///         bridge has the mean volume of newly formed bridges
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
