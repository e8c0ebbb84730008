#include "workflow/json/prediction.h"

#include <cmath>
#include <nlohmann/json.hpp>
#include <string>

#include "calib/emulator/emulated_observables.h"
#include "workflow/json/parts.h"
#include "workflow/json/run.h"
#include "workflow/json/training_runs.h"

namespace pendular {
namespace {

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
            own["derivatives"][inputs[k]] =
                uncertain(one.slopes[k].value, one.slopes[k].standard_error);
        }
    }
    return json;
}

}  // namespace

Json to_json(const StatePrediction& prediction, const std::vector<dem::RunResult>& runs) {
    Json json = state_json(prediction.state, prediction.observables);
    json["stiffness_number"] = prediction.stiffness_number;
    json["beyond"] = prediction.beyond;
    json["simulated"] = false;
    if (prediction.closures) json["closures"] = closures_json(*prediction.closures);
    json["runs"] = runs_json(runs);
    return json;
}

Json to_json(const PredictionCurve& curve, const std::vector<dem::RunResult>& runs) {
    Json json = {{"along", curve.variable}, {"states", Json::array()}};
    for (std::size_t k = 0; k < curve.states.size(); ++k) {
        json["states"].push_back(state_json(curve.states[k], curve.observables[k]));
        if (!curve.closures.empty()) {
            json["states"].back()["closures"] = closures_json(curve.closures[k]);
        }
    }
    json["left_out"] = curve.left_out;
    json["runs"] = runs_json(runs);
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

Json to_json(const Reproduction& reproduction) {
    const auto bound = [](double value) { return std::isfinite(value) ? Json(value) : Json(); };
    Json rows = Json::array();
    for (const ScoreboardRow& row : reproduction.rows()) {
        rows.push_back({{"section", row.section},
                        {"what", row.what},
                        {"published", row.published},
                        {"published_range", {bound(row.lower), bound(row.upper)}},
                        {"ours", row.ours},
                        {"our_range", {row.least, row.greatest}},
                        {"distance", row.distance},
                        {"values", row.values},
                        {"outside", row.outside},
                        {"where", row.where},
                        {"agrees", row.agrees}});
    }
    return {{"rows", rows},
            {"agreeing", reproduction.agreeing()},
            {"runs", runs_json(reproduction.emulator().runs())},
            {"states", reproduction.study().states().size()},
            {"missing", reproduction.study().missing().size()}};
}

}  // namespace pendular
