#include "workflow/json/run.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <string>

#include "data/formula_variant.h"
#include "workflow/json/parts.h"

namespace pendular {
namespace {

/// JSON of a run's effects on grains, with values in the run's dimensionless units.
Json run_effects_json(const std::vector<EffectValues>& effects) {
    std::vector<ActiveEffect> active;
    for (const EffectValues& values : effects) {
        active.push_back({&built_in_effect(values.effect), values.values});
    }
    return effects_json(active);
}

Json field_json(const dem::BinnedMeans& field, dem::Field which) {
    const auto& about = dem::about(which);
    const auto& coordinate = dem::about(about.coordinate);
    Json json = {
        {"meaning", about.meaning},
        {"unit", about.unit},
        {"coordinate",
         {{"name", coordinate.name}, {"unit", coordinate.unit}, {"meaning", coordinate.meaning}}},
        {"at", field.at},
        {"value", Json::array()},
        {"stderr", Json::array()}};
    for (const Mean& mean : field.means) {
        json["value"].push_back(mean.value);
        json["stderr"].push_back(mean.standard_error);
    }
    return json;
}

Json fields_json(const dem::RunResult& run) {
    Json json = {{"profiles", Json::object()}, {"distributions", Json::object()}};
    for (std::size_t k = 0; k < dem::field_count; ++k) {
        const auto which = static_cast<dem::Field>(k);
        if (run.fields[k].means.empty()) continue;
        json[dem::is_profile(which) ? "profiles" : "distributions"]
            [std::string(dem::about(which).name)] = field_json(run[which], which);
    }
    return json;
}

/// Reads the effects on grains of a run from JSON.
std::vector<EffectValues> read_run_effects(const Json& json) {
    std::vector<EffectValues> effects;
    for (const auto& [key, value] : json.items()) {
        const Effect& effect = built_in_effect(key.substr(0, key.find('.')));
        if (effects.empty() || effects.back().effect != effect.name) {
            effects.push_back({effect.name, effect.neutral()});
        }
        effects.back().values[effect.parameter(key.substr(key.find('.') + 1))] = value;
    }
    return effects;
}

}  // namespace

Json to_json(const dem::RunResult& run) {
    Json json;
    for (std::size_t k = 0; k < dem::observable_count; ++k) {
        json[std::string(dem::observable_names[k])] =
            uncertain(run.means[k].value, run.means[k].standard_error);
    }
    const auto& p = run.parameters;
    json["covariance_stress_ratio_solid_fraction"] = run.covariance;
    json["friction"] = p.friction;
    json["inertial_number"] = p.inertial_number;
    json["stiffness_number"] = p.stiffness_number;
    json["poisson_ratio"] = p.poisson_ratio;
    json["damping"] = p.damping;
    json["reduced_pressure"] = nullptr;
    if (p.wetting) {
        json["reduced_pressure"] = p.wetting->reduced_pressure;
        json["bridge_volume"] = p.wetting->bridge_volume;
        json["bridge_force"] = to_string(p.wetting->bridge_force);
    }
    if (!p.effects.empty()) {
        json["effects_in_run_units"] = run_effects_json(p.effects);
    }
    json["beads"] = p.grains;
    json["strain"] = p.strain;
    json["seed"] = p.seed;
    if (p.start != 0) {
        json["start"] = fmt::format("{:x}", p.start);
    }
    json["precision"] = Json::object();
    for (const dem::Precision& wanted : p.precision) {
        json["precision"]
            [std::string(dem::observable_names[static_cast<std::size_t>(wanted.which)])] =
                wanted.standard_error;
    }
    json["strain_averaged"] = run.strain_averaged;
    json["strain_transient"] = run.strain_transient;
    json["time_step"] = run.time_step;
    json["steps"] = run.steps;
    json["wall_seconds"] = run.wall_seconds;
    json["grain_steps_per_second"] = run.particle_steps_per_second();
    json["crystallised"] = run.crystallised;
    json["steady"] = run.steady;
    json["precise"] = run.precise;
    add_older_names(json);
    return json;
}

Json closures_json(const closures::ClosureValues& values) {
    Json json = Json::object();
    for (const auto& each : closures::closure_quantities) {
        json[each.name] = values.*each.value;
    }
    return json;
}

dem::RunResult run_from_json(const Json& json) {
    dem::RunResult run;
    for (std::size_t k = 0; k < dem::observable_count; ++k) {
        const auto observable = json.find(std::string(dem::observable_names[k]));
        if (observable != json.end()) {  // earlier versions measured fewer observables
            run.means[k].value = observable->at("value");
            run.means[k].standard_error = observable->at("stderr");
        }
    }
    auto& p = run.parameters;
    run.covariance = json.at("covariance_stress_ratio_solid_fraction");
    p.friction = json.at("friction");
    p.inertial_number = json.at("inertial_number");
    p.stiffness_number = json.at("stiffness_number");
    p.poisson_ratio = json.at("poisson_ratio");
    p.damping = json.at("damping");
    if (!json.at("reduced_pressure").is_null()) {
        p.wetting = {json.at("reduced_pressure"), json.at("bridge_volume"),
                     formula_variant_named(json.at("bridge_force").get<std::string>())};
    }
    p.effects = read_run_effects(json.value("effects_in_run_units", Json::object()));
    p.grains = json.at("beads");
    p.strain = json.at("strain");
    p.seed = json.at("seed");
    p.start = std::stoull(json.value("start", "0"), nullptr, 16);
    for (const auto& [name, error] : json.at("precision").items()) {
        p.precision.push_back({dem::observable_named(name), error});
    }
    run.strain_averaged = json.at("strain_averaged");
    run.strain_transient = json.at("strain_transient");
    run.time_step = json.at("time_step");
    run.steps = json.at("steps");
    run.wall_seconds = json.at("wall_seconds");
    run.crystallised = json.at("crystallised");
    run.steady = json.at("steady");
    run.precise = json.at("precise");
    return run;
}

Json to_json(const Simulated& simulated) {
    Json json = to_json(simulated.run);
    if (!simulated.effects.empty()) json["effects"] = effects_json(simulated.effects);
    if (const auto& scale = simulated.scale; scale && !simulated.effects.empty()) {
        json["scale"] = {{"diameter", scale->grains.diameter},
                         {"density", scale->grains.density},
                         {"normal_stress", scale->normal_stress}};
        if (simulated.without.wetting)
            json["scale"]["surface_tension"] = scale->liquid.surface_tension;
    }
    json["threads"] = simulated.threads;
    if (simulated.closures) json["closures"] = closures_json(*simulated.closures);
    json.update(fields_json(simulated.run));
    return json;
}

Json to_json(const std::vector<StoredRun>& runs) {
    Json json = {{"runs", Json::array()}};
    for (const StoredRun& stored : runs) {
        Json one = {{"id", stored.id}, {"physics_version", stored.physics_version}};
        one.update(to_json(stored.run));
        if (!stored.run.failure.empty()) one["failure"] = stored.run.failure;
        json["runs"].push_back(std::move(one));
    }
    return json;
}

}  // namespace pendular
