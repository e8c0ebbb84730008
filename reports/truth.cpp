#include "reports/truth.h"

#include <nlohmann/json.hpp>

#include "workflow/json.h"

namespace pendular {
namespace {

using Json = nlohmann::ordered_json;

Json plan_json(const LabPlan& plan) {
    return {{"seed", plan.seed},
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
    if (with_effects) json["imposed"] = imposed_json(step.imposed);
    json["run"] = to_json(step.run);
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
