#include "workflow/json.h"

#include <cmath>
#include <nlohmann/json.hpp>

#include "data/files/json_text.h"
#include "data/files/write_whole.h"
#include "data/remarks/wording.h"
#include "workflow/failure_json.h"
#include "workflow/json_parts.h"
#include "workflow/run_json.h"

namespace pendular {
namespace {
using Json = nlohmann::ordered_json;
}  // namespace

namespace {

/// JSON of degrees of freedom; null where they are infinite, for a scatter that is exactly known.
Json freedom_json(double freedom) {
    return std::isfinite(freedom) ? Json(freedom) : Json();
}

Json scatter_json(const ReplicateScatter& scatter) {
    Json json = {{"stated", scatter.stated},
                 {"normal_stress", scatter.reference_stress},
                 {"steps", Json::array()},
                 {"load_exponent", Json::object()},
                 {"fillings", Json::object()}};
    for (const auto& group : scatter.groups) {
        json["steps"].push_back({{"files", group.files},
                                 {"shear_stress", std::sqrt(group.excess(0, 0))},
                                 {"solid_fraction", std::sqrt(group.excess(1, 1))},
                                 {"freedom_shear_stress", freedom_json(group.freedom(0))},
                                 {"freedom_solid_fraction", freedom_json(group.freedom(1))}});
    }
    for (const Eigen::Index o : {0, 1}) {
        const std::string name = o == 0 ? "shear_stress" : "solid_fraction";
        json["load_exponent"][name] = scatter.load_exponent(o);
        const auto& filling = scatter.filling[static_cast<std::size_t>(o)];
        json["fillings"][name] = std::sqrt(filling.variance);
        json["fillings"]["freedom_" + name] = freedom_json(filling.freedom_between);
    }
    return json;
}

}  // namespace

Json to_json(const Measurements& measurements) {
    Json json;
    json["readings"] = Json::array();
    for (const auto& r : measurements.readings) {
        Json entry = {{"file", r.origin.file},
                      {"line", r.origin.line},
                      {"step", r.step},
                      {"normal_stress", r.condition.normal_stress},
                      {"shear_rate", r.shear_rate},
                      {"inertial_number", r.condition.inertial_number},
                      {"liquid_content", r.condition.liquid_content},
                      {"failure", r.condition.at_failure},
                      {"height", nullptr},
                      {"bead_volume", nullptr},
                      {"time", r.condition.time},
                      {"replicates", r.replicates},
                      {"error_assumed", r.error_assumed}};
        if (r.condition.height) {
            entry["height"] = *r.condition.height;
        }
        if (r.condition.bead_volume) {
            entry["bead_volume"] = *r.condition.bead_volume;
        }
        entry.update(pair_of(r.value, r.covariance));
        entry["covariance"] = r.covariance(0, 1);
        json["readings"].push_back(entry);
    }
    json["excluded"] = Json::array();
    for (const Remark& rows : measurements.left_out()) {
        json["excluded"].push_back({{"file", rows.file()},
                                    {"first_line", rows.first_line()},
                                    {"last_line", rows.last_line()},
                                    {"reason", text_of(rows)}});
    }
    json["scatter"] = scatter_json(measurements.scatter);
    json["doubts"] = Json::array();
    for (const Remark& doubt : measurements.doubts()) {
        json["doubts"].push_back({{"what", text_of(doubt)},
                                  {"quantity", doubt.quantity},
                                  {"readings", doubt.lines.size()},
                                  {"set_aside", doubt.outcome == Remark::Outcome::set_aside}});
    }
    json["findings"] = findings_json(measurements.faults(true));
    json["file_findings"] = Json::array();
    for (const Remark& fault : measurements.faults(false))
        json["file_findings"].push_back(file_finding_json(fault));
    json["notes"] = Json::array();
    for (const Remark& note : measurements.notes())
        json["notes"].push_back(text_of(note));
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
        one["normalised"] = direct.normalised();
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
            {"normalised",
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

void write_json(const std::filesystem::path& file, const Json& json) {
    write_whole(file, json_text(json));
}

}  // namespace pendular
