#include "workflow/json/diagnosis.h"

#include <nlohmann/json.hpp>

#include "workflow/json/fit.h"
#include "workflow/json/parts.h"
#include "workflow/json/training_runs.h"

namespace pendular {

Json to_json(const Checks& checks) {
    Json all = Json::array();
    for (const Check& check : checks.all) {
        all.push_back({{"kind", to_string(check.kind)},
                       {"covariate", check.covariate},
                       {"of", check.of},
                       {"statistic", check.statistic},
                       {"p", check.p}});
    }
    return {{"p", checks.p}, {"checks", all}};
}

Json to_json(const WhereItFails& where) {
    Json json = to_json(where.checks);
    json["deviating_groups"] = Json::array();
    for (const DeviatingGroup& offending : where.offending) {
        json["deviating_groups"].push_back({{"readings", offending.readings}, {"p", offending.p}});
    }
    return json;
}

Json to_json(const Comparison& comparison, const std::vector<CohesionLine>& lines,
             const WhereItFails& where) {
    Json json;
    json.update(misfit_json(comparison.total));
    json["fitted"] = misfit_json(comparison.fitted);
    json["predicted_only"] = misfit_json(comparison.predicted);
    json["rms_percent"] = {{"shear_stress", comparison.rms_percent[0]},
                           {"solid_fraction", comparison.rms_percent[1]}};
    json["by_observable"] = {{"shear_stress", comparison.by_observable[0]},
                             {"solid_fraction", comparison.by_observable[1]}};
    json["direct_measurements"] = Json::array();
    for (const DirectMisfit& direct : comparison.direct) {
        Json one = direct_json(direct.measurement);
        one["predicted"] = direct.predicted;
        one["misfit"] = direct.normalised();
        json["direct_measurements"].push_back(std::move(one));
    }
    json["by_condition"] = Json::array();
    for (const auto& group : comparison.by_condition) {
        Json entry = {
            {"normal_stress", group.condition.normal_stress},
            {"inertial_number", group.condition.inertial_number},
            {"liquid_content", group.condition.liquid_content},
            {"failure", group.condition.at_failure},
            {"readings", Json::array()},
            {"chi2", group.chi2},
            {"misfit",
             {{"shear_stress", group.normalised(0)}, {"solid_fraction", group.normalised(1)}}}};
        for (const std::size_t k : group.readings) {
            entry["readings"].push_back(prediction_json(comparison.readings[k]));
        }
        json["by_condition"].push_back(entry);
    }
    json["by_file"] = Json::array();
    for (const auto& file : comparison.by_file) {
        json["by_file"].push_back({{"file", std::filesystem::path(file.file).filename().string()},
                                   {"readings", file.readings},
                                   {"chi2", file.chi2}});
    }
    json["cohesion_lines"] = cohesion_lines_json(lines);
    json["where"] = to_json(where);
    return json;
}

Json to_json(const FittedStudy& compared, const WhereItFails& where) {
    const Calibration& c = compared.calibration;
    Json json = to_json(compared.comparison, c.cohesion_lines, where);
    json["runs"] = runs_json(c.runs, c.known);
    add_belief(json, compared.belief);
    return json;
}

Json to_json(const ChangedStudy& changed) {
    const auto side = [](const LadderStep& ladder_step) {
        Json json = to_json(ladder_step);
        for (const char* of_the_ladder : {"step", "change", "effect", "rivals"}) {
            json.erase(of_the_ladder);
        }
        return json;
    };
    const LadderStep& after = changed.comparable_after().ladder_step;
    const FittedStudy& fit = changed.after;
    Json json = {{"change", changed.change.change == Action::add ? "add" : "drop"},
                 {"effect", changed.change.effect},
                 {"written", changed.written},
                 {"rivals", after.rivals},
                 {"before", side(changed.before.ladder_step)},
                 {"after", side(after)},
                 {"runs", runs_json(fit.calibration.runs, fit.calibration.known)}};
    add_belief(json, fit.belief);
    return json;
}

}  // namespace pendular
