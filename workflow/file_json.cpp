#include "workflow/file_json.h"

#include <cmath>
#include <nlohmann/json.hpp>

#include "data/remarks/wording.h"
#include "workflow/json_parts.h"

namespace pendular {
namespace {

using Json = nlohmann::ordered_json;

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
                           {"quantity", column.quantity.empty() ? Json() : Json(column.quantity)}});
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
            {"flow_class", line->flow_class}};
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
                          {"height", number_or_null(point.height)}});
    Json preshear;
    if (locus.preshear)
        preshear = {{"normal_stress", locus.preshear->normal_stress},
                    {"shear_stress", locus.preshear->shear_stress},
                    {"plateau", locus.preshear->plateau}};
    return {{"test", locus.test},
            {"preshear", preshear},
            {"points", points},
            {"line", line_json(locus.line)},
            {"smoothed", line_json(locus.smoothed)}};
}

}  // namespace

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
    return json;
}

}  // namespace pendular
