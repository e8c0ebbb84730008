#include "workflow/json/diagnosis.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "data/files/json_text.h"
#include "data/files/text_file.h"
#include "data/study/study.h"
#include "workflow/json/parts.h"
#include "workflow/json/training_runs.h"
#include "workflow/proposed_effects.h"
#include "workflow/rivals.h"

namespace pendular {
namespace {

Json to_json(const Finding& finding, Decision decision, const ModelSpace& space) {
    const Candidate& candidate = space.candidates()[finding.candidate];
    const EffectParameter& p = candidate.parameters.front();
    Json json = {
        {"effect", candidate.name},
        {"parameter", p.name},
        {"unit", p.unit},
        {"predicted_reduction", finding.test.predicted_reduction},
        {"estimate", uncertain(finding.value, finding.standard_error)},
        {"share_imitated", finding.test.share_imitated},
        {"power", finding.power},
        {"p", finding.p},
        {"decision", to_string(decision)},
        {"refitted_reduction", nullptr},
        {"identifiable", finding.identifiable},
        {"detectable", nullptr},
        {"noncentrality_of_interest", finding.test.information},
    };
    if (finding.refitted_reduction) {
        json["refitted_reduction"] = *finding.refitted_reduction;
    }
    if (std::isfinite(finding.detectable) && finding.test.seen()) {
        json["detectable"] = finding.detectable;
    }
    add_older_names(json);
    return json;
}

/// JSON of fitted parameters, each with its standard error.
Json fitted_json(const Fit& fit, const ModelSpace& space, const std::vector<std::size_t>& chosen) {
    Json json = Json::object();
    const auto all = space.with(chosen)->parameters();
    for (std::size_t k = 0; k < all.size(); ++k) {
        const auto i = static_cast<Eigen::Index>(k);
        json[all[k].name] = uncertain(fit.parameters(i), fit.standard_error(i));
    }
    return json;
}

Json to_json(const FittedModel& explanation, const ModelSpace& space, const Evidence& evidence) {
    Json json = {{"effects", names_of(explanation, space)},
                 {"parameters", fitted_json(explanation.fit, space, explanation.chosen)},
                 {"chi2", explanation.fit.chi2},
                 {"dof", explanation.fit.dof},
                 {"lack_of_fit_p", explanation.lack_of_fit_p},
                 {"further_p", explanation.further_p},
                 {"accepted", explanation.accepted}};
    if (explanation.suspect) {
        json["suspect_measurement"] = evidence.suspects[*explanation.suspect].name;
    }
    return json;
}

/// JSON with, for each effect that the verdict names, the share of the excess chi2 - dof [1] that
/// the model with this effect alone explains; null where that model was not refitted.
Json explained_of(const Diagnosis& d, const ModelSpace& space) {
    Json json = Json::object();
    for (const std::string& effect : d.effects) {
        const auto alone = std::ranges::find_if(d.tried, [&](const FittedModel& each) {
            return !each.suspect && names_of(each, space) == std::vector{effect};
        });
        if (alone == d.tried.end()) {
            json[effect] = nullptr;
        } else {
            json[effect] = share_explained(d.excess(), *alone);
        }
    }
    return json;
}

/// JSON with the cosine between the signatures of each two effects that the verdict names [1].
Json cosines_of(const Diagnosis& d) {
    Json json = Json::object();
    for (Eigen::Index i = 0; i < d.cosines.rows(); ++i) {
        for (Eigen::Index k = 0; k < d.cosines.cols(); ++k) {
            if (i != k) {
                json[d.effects[static_cast<std::size_t>(i)]]
                    [d.effects[static_cast<std::size_t>(k)]] = d.cosines(i, k);
            }
        }
    }
    return json;
}

/// JSON object with one number for each calibrated parameter.
Json by_parameter(const ImpactTable& table, const Eigen::VectorXd& values) {
    Json json = Json::object();
    for (Eigen::Index k = 0; k < values.size(); ++k) {
        json[table.parameters[static_cast<std::size_t>(k)].name] = values(k);
    }
    return json;
}

Json to_json(const ImpactTable& table, const Shift& shift) {
    Json json = {{"size", shift.size},
                 {"shift", by_parameter(table, shift.bounded)},
                 {"refitted_shift", nullptr}};
    if (shift.refitted.size() > 0) json["refitted_shift"] = by_parameter(table, shift.refitted);
    return json;
}

Json to_json(const ImpactTable& table, const Impact& impact) {
    Json json = {{"name", impact.name},
                 {"kind", impact.measurement ? "measurement" : "effect"},
                 {"quantity", impact.quantity},
                 {"unit", impact.unit},
                 {"group", impact.group},
                 {"neutral", impact.neutral},
                 {"stderr", impact.error},
                 {"pull", nullptr},
                 {"at_size_of_interest", to_json(table, impact.at_interest)},
                 {"at_estimate", to_json(table, impact.at_estimate)},
                 {"one_stderr_above", to_json(table, impact.above)},
                 {"one_stderr_below", to_json(table, impact.below)}};
    if (std::isfinite(impact.pull())) json["pull"] = impact.pull();
    return json;
}

Json proposals_json(const std::vector<Proposal>& proposals,
                    const std::vector<std::string>& sentences) {
    Json json = Json::array();
    for (std::size_t k = 0; k < proposals.size(); ++k) {
        const Proposal& each = proposals[k];
        std::string tables;
        for (const FittedShape& shape : each.shapes) {
            tables += effect_table(shape.effect);
        }
        json.push_back({{"sentence", sentences.at(k)},
                        {"formula", tables},
                        {"p", each.p},
                        {"fits", each.fits()},
                        {"explained", each.explained},
                        {"chi2", each.model.fit.chi2},
                        {"dof", each.model.fit.dof}});
    }
    return json;
}

Json rivals_json(const std::vector<FittedModel>& rivals) {
    Json json = Json::array();
    for (const FittedModel& rival : rivals) {
        json.push_back({{"in_place_of", rival.in_place_of},
                        {"effects", rival.effects},
                        {"chi2", rival.fit.chi2}});
    }
    return json;
}

/// JSON of the simulations that confirm a verdict; null if none were requested.
Json confirmation_json(const std::optional<Confirmation>& confirmed, const std::string& open) {
    if (!confirmed) return nullptr;
    return {{"runs", confirmed->runs},
            {"seconds", confirmed->seconds},
            {"settled", confirmed->settled},
            {"open", open}};
}

Json verdict_json(const Diagnosis& d, const ModelSpace& space, const Evidence& evidence,
                  const Checks& checks) {
    Json sets = Json::array(), scan = Json::array(), tried = Json::array(),
         suspects = Json::array();
    for (const FittedModel& each : d.confidence_set) {
        if (!each.suspect) sets.push_back(names_of(each, space));
    }
    for (const Finding& finding : d.scan) {
        scan.push_back(to_json(finding, d.decision_on(finding), space));
    }
    for (const FittedModel& each : d.tried) {
        tried.push_back(to_json(each, space, evidence));
    }
    for (std::size_t k = 0; k < d.suspect_p.size(); ++k) {
        suspects.push_back({{"name", evidence.suspects[k].name}, {"p", d.suspect_p[k]}});
    }
    return {{"verdict", to_string(d.verdict)},
            {"complete", d.complete},
            {"effects", d.effects},
            {"explained", explained_of(d, space)},
            {"suspect_measurements", d.suspects},
            {"confidence_set", sets},
            {"cosines", cosines_of(d)},
            {"chi2", d.base.fit.chi2},
            {"dof", d.dof},
            {"lack_of_fit_p", d.base.lack_of_fit_p},
            {"further_p", d.base.further_p},
            {"errors_assumed", d.errors_assumed},
            {"parameters", fitted_json(d.base.fit, space, {})},
            {"where", to_json(checks)},
            {"scan", scan},
            {"refits", tried},
            {"suspect_measurement_tests", suspects}};
}

}  // namespace

std::vector<std::string> names_of(const FittedModel& explanation, const ModelSpace& space) {
    std::vector<std::string> names;
    for (const std::size_t k : explanation.chosen) {
        names.push_back(space.candidates()[k].name);
    }
    return names;
}

Json to_json(const ImpactTable& table) {
    Json impacts = Json::array(), groups = Json::array();
    for (const Impact& impact : table.impacts) {
        impacts.push_back(to_json(table, impact));
    }
    for (const GroupImpact& sum : table.groups) {
        groups.push_back({{"group", sum.group},
                          {"at_size_of_interest", by_parameter(table, sum.at_interest)},
                          {"at_estimate", by_parameter(table, sum.at_estimate)},
                          {"by_stderr", by_parameter(table, sum.by_error)}});
    }
    return {{"single", impacts}, {"groups", groups}};
}

namespace {

Json odd_file_json(const StudyDiagnosis& d) {
    const auto odd = odd_recording(d);
    if (!odd) return {};
    return {{"file", odd->file},
            {"observable", odd->observable == 0 ? "shear_stress" : "solid_fraction"},
            {"deviation", odd->deviation},
            {"others", odd->others},
            {"files", odd->files},
            {"p", odd->p},
            {"stands_out", odd->stands_out()}};
}

}  // namespace

Json to_json(const StudyDiagnosis& d, const Checks& checks,
             const std::optional<ImpactTable>& impacts, const Study& study,
             const DiagnosisTexts& texts) {
    Json json = verdict_json(d.diagnosis, *d.models, d.evidence, checks);
    json["sentence"] = texts.verdict;
    json["discrepancy"] = d.discrepancy;
    json["holds_up_to"] =
        d.diagnosis.holds_up_to > 0 ? Json(d.discrepancy[0] * d.diagnosis.holds_up_to) : Json();
    json["readings"] = {{"measured", d.measured}, {"tested", d.readings.size()}};
    json["recordings"] = recordings_json(d.recordings);
    json["odd_file"] = odd_file_json(d);
    json["model_effects"] = names_of(study.model.effects);
    json["rivals"] = rivals_json(d.rivals);
    json["proposed"] = proposals_json(d.proposals, texts.proposals);
    json["runs"] = runs_json(d.models->simulation().emulator().runs());
    json["confirmed"] = confirmation_json(d.confirmed, texts.open);
    json["to_do"] = texts.to_do;
    json["impact"] = impacts ? to_json(*impacts) : Json();
    add_belief(json, d.belief);
    return json;
}

namespace {

Json point_json(const Point& point, const Study& study) {
    if (point.direct) {
        return {{"direct", point.direct->parameter},
                {"unit", point.direct->unit},
                {"stderr", point.direct->standard_error}};
    }
    const Condition& c = point.condition;
    Json json = {{"normal_stress", c.normal_stress},
                 {"inertial_number", c.inertial_number},
                 {"shear_rate", shear_rate_at(c.inertial_number, c.normal_stress, study.grains)},
                 {"liquid_content", c.liquid_content}};
    if (c.bead_volume) {
        json["bead_mass"] = mass_of(c, study);
    }
    if (const auto set = set_point_of(c, study)) {
        json["normal_force"] = set->normal_force;
        json["angular_velocity"] = set->angular_velocity;
    }
    json["time"] = c.time;
    json["wait"] = point.wait;
    return json;
}

Json forecast_json(const std::string& name, const Forecast& forecast) {
    const Eigen::VectorXd error = error_of(forecast);
    if (error.size() == 1) {
        return {{"rival", name}, {"direct", uncertain(forecast.value(0), error(0))}};
    }
    return {{"rival", name},
            {"shear_stress", uncertain(forecast.value(0), error(0))},
            {"solid_fraction", uncertain(forecast.value(1), error(1))}};
}

Json plan_json(const NextMeasurement& next, const Plan& plan) {
    Json json = {{"point", point_json(next.points[plan.point], next.study)},
                 {"repeats", plan.repeats},
                 {"cost", plan.cost},
                 {"criterion", plan.separation},
                 {"separated", Json::array()},
                 {"forecasts", Json::array()}};
    for (const auto& [i, j] : plan.separated) {
        json["separated"].push_back({next.rivals[i].name, next.rivals[j].name});
    }
    for (std::size_t k = 0; k < next.rivals.size(); ++k) {
        json["forecasts"].push_back(forecast_json(next.rivals[k].name, plan.forecasts[k]));
    }
    return json;
}

Json series_json(const NextMeasurement& next) {
    Json json = {{"readings", next.series.readings()},
                 {"cost", next.series.cost},
                 {"separated", Json::array()},
                 {"steps", Json::array()}};
    for (const auto& [i, j] : next.series.separated) {
        json["separated"].push_back({next.rivals[i].name, next.rivals[j].name});
    }
    for (const Series::Step& step : next.series.steps) {
        Json one = {{"point", point_json(next.points[step.point], next.study)},
                    {"readings", step.readings},
                    {"forecasts", Json::array()}};
        const Plan& plan = plan_at(next, step.point);
        for (std::size_t k = 0; k < next.rivals.size(); ++k) {
            one["forecasts"].push_back(forecast_json(next.rivals[k].name, plan.forecasts[k]));
        }
        json["steps"].push_back(std::move(one));
    }
    return json;
}

}  // namespace

Json to_json(const NextMeasurement& next) {
    Json json = {{"rivals", Json::array()}};
    for (const FittedModel& rival : next.rivals) {
        json["rivals"].push_back(rival.name);
    }
    if (!next.plans.empty()) {
        constexpr std::size_t others = 4;  // chosen: in case the best point cannot be measured
        json["separable"] = !next.series.steps.empty();
        json["series"] = series_json(next);
        const Plan& shown = shown_plan(next);
        json.update(plan_json(next, shown));
        json["others"] = Json::array();
        for (const Plan& plan : next.plans) {
            if (&plan != &shown && json["others"].size() < others) {
                json["others"].push_back(plan_json(next, plan));
            }
        }
        return json;
    }
    if (next.sharpenings.empty()) return json;
    const Sharpening& best = next.sharpenings.front();
    json["point"] = point_json(next.points[best.point], next.study);
    json["repeats"] = next.most_repeats;
    json["standard_errors"] = Json::object();
    const auto& parameters = next.rivals.front().predictor->parameters();
    for (std::size_t k = 0; k < parameters.size(); ++k) {
        const auto i = static_cast<Eigen::Index>(k);
        json["standard_errors"][parameters[k].name] = {
            {"before", std::sqrt(next.rivals.front().fit.covariance(i, i))},
            {"after", best.standard_errors(i)}};
    }
    return json;
}

Json to_json(const NextMeasurement& next, const StudyDiagnosis& diagnosis,
             const std::vector<std::string>& to_do) {
    Json json = to_json(next);
    json["verdict"] = to_string(diagnosis.diagnosis.verdict);
    json["runs"] = runs_json(diagnosis.models->simulation().emulator().runs());
    json["to_do"] = to_do;
    return json;
}

EffectNames rivals_in(const std::filesystem::path& file, const Study& study,
                      const std::string& effect) {
    std::error_code error;
    if (!std::filesystem::exists(file, error)) return {};
    try {
        const auto json = Json::parse(read_text(file));
        check_json_format(json, file, "diagnose again");
        const EffectNames sets = json.at("confidence_set");
        const bool same = json.at("model_effects") == Json(names_of(study.model.effects));
        return same ? rivals_among(sets, effect) : EffectNames{};
    } catch (const std::exception&) {
        return {};  // the file is from another version or is not of a diagnosis
    }
}

}  // namespace pendular
