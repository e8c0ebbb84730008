#include "workflow/json/measurements.h"

#include <cmath>
#include <nlohmann/json.hpp>

#include "data/remarks/wording.h"
#include "workflow/json/parts.h"

namespace pendular {
namespace {

Json number_or_null(double value) {
    return std::isfinite(value) ? Json(value) : Json();
}

Json number_or_null(const std::optional<double>& value) {
    return value ? number_or_null(*value) : Json();
}

Json columns_json(const Block& block) {
    Json columns = Json::array();
    for (const BlockColumn& column : block.columns) {
        if (column.name.empty()) continue;
        columns.push_back({{"name", column.name},
                           {"unit", column.unit},
                           {"quantity", column.quantity.empty() ? Json() : Json(column.quantity)},
                           {"of_errors", column.of_errors}});
    }
    return columns;
}

Json interval_json(const FileView& view, std::size_t i) {
    const Block& block = view.file.blocks[i];
    const IntervalSeries& series = view.series[i];
    return {{"number", block.number},
            {"name", block.name},
            {"test", block.test},
            {"role", view.roles[i].role},
            {"why", view.roles[i].reason},
            {"rows", series.size()},
            {"declared_rows", block.declared_rows ? Json(*block.declared_rows) : Json()},
            {"first_line", series.line.empty() ? Json() : Json(series.line.front())},
            {"last_line", series.line.empty() ? Json() : Json(series.line.back())},
            {"columns", columns_json(block)}};
}

Json errors_json(const std::optional<LocusErrors>& errors) {
    if (!errors) return {};
    return {{"cohesion", errors->cohesion},
            {"slope_angle", errors->slope_angle},
            {"tensile_strength", number_or_null(errors->tensile_strength)},
            {"unconfined_strength", errors->unconfined_strength},
            {"major_principal_stress", number_or_null(errors->major_principal_stress)},
            {"effective_angle", number_or_null(errors->effective_angle)},
            {"flowability", number_or_null(errors->flowability)}};
}

Json line_json(const std::optional<LinearYieldLocus>& line) {
    if (!line) return {};
    return {{"cohesion", line->cohesion},
            {"intercept", line->intercept},
            {"slope_angle", line->slope_angle},
            {"tensile_strength", number_or_null(line->tensile_strength)},
            {"unconfined_strength", line->unconfined_strength},
            {"major_principal_stress", number_or_null(line->major_principal_stress)},
            {"effective_angle", number_or_null(line->effective_angle)},
            {"flowability", number_or_null(line->flowability)},
            {"flow_class", line->flow_class},
            {"stderr", errors_json(line->errors)}};
}

Json locus_json(const YieldLocus& locus) {
    Json points = Json::array();
    for (const FailurePoint& point : locus.points)
        points.push_back({{"interval", point.interval},
                          {"line", point.line},
                          {"normal_stress", point.normal_stress},
                          {"shear_stress", point.shear_stress},
                          {"smoothed_normal_stress", point.smoothed_normal_stress},
                          {"smoothed_shear_stress", point.smoothed_shear_stress},
                          {"at_end", point.at_end},
                          {"height", number_or_null(point.height)},
                          {"prorating", number_or_null(point.prorating)}});
    Json preshear;
    if (locus.preshear)
        preshear = {{"normal_stress", locus.preshear->normal_stress},
                    {"shear_stress", number_or_null(locus.preshear->shear_stress)},
                    {"shear_stress_stderr", number_or_null(locus.preshear->shear_stress_error)},
                    {"bulk_density", number_or_null(locus.preshear->bulk_density)},
                    {"plateau", locus.preshear->plateau}};
    return {{"test", locus.test},
            {"preshear", preshear},
            {"prorated", locus.prorated},
            {"points", points},
            {"line", line_json(locus.line)},
            {"smoothed", line_json(locus.smoothed)}};
}

Json wall_json(const WallLocus& wall) {
    Json points = Json::array(), errors;
    for (const WallPoint& point : wall.points)
        points.push_back({{"line", point.line},
                          {"normal_stress", point.normal_stress},
                          {"shear_stress", point.shear_stress}});
    if (wall.errors)
        errors = {{"coefficient", wall.errors->coefficient},
                  {"adhesion", wall.errors->adhesion},
                  {"slope", wall.errors->slope}};
    return {{"test", wall.test},         {"points", points},    {"coefficient", wall.coefficient},
            {"adhesion", wall.adhesion}, {"slope", wall.slope}, {"stderr", errors}};
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
                                 {"freedom_shear_stress", number_or_null(group.freedom(0))},
                                 {"freedom_solid_fraction", number_or_null(group.freedom(1))}});
    }
    for (const Eigen::Index o : {0, 1}) {
        const std::string name = o == 0 ? "shear_stress" : "solid_fraction";
        json["load_exponent"][name] = scatter.load_exponent(o);
        const auto& filling = scatter.filling[static_cast<std::size_t>(o)];
        json["fillings"][name] = std::sqrt(filling.variance);
        json["fillings"]["freedom_" + name] = number_or_null(filling.freedom_between);
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
                      {"height", number_or_null(r.condition.height)},
                      {"bead_volume", number_or_null(r.condition.bead_volume)},
                      {"time", r.condition.time},
                      {"replicates", r.replicates},
                      {"error_assumed", r.error_assumed}};
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

Json to_json(const FileView& view) {
    Json json = {{"file", view.file.file},
                 {"layout", view.file.layout},
                 {"encoding", view.file.encoding},
                 {"delimiter", std::string(1, view.file.delimiter)},
                 {"decimal", std::string(1, view.file.numbers.decimal)},
                 {"facts", Json::array()},
                 {"intervals", Json::array()},
                 {"findings", Json::array()},
                 {"left_out", Json::array()},
                 {"yield_loci", Json::array()},
                 {"wall_loci", Json::array()},
                 {"missing", view.missing}};
    for (const Fact& fact : view.file.facts)
        json["facts"].push_back({{"key", fact.key}, {"value", fact.value}, {"line", fact.line}});
    for (std::size_t i = 0; i < view.series.size(); ++i)
        json["intervals"].push_back(interval_json(view, i));
    for (const Remark& finding : view.findings)
        json["findings"].push_back(file_finding_json(finding));
    for (const Remark& rows : view.file.skipped)
        json["left_out"].push_back({{"first_line", rows.first_line()},
                                    {"last_line", rows.last_line()},
                                    {"reason", text_of(rows)}});
    for (const YieldLocus& locus : view.loci)
        json["yield_loci"].push_back(locus_json(locus));
    for (const WallLocus& wall : view.walls)
        json["wall_loci"].push_back(wall_json(wall));
    return json;
}

}  // namespace pendular
