#include "sim/dem/grain_effects.h"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>
#include <sstream>
#include <stdexcept>

#include "data/number.h"
#include "sim/effect.h"

namespace pendular::dem {
namespace {

/// @throws std::invalid_argument
void check(const Effect& effect, const std::vector<double>& values, bool wet) {
    if (!effect.of_grains()) {
        throw std::invalid_argument(
            fmt::format("{} is no effect on grains: a single run cannot have it", effect.name));
    }
    if (effect.touches == Touches::wet && !wet) {
        throw std::invalid_argument(fmt::format(
            "{} acts on liquid bridges, and these beads are dry; add a reduced pressure and a "
            "bridge volume",
            effect.name));
    }
    for (std::size_t k = 0; k < values.size(); ++k) {
        const EffectParameter& p = effect.parameters[k];
        // In the units of a run there is no upper bound but for pure numbers.
        const bool pure = p.unit == "1";
        if (!(values[k] >= p.lower) || (pure && values[k] > p.upper) || !std::isfinite(values[k])) {
            throw std::invalid_argument(fmt::format("{}.{} = {} is beyond its bounds, {} to {}",
                                                    effect.name, p.name, values[k], p.lower,
                                                    p.upper));
        }
        if (p.is_switch() && values[k] != 0 && values[k] != 1) {
            throw std::invalid_argument(
                fmt::format("{}.on = {}: a switch is 0 or 1", effect.name, values[k]));
        }
    }
}

}  // namespace

GrainEffects::GrainEffects(const std::vector<EffectValues>& effects, bool wet) {
    for (const EffectValues& active : effects) {
        const Effect& effect = built_in_effect(active.effect);
        check(effect, active.values, wet);
        if (active.values == effect.neutral()) {
            continue;
        }
        if (const auto* change = std::get_if<ChangePairs>(&effect.change)) {
            pairs_.push_back({change, &effect.parameters, active.values, memory_});
            memory_ += change->memory;
            bridges_without_contact_ |= change->bridges_without_contact;
            changes_bridges_ |= change->bridge != nullptr;
            hooked_ |=
                change->bridge || change->limit || change->add || change->bridges_without_contact;
        } else {
            samples_.push_back(
                {&std::get<ChangeSample>(effect.change), &effect.parameters, active.values});
            hooked_ = true;
        }
    }
}

BridgeLaw GrainEffects::changed(BridgeLaw law) const {
    for (const OnPairs& on : pairs_) {
        if (on.change->bridge_law) {
            law = on.change->bridge_law(law, Values(*on.parameters, on.values));
        }
    }
    return law;
}

double GrainEffects::damping_rate(const BridgeLaw& law) const {
    double rate = 0;
    for (const OnPairs& on : pairs_) {
        if (on.change->damping_rate) {
            rate += on.change->damping_rate(law, Values(*on.parameters, on.values));
        }
    }
    return rate;
}

std::vector<double> GrainEffects::diameters(std::size_t count, std::uint64_t seed) const {
    if (samples_.empty()) {
        return {};
    }
    std::mt19937_64 random(seed ^ 0x9e3779b97f4a7c15u);  // not the numbers that place the beads
    std::vector<double> all(count, 1.0);
    for (const OnSample& on : samples_) {
        on.change->diameters(all, random, Values(*on.parameters, on.values));
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
            own.memory = batch.memory == nullptr ? nullptr : batch.memory + on.first_word;
            const Values values(*on.parameters, on.values);
            work(own, {material, bridges, values});
        }
    }
}

double GrainEffects::attraction(double gap, double diameter, const Material& material,
                                const BridgeLaw& bridges) const {
    double force = bridges.of(diameter).attraction(std::max(gap, 0.0));
    if (changes_bridges_) {
        const double nothing = 0, one = 1;
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
                         .turn_x = &nothing,
                         .turn_y = &nothing,
                         .turn_z = &nothing,
                         .elastic = &nothing,
                         .stiffness = &nothing,
                         .joined = &one,
                         .capillary = &force,
                         .coulomb_limit = nullptr,
                         .fx = nullptr,
                         .fy = nullptr,
                         .fz = nullptr,
                         .tx = nullptr,
                         .ty = nullptr,
                         .tz = nullptr};
        bridge(single, material, bridges);
    }
    return force;
}

std::string effects_text(const std::vector<EffectValues>& effects) {
    std::string text;
    for (const EffectValues& active : effects) {
        const Effect& effect = built_in_effect(active.effect);
        for (std::size_t k = 0; k < active.values.size(); ++k) {
            text += fmt::format("{}{}.{}={}", text.empty() ? "" : " ", effect.name,
                                effect.parameters[k].name, active.values[k]);
        }
    }
    return text;
}

std::vector<EffectValues> effects_from(const std::string& text) {
    std::vector<EffectValues> effects;
    std::istringstream words(text);
    for (std::string word; words >> word;) {
        const auto dot = std::min(word.find('.'), word.size());
        const auto equals = std::min(word.find('=', dot), word.size());
        const auto value = parse_number(word.substr(std::min(equals + 1, word.size())));
        if (!value) {
            throw std::invalid_argument(fmt::format(
                "'{}' is no effect; write one as in rolling-resistance.coefficient=0.1", word));
        }
        const Effect& effect = built_in_effect(word.substr(0, dot));
        const std::size_t at = effect.parameter(word.substr(dot + 1, equals - dot - 1));
        if (effects.empty() || effects.back().effect != effect.name) {
            effects.push_back({effect.name, effect.neutral()});
        }
        effects.back().values[at] = *value;
    }
    std::ranges::sort(effects, {}, &EffectValues::effect);
    return effects;
}

}  // namespace pendular::dem
