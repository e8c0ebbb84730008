#include "workflow/json/fit.h"

#include <fmt/format.h>

#include <array>
#include <limits>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "data/files/json_text.h"
#include "data/files/text_file.h"
#include "data/input_error.h"
#include "workflow/json/parts.h"

namespace pendular {
namespace {

Json pair_json(const std::array<double, 2>& pair) {
    return {{"shear_stress", pair[0]}, {"solid_fraction", pair[1]}};
}

std::array<double, 2> pair_from(const Json& json) {
    return {json.at("shear_stress").get<double>(), json.at("solid_fraction").get<double>()};
}

/// Number from JSON; not a number from null, which is how such numbers are written.
double number_from(const Json& json) {
    return json.is_null() ? std::numeric_limits<double>::quiet_NaN() : json.get<double>();
}

LadderStep ladder_step_from(const Json& json) {
    LadderStep ladder_step{.step = json.at("step"),
                           .change = json.at("change"),
                           .effect = json.at("effect"),
                           .effects = json.at("effects"),
                           .rivals = json.value("rivals", decltype(LadderStep::rivals)()),
                           .parameters = {},
                           .chi2 = json.at("chi2"),
                           .dof = json.at("dof"),
                           .rms_percent = pair_from(json.at("rms_percent")),
                           .left_out_percent = {},
                           .when = json.value("when", "")};
    if (ladder_step.change != "start" && ladder_step.change != "add" &&
        ladder_step.change != "drop") {
        throw std::invalid_argument(fmt::format("no change is called '{}'", ladder_step.change));
    }
    for (const auto& [name, parameter] : json.at("parameters").items()) {
        ladder_step.parameters.push_back({name, parameter.at("unit"),
                                          number_from(parameter.at("value")),
                                          number_from(parameter.at("stderr"))});
    }
    if (!json.at("left_out_percent").is_null()) {
        ladder_step.left_out_percent = pair_from(json.at("left_out_percent"));
    }
    return ladder_step;
}

Ladder ladder_from(const Json& json) {
    Ladder ladder;
    for (const auto& ladder_step : json.at(json.contains("rungs") ? "rungs" : "ladder_steps")) {
        ladder.push_back(ladder_step_from(ladder_step));
    }
    return ladder;
}

}  // namespace

Json to_json(const LadderStep& ladder_step) {
    Json json = {
        {"step", ladder_step.step},     {"change", ladder_step.change},
        {"effect", ladder_step.effect}, {"effects", ladder_step.effects},
        {"rivals", ladder_step.rivals}, {"chi2", ladder_step.chi2},
        {"dof", ladder_step.dof},       {"rms_percent", pair_json(ladder_step.rms_percent)},
        {"left_out_percent", nullptr},  {"parameters", Json::object()}};
    if (ladder_step.left_out_percent) {
        json["left_out_percent"] = pair_json(*ladder_step.left_out_percent);
    }
    if (!ladder_step.when.empty()) json["when"] = ladder_step.when;
    for (const LadderParameter& p : ladder_step.parameters) {
        json["parameters"][p.name] = {
            {"value", p.value}, {"stderr", p.standard_error}, {"unit", p.unit}};
    }
    return json;
}

Ladder read_ladder(const std::filesystem::path& file) {
    std::error_code ignored;
    if (!std::filesystem::exists(file, ignored)) {
        return {};
    }
    try {
        const Json json = Json::parse(read_text(file));
        check_json_format(json, file, "move this file away to begin a new ladder");
        return ladder_from(json);
    } catch (const InputError&) {
        throw;
    } catch (const std::exception& error) {
        throw InputError({file.string()},
                         fmt::format("not a complete ladder of a study ({}); nothing was changed: "
                                     "restore the file, or move it away to begin a new ladder",
                                     error.what()));
    }
}

void write_ladder(const std::filesystem::path& file, const Ladder& ladder) {
    Json json = {{"ladder_steps", Json::array()}};
    for (const LadderStep& ladder_step : ladder) {
        json["ladder_steps"].push_back(to_json(ladder_step));
    }
    write_json(file, json);
}

}  // namespace pendular
