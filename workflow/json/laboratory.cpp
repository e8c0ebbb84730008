#include "workflow/json/run.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "workflow/json/parts.h"

namespace pendular {
namespace {

const char* name_of(StepOrder order) {
    switch (order) {
        case StepOrder::increasing:
            return "increasing";
        case StepOrder::decreasing:
            return "decreasing";
        case StepOrder::random:
            return "random";
        case StepOrder::up_and_down:
            return "up-and-down";
        default:
            return "as-listed";
    }
}

/// Adds what a plan has beyond the default laboratory.
void add_choices(const LabPlan& plan, Json& json) {
    const Instrument& instrument = plan.instrument;
    const Instrument usual;
    if (plan.grains.youngs_modulus) json["youngs_modulus"] = *plan.grains.youngs_modulus;
    if (plan.liquid.viscosity > 0) json["viscosity"] = plan.liquid.viscosity;
    if (plan.noise_seed) json["noise_seed"] = *plan.noise_seed;
    if (plan.order != StepOrder::as_listed) json["order"] = name_of(plan.order);
    if (instrument.torque_error != usual.torque_error)
        json["torque_scatter"] = instrument.torque_error;
    if (instrument.solid_fraction_error != usual.solid_fraction_error)
        json["solid_fraction_scatter"] = instrument.solid_fraction_error;
    if (instrument.step_strain != usual.step_strain) json["step_strain"] = instrument.step_strain;
}

/// Adds a value to a list, unless it is 0 or there already.
void add_once(double value, Json& list) {
    if (value > 0 && std::find(list.begin(), list.end(), value) == list.end())
        list.push_back(value);
}

/// Sets the lists of set points to the values that occur in any recording.
void add_set_points(const LabPlan& plan, Json& json) {
    Json dry = Json::array(), wet = dry, contents = dry, numbers = dry, speeds = dry;
    for (const LabSeries& series : series_of(plan)) {
        add_once(series.liquid_content, contents);
        for (const LabSetPoint& step : series.steps) {
            add_once(step.normal_stress, series.liquid_content > 0 ? wet : dry);
            add_once(step.inertial_number, numbers);
            add_once(step.angular_velocity, speeds);
        }
    }
    json["dry_normal_stresses"] = dry;
    json["wet_normal_stresses"] = wet;
    json["liquid_contents"] = contents;
    json["inertial_numbers"] = numbers;
    if (!speeds.empty()) json["angular_velocities"] = speeds;
}

Json plan_json(const LabPlan& plan) {
    Json json = {{"seed", plan.seed},
                 {"noise", plan.instrument.noise},
                 {"drift", plan.instrument.drift},
                 {"rows", plan.instrument.rows},
                 {"replicates", plan.replicates},
                 {"fidelity", plan.fidelity.name},
                 {"diameter", plan.grains.diameter},
                 {"density", plan.grains.density},
                 {"poisson_ratio", plan.grains.poisson_ratio},
                 {"surface_tension", plan.liquid.surface_tension},
                 {"contact_angle", plan.liquid.contact_angle},
                 {"inner_radius", plan.cell.inner_radius},
                 {"outer_radius", plan.cell.outer_radius},
                 {"bead_volume", plan.cell.bead_volume},
                 {"dry_normal_stresses", plan.dry_normal_stresses},
                 {"wet_normal_stresses", plan.wet_normal_stresses},
                 {"liquid_contents", plan.liquid_contents},
                 {"inertial_numbers", plan.inertial_numbers}};
    if (!plan.series.empty() || !plan.angular_velocities.empty()) add_set_points(plan, json);
    add_choices(plan, json);
    return json;
}

/// JSON of the true condition of a step, which effects make differ from the shown condition.
Json imposed_json(const Condition& imposed) {
    Json json = {{"normal_stress", imposed.normal_stress},
                 {"inertial_number", imposed.inertial_number},
                 {"liquid_content", imposed.liquid_content},
                 {"time", imposed.time}};
    if (imposed.bead_volume) json["bead_volume"] = *imposed.bead_volume;
    return json;
}

Json step_json(const LabStep& step, bool with_effects) {
    Json json = {{"normal_stress", step.condition.normal_stress},
                 {"inertial_number", step.condition.inertial_number},
                 {"liquid_content", step.condition.liquid_content}};
    if (step.angular_velocity > 0) json["angular_velocity"] = step.angular_velocity;
    if (with_effects) json["imposed"] = imposed_json(step.imposed);
    json["run"] = pendular::to_json(step.run);
    return json;
}

}  // namespace

Json to_json(const LabResult& result) {
    Json recordings = Json::array();
    for (const LabRecording& recording : result.recordings) {
        Json steps = Json::array();
        for (const LabStep& step : recording.steps) {
            steps.push_back(step_json(step, !result.plan.effects.empty()));
        }
        recordings.push_back({{"file", recording.file},
                              {"liquid_content", recording.liquid_content},
                              {"replicate", recording.replicate},
                              {"instrument_seed", recording.seed},
                              {"steps", steps}});
    }
    return {{"friction", result.plan.friction},
            {"effects", effects_json(result.plan.effects)},
            {"plan", plan_json(result.plan)},
            {"recordings", recordings},
            {"notes", result.notes}};
}

}  // namespace pendular
