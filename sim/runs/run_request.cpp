#include "sim/runs/run_request.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <sstream>
#include <stdexcept>
#include <utility>
#include <variant>

#include "data/formula_variant.h"
#include "data/quantities/number.h"
#include "sim/catalogue/effect.h"
#include "sim/dem/grain_effects.h"

namespace pendular {
namespace {

/// Checks that an effect with these values, in the units of a run, can act on a dry or wet run.
/// @throws std::invalid_argument where it cannot
void check_effect(const Effect& effect, const std::vector<double>& values, bool wet) {
    if (!effect.of_grains()) {
        throw std::invalid_argument(fmt::format(
            "{} is no effect on grains: a single simulation cannot have it", effect.name));
    }
    if (effect.touches == Touches::wet && !wet) {
        throw std::invalid_argument(fmt::format(
            "{} acts on liquid bridges, and these grains are dry; add a reduced pressure and a "
            "bridge volume",
            effect.name));
    }
    for (std::size_t k = 0; k < values.size(); ++k) {
        const EffectParameter& p = effect.parameters[k];
        // In the units of a run only dimensionless parameters have an upper bound.
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

dem::GrainEffect resolved(const Effect& effect, const std::vector<double>& values) {
    if (const auto* pairs = std::get_if<dem::ChangePairs>(&effect.change)) {
        return {pairs, effect.parameters, values};
    }
    return {&std::get<dem::ChangeSample>(effect.change), effect.parameters, values};
}

}  // namespace

dem::GrainEffects grain_effects(const std::vector<EffectValues>& effects, bool wet) {
    std::vector<dem::GrainEffect> on;
    for (const EffectValues& active : effects) {
        const Effect& effect = built_in_effect(active.effect);
        check_effect(effect, active.values, wet);
        if (active.values != effect.neutral()) {
            on.push_back(resolved(effect, active.values));
        }
    }
    return dem::GrainEffects(on);
}

std::string effects_text(const std::vector<EffectValues>& effects) {
    std::string text;
    for (const EffectValues& active : effects) {
        const Effect& effect = built_in_effect(active.effect);
        for (std::size_t k = 0; k < active.values.size(); ++k) {
            const EffectParameter& p = effect.parameters[k];
            if (p.only_simulated && active.values[k] == p.neutral) continue;
            text += fmt::format("{}{}.{}={}", text.empty() ? "" : " ", effect.name, p.name,
                                active.values[k]);
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

void check_run(const dem::RunParameters& run) {
    dem::check_run_parameters(run, grain_effects(run.effects, run.wetting.has_value()));
}

std::string run_description(const dem::RunParameters& p, int threads) {
    std::string text = fmt::format(
        "friction = {}\ninertial number = {}\nstiffness number = {}\nPoisson ratio = {}\n"
        "damping = {}\n",
        p.friction, p.inertial_number, p.stiffness_number, p.poisson_ratio, p.damping);
    const dem::Wetting wetting = p.wetting.value_or(dem::Wetting{});
    text += fmt::format("reduced pressure = {}\nbridge volume = {}\nbridge force = {}\n",
                        p.wetting ? fmt::format("{}", wetting.reduced_pressure) : "none (dry)",
                        wetting.bridge_volume, to_string(wetting.bridge_force));
    for (const dem::Precision& wanted : p.precision) {
        text += fmt::format("precision of {} = {}\n",
                            dem::observable_names[static_cast<std::size_t>(wanted.which)],
                            wanted.standard_error);
    }
    if (!p.effects.empty()) {
        text += fmt::format("effects = {}\n", effects_text(p.effects));
    }
    text += fmt::format("beads = {}\nstrain = {}\nseed = {}\nthreads = {}\n", p.grains, p.strain,
                        p.seed, threads);
    return p.start == 0 ? text : text + fmt::format("start = {:x}\n", p.start);
}

std::uint64_t fingerprint(std::string_view text) {
    std::uint64_t hash = 0xcbf29ce484222325u;
    for (const char c : text) {
        hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001b3u;
    }
    return hash;
}

dem::RunResult simulate(const dem::RunParameters& run, dem::RunOptions options) {
    options.description = run_description(run, options.threads);
    return dem::run(run, grain_effects(run.effects, run.wetting.has_value()), options);
}

}  // namespace pendular
