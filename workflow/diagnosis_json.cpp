#include "workflow/diagnosis_json.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "workflow/failure_json.h"
#include "workflow/run_json.h"

namespace pendular {
namespace {

nlohmann::ordered_json to_json(const Finding& finding, Decision decision, const ModelSpace& space) {
    const Candidate& candidate = space.candidates()[finding.candidate];
    const EffectParameter& p = candidate.parameters.front();
    nlohmann::ordered_json json = {
        {"effect", candidate.name},
        {"parameter", p.name},
        {"unit", p.unit},
        {"predicted_drop", finding.test.predicted_reduction},
        {"estimate", uncertain(finding.value, finding.standard_error)},
        {"absorbed", finding.test.share_imitated},
        {"power", finding.power},
        {"p", finding.p},
        {"decision", to_string(decision)},
        {"refit_drop", nullptr},
        {"identifiable", finding.identifiable},
        {"detectable", nullptr},
        {"noncentrality_that_matters", finding.test.information},
    };
    if (finding.refitted_reduction) {
        json["refit_drop"] = *finding.refitted_reduction;
    }
    if (std::isfinite(finding.detectable) && finding.test.seen()) {
        json["detectable"] = finding.detectable;
    }
    return json;
}

nlohmann::ordered_json to_json(const FittedModel& explanation, const ModelSpace& space,
                               const Evidence& evidence) {
    nlohmann::ordered_json parameters = nlohmann::ordered_json::object();
    const auto all = space.with(explanation.chosen)->parameters();
    for (std::size_t k = 0; k < all.size(); ++k) {
        const auto i = static_cast<Eigen::Index>(k);
        parameters[all[k].name] =
            uncertain(explanation.fit.parameters(i), explanation.fit.standard_error(i));
    }
    nlohmann::ordered_json json = {{"effects", names_of(explanation, space)},
                                   {"parameters", parameters},
                                   {"chi2", explanation.fit.chi2},
                                   {"dof", explanation.fit.dof},
                                   {"lack_of_fit_p", explanation.lack_of_fit_p},
                                   {"further_p", explanation.further_p},
                                   {"accepted", explanation.accepted}};
    if (explanation.suspect) {
        json["suspect"] = evidence.suspects[*explanation.suspect].name;
    }
    return json;
}

/// JSON with, for each effect that the verdict names, the share of the excess chi2 - dof [1] that
/// the model with this effect alone explains; null where that model was not refitted.
nlohmann::ordered_json explained_of(const Diagnosis& d, const ModelSpace& space) {
    nlohmann::ordered_json json = nlohmann::ordered_json::object();
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
nlohmann::ordered_json cosines_of(const Diagnosis& d) {
    nlohmann::ordered_json json = nlohmann::ordered_json::object();
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

}  // namespace

std::vector<std::string> names_of(const FittedModel& explanation, const ModelSpace& space) {
    std::vector<std::string> names;
    for (const std::size_t k : explanation.chosen) {
        names.push_back(space.candidates()[k].name);
    }
    return names;
}

nlohmann::ordered_json to_json(const Diagnosis& d, const ModelSpace& space,
                               const Evidence& evidence, const Checks& checks) {
    nlohmann::ordered_json sets = nlohmann::ordered_json::array(),
                           scan = nlohmann::ordered_json::array(),
                           tried = nlohmann::ordered_json::array(),
                           suspects = nlohmann::ordered_json::array();
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
    nlohmann::ordered_json parameters = nlohmann::ordered_json::object();
    const auto all = space.with({})->parameters();
    for (std::size_t k = 0; k < all.size(); ++k) {
        const auto i = static_cast<Eigen::Index>(k);
        parameters[all[k].name] = uncertain(d.base.fit.parameters(i), d.base.fit.standard_error(i));
    }
    return {{"verdict", to_string(d.verdict)},
            {"complete", d.complete},
            {"effects", d.effects},
            {"explained", explained_of(d, space)},
            {"suspects", d.suspects},
            {"confidence_set", sets},
            {"cosines", cosines_of(d)},
            {"chi2", d.base.fit.chi2},
            {"dof", d.dof},
            {"lack_of_fit_p", d.base.lack_of_fit_p},
            {"further_p", d.base.further_p},
            {"errors_assumed", d.errors_assumed},
            {"parameters", parameters},
            {"where", to_json(checks)},
            {"scan", scan},
            {"refits", tried},
            {"suspect_tests", suspects}};
}

}  // namespace pendular
