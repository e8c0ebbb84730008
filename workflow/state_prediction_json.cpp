#include "workflow/state_prediction_json.h"

#include <nlohmann/json.hpp>
#include <string>

#include "calib/emulator/emulated_observables.h"
#include "workflow/run_json.h"

namespace pendular {
namespace {

using Json = nlohmann::ordered_json;

Json state_json(const FlowState& state) {
    Json json = {{"friction", state.friction},
                 {"inertial_number", state.inertial_number},
                 {"reduced_pressure", nullptr},
                 {"bridge_volume", nullptr}};
    if (!state.dry()) {
        json["reduced_pressure"] = 1 / state.inverse_pressure;
        json["bridge_volume"] = state.bridge_volume;
    }
    return json;
}

std::string name_of(dem::Observable which) {
    return std::string(dem::observable_names[static_cast<std::size_t>(which)]);
}

Json state_json(const FlowState& state, const std::vector<EmulatedObservable>& observables) {
    constexpr const char* inputs[] = {"friction", "log_inertial_number", "inverse_reduced_pressure",
                                      "bridge_volume"};
    Json json = state_json(state);
    for (const auto& one : observables) {
        Json& own = json[name_of(one.which)];
        own = uncertain(one.value.value, one.value.standard_error);
        for (std::size_t k = 0; k < one.slopes.size(); ++k) {
            own["by"][inputs[k]] = uncertain(one.slopes[k].value, one.slopes[k].standard_error);
        }
    }
    return json;
}

}  // namespace

Json to_json(const StatePrediction& prediction) {
    Json json = state_json(prediction.state, prediction.observables);
    json["stiffness_number"] = prediction.stiffness_number;
    json["beyond"] = prediction.beyond;
    json["simulated"] = false;
    if (prediction.closures) json["closures"] = closures_json(*prediction.closures);
    return json;
}

Json to_json(const PredictionCurve& curve) {
    Json json = {{"along", curve.variable}, {"states", Json::array()}};
    for (std::size_t k = 0; k < curve.states.size(); ++k) {
        json["states"].push_back(state_json(curve.states[k], curve.observables[k]));
        if (!curve.closures.empty()) {
            json["states"].back()["closures"] = closures_json(curve.closures[k]);
        }
    }
    json["left_out"] = curve.left_out;
    return json;
}

Json simulated_state_json(const dem::RunParameters& requested, const dem::RunResult& run) {
    const FlowState state = emulated::flow_state_of(requested);
    Json json = state_json(state);
    for (const dem::Observable which : observables_of(state)) {
        json[name_of(which)] = uncertain(run[which].value, run[which].standard_error);
    }
    json["stiffness_number"] = requested.stiffness_number;
    json["simulated"] = true;
    return json;
}

}  // namespace pendular
