#include "workflow/impact_json.h"

#include <cmath>
#include <nlohmann/json.hpp>

namespace pendular {
namespace {

using Json = nlohmann::ordered_json;

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

}  // namespace

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

}  // namespace pendular
