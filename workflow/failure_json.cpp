#include "workflow/failure_json.h"

#include <nlohmann/json.hpp>

namespace pendular {

nlohmann::ordered_json to_json(const Checks& checks) {
    nlohmann::ordered_json all = nlohmann::ordered_json::array();
    for (const Check& check : checks.all) {
        all.push_back({{"kind", to_string(check.kind)},
                       {"covariate", check.covariate},
                       {"of", check.of},
                       {"statistic", check.statistic},
                       {"p", check.p}});
    }
    return {{"p", checks.p}, {"checks", all}};
}

nlohmann::ordered_json to_json(const WhereItFails& where) {
    nlohmann::ordered_json json = to_json(where.checks);
    json["offending"] = nlohmann::ordered_json::array();
    for (const DeviatingGroup& offending : where.offending) {
        json["offending"].push_back({{"readings", offending.readings}, {"p", offending.p}});
    }
    return json;
}

}  // namespace pendular
