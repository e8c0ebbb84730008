#include "workflow/json/parts.h"

#include <cmath>
#include <nlohmann/json.hpp>

#include "data/files/json_text.h"
#include "data/files/write_whole.h"
#include "data/remarks/wording.h"

namespace pendular {
void write_json(const std::filesystem::path& file, const Json& json) {
    write_whole(file, json_text(json));
}

Json uncertain(double value, double error) {
    return {{"value", value}, {"stderr", error}};
}

Json effects_json(const std::vector<ActiveEffect>& effects) {
    Json json = Json::object();
    for (const ActiveEffect& active : effects) {
        for (std::size_t k = 0; k < active.values.size(); ++k) {
            json[active.effect->name + "." + active.effect->parameters[k].name] = active.values[k];
        }
    }
    return json;
}

void add_older_names(Json& object) {
    constexpr std::pair<const char*, const char*> older[] = {
        {"predicted_reduction", "predicted_drop"},
        {"refitted_reduction", "refit_drop"},
        {"share_imitated", "absorbed"},
        {"grain_steps_per_second", "particle_steps_per_second"}};
    for (const auto& [name, older_name] : older) {
        if (object.contains(name)) object[older_name] = object[name];
    }
}

Json pair_of(const Eigen::Vector2d& value, const Eigen::Matrix2d& covariance) {
    return {{"shear_stress", uncertain(value(0), std::sqrt(covariance(0, 0)))},
            {"solid_fraction", uncertain(value(1), std::sqrt(covariance(1, 1)))}};
}

Json misfit_json(const Misfit& misfit) {
    return {{"chi2", misfit.chi2}, {"dof", misfit.dof}, {"p", misfit.p()}};
}

Json prediction_json(const ReadingMisfit& misfit) {
    const Reading& reading = misfit.reading;
    return {{"file", reading.origin.file},
            {"step", reading.step},
            {"normal_stress", reading.condition.normal_stress},
            {"inertial_number", reading.condition.inertial_number},
            {"liquid_content", reading.condition.liquid_content},
            {"failure", reading.condition.at_failure},
            {"measured", pair_of(reading.value, reading.covariance)},
            {"predicted", pair_of(misfit.predicted, misfit.predicted_covariance)},
            {"chi2", misfit.chi2.sum()}};
}

Json direct_json(const DirectMeasurement& direct) {
    Json json = {{"parameter", direct.parameter}, {"unit", direct.unit}};
    json.update(uncertain(direct.value, direct.standard_error));
    return json;
}

Json file_finding_json(const Remark& fault) {
    Json lines = Json::array();
    for (const Lines& range : fault.lines)
        lines.push_back({range.first, range.last});
    return {{"file", fault.file()},
            {"kind", to_string(fault)},
            {"lines", std::move(lines)},
            {"what", text_of(fault)},
            {"done", done_about(fault)}};
}

Json findings_json(const std::vector<Remark>& findings) {
    Json json = Json::array();
    for (const Remark& each : findings) {
        json.push_back({{"kind", to_string(each)},
                        {"quantity", each.quantity},
                        {"files", each.files},
                        {"step", each.step},
                        {"steps", each.count},
                        {"size", uncertain(each.size, each.size_error)},
                        {"relative", uncertain(each.relative, each.relative_error)},
                        {"period", each.period},
                        {"offset", each.offset},
                        {"corrected", each.corrected},
                        {"p", each.p},
                        {"sentence", sentences({each}).front()}});
    }
    return json;
}

Json cohesion_lines_json(const std::vector<CohesionLine>& lines) {
    const auto estimate = [](const Estimate& e) { return uncertain(e.value, e.standard_error); };
    Json json = Json::array();
    for (const auto& line : lines) {
        Json below = Json::array();
        for (const auto& one : line.below) {
            below.push_back(
                {{"reduced_pressure", one.reduced_pressure}, {"relative", estimate(one.relative)}});
        }
        json.push_back({{"source", line.source},
                        {"liquid_content", line.liquid_content},
                        {"inertial_number", line.inertial_number},
                        {"stress_ratio_intercept", estimate(line.stress_ratio_intercept)},
                        {"reduced_cohesion", estimate(line.reduced_cohesion)},
                        {"correlation", line.correlation},
                        {"cohesion", estimate(line.cohesion)},
                        {"points", line.points},
                        {"lowest_reduced_pressure", line.lowest_reduced_pressure},
                        {"chi2", line.chi2},
                        {"dof", line.dof},
                        {"overestimate_below", below}});
    }
    return json;
}

void add_belief(Json& json, const Belief& belief) {
    const auto agreement_json = [](const Agreement& agreement) -> Json {
        return {{"degree", to_string(agreement.degree())},
                {"readings", agreement.readings},
                {"chi2", agreement.misfit.chi2},
                {"dof", agreement.misfit.dof},
                {"p", agreement.misfit.p()},
                {"misfit_in_errors", agreement.in_errors()},
                {"rms_percent", agreement.rms_percent},
                {"discrepancy", agreement.discrepancy}};
    };
    json["believable"] = belief.believable();
    json["reasons"] = belief.reasons;
    json["agreement"] = {
        {"fitted", agreement_json(belief.fitted)},
        {"predicted", belief.predicted ? agreement_json(*belief.predicted) : Json()}};
}

Json recordings_json(const std::vector<RecordingEvidence>& evidence) {
    Json json = Json::array();
    for (const RecordingEvidence& each : evidence) {
        Json one = findings_json({each.finding}).front();
        one["explains"] = each.explains < 0 ? Json() : Json(each.explains);
        json.push_back(std::move(one));
    }
    return json;
}

}  // namespace pendular
