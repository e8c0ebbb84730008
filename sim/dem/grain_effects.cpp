#include "sim/dem/grain_effects.h"

#include <algorithm>
#include <numeric>
#include <random>

namespace pendular::dem {
GrainEffects::GrainEffects(const std::vector<GrainEffect>& on) {
    for (const GrainEffect& effect : on) {
        if (const auto* pairs = std::get_if<const ChangePairs*>(&effect.change)) {
            const ChangePairs& change = **pairs;
            pairs_.push_back({&change, effect.parameters, effect.values, contact_history_});
            if (change.volume_in_history) volume_in_history_ = contact_history_;
            contact_history_ += change.contact_history;
            bridges_without_contact_ |= change.bridges_without_contact;
            changes_bridges_ |= change.bridge != nullptr;
            changes_forces_ |=
                change.bridge || change.limit || change.add || change.bridges_without_contact;
        } else {
            samples_.push_back(
                {std::get<const ChangeSample*>(effect.change), effect.parameters, effect.values});
        }
    }
}

BridgeLaw GrainEffects::changed(BridgeLaw law) const {
    for (const OnPairs& on : pairs_) {
        if (on.change->bridge_law) {
            law = on.change->bridge_law(law, Values(on.parameters, on.values));
        }
    }
    return law;
}

double GrainEffects::damping_rate(const BridgeLaw& law) const {
    double rate = 0;
    for (const OnPairs& on : pairs_) {
        if (on.change->damping_rate) {
            rate += on.change->damping_rate(law, Values(on.parameters, on.values));
        }
    }
    return rate;
}

double GrainEffects::exchange_rate() const {
    double rate = 0;
    for (const OnPairs& on : pairs_) {
        if (on.change->exchange_rate) {
            rate += on.change->exchange_rate(Values(on.parameters, on.values));
        }
    }
    return rate;
}

std::vector<double> GrainEffects::diameters(std::size_t count, std::uint64_t seed) const {
    if (samples_.empty()) {
        return {};
    }
    // Differs from the seed of the grains' positions, so that the random numbers are independent.
    std::mt19937_64 random(seed ^ 0x9e3779b97f4a7c15u);
    std::vector<double> all(count, 1.0);
    for (const OnSample& on : samples_) {
        on.change->diameters(all, random, Values(on.parameters, on.values));
    }
    const double mean = std::accumulate(all.begin(), all.end(), 0.0) / static_cast<double>(count);
    for (double& diameter : all) {
        diameter /= mean;
    }
    return all;
}

void GrainEffects::stage(ChangePairs::Stage ChangePairs::*which, const PairBatch& batch,
                         const Material& material, const BridgeLaw& bridges) const {
    for (const OnPairs& on : pairs_) {
        if (const ChangePairs::Stage work = on.change->*which) {
            PairBatch own = batch;
            own.contact_history = batch.contact_history == nullptr
                                      ? nullptr
                                      : batch.contact_history + on.first_history_value;
            const Values values(on.parameters, on.values);
            work(own, {material, bridges, values});
        }
    }
}

double GrainEffects::attraction(double gap, double diameter, const Material& material,
                                const BridgeLaw& bridges, std::vector<double> history) const {
    double force = bridges.of(diameter).attraction(std::max(gap, 0.0));
    if (changes_bridges_) {
        const double nothing = 0, one = 1;
        double joined = 1;
        std::vector<double*> values;
        for (double& value : history) {
            values.push_back(&value);
        }
        PairBatch single{.size = 1,
                         .nx = &one,
                         .ny = &nothing,
                         .nz = &nothing,
                         .gap = &gap,
                         .diameter = &diameter,
                         .normal_speed = &nothing,
                         .rolling_x = &nothing,
                         .rolling_y = &nothing,
                         .rolling_z = &nothing,
                         .pair_rotation_x = &nothing,
                         .pair_rotation_y = &nothing,
                         .pair_rotation_z = &nothing,
                         .elastic = &nothing,
                         .stiffness = &nothing,
                         .joined = &joined,
                         .capillary = &force,
                         .coulomb_limit = nullptr,
                         .fx = nullptr,
                         .fy = nullptr,
                         .fz = nullptr,
                         .tx = nullptr,
                         .ty = nullptr,
                         .tz = nullptr,
                         .contact_history = values.empty() ? nullptr : values.data()};
        bridge(single, material, bridges);
    }
    return force;
}

}  // namespace pendular::dem
