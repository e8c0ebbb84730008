#include "workflow/ladder_file.h"

#include <fmt/format.h>

#include <array>
#include <limits>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "data/files/json_text.h"
#include "data/files/text_file.h"
#include "data/input_error.h"

namespace pendular {
namespace {

using Json = nlohmann::ordered_json;

Json pair_json(const std::array<double, 2>& pair) {
    return {{"shear_stress", pair[0]}, {"solid_fraction", pair[1]}};
}

std::array<double, 2> pair_from(const Json& json) {
    return {json.at("shear_stress").get<double>(), json.at("solid_fraction").get<double>()};
}

/// A number that is no number is null in JSON.
double number_from(const Json& json) {
    return json.is_null() ? std::numeric_limits<double>::quiet_NaN() : json.get<double>();
}

Rung rung_from(const Json& json) {
    Rung rung{.step = json.at("step"),
              .change = json.at("change"),
              .effect = json.at("effect"),
              .effects = json.at("effects"),
              .parameters = {},
              .chi2 = json.at("chi2"),
              .dof = json.at("dof"),
              .rms_percent = pair_from(json.at("rms_percent")),
              .left_out_percent = {}};
    if (rung.change != "start" && rung.change != "add" && rung.change != "drop") {
        throw std::invalid_argument(fmt::format("no change is called '{}'", rung.change));
    }
    for (const auto& [name, parameter] : json.at("parameters").items()) {
        rung.parameters.push_back({name, parameter.at("unit"), number_from(parameter.at("value")),
                                   number_from(parameter.at("stderr"))});
    }
    if (!json.at("left_out_percent").is_null()) {
        rung.left_out_percent = pair_from(json.at("left_out_percent"));
    }
    return rung;
}

Ladder ladder_from(const Json& json) {
    Ladder ladder;
    for (const auto& rung : json.at("rungs")) {
        ladder.push_back(rung_from(rung));
    }
    return ladder;
}

}  // namespace

Json to_json(const Rung& rung) {
    Json json = {{"step", rung.step},
                 {"change", rung.change},
                 {"effect", rung.effect},
                 {"effects", rung.effects},
                 {"chi2", rung.chi2},
                 {"dof", rung.dof},
                 {"rms_percent", pair_json(rung.rms_percent)},
                 {"left_out_percent", nullptr},
                 {"parameters", Json::object()}};
    if (rung.left_out_percent) {
        json["left_out_percent"] = pair_json(*rung.left_out_percent);
    }
    for (const RungParameter& p : rung.parameters) {
        json["parameters"][p.name] = {
            {"value", p.value}, {"stderr", p.standard_error}, {"unit", p.unit}};
    }
    return json;
}

Ladder read_ladder(const std::filesystem::path& file) {
    if (!std::filesystem::exists(file)) {
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
                         fmt::format("not the ladder of a study, or cut off ({}); nothing was "
                                     "changed: put back a whole one, or move this file away to "
                                     "begin a new ladder",
                                     error.what()));
    }
}

void write_ladder(const std::filesystem::path& file, const Ladder& ladder) {
    Json json = {{"rungs", Json::array()}};
    for (const Rung& rung : ladder) {
        json["rungs"].push_back(to_json(rung));
    }
    write_whole(file, json_text(json));
}

}  // namespace pendular
