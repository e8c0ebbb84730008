#include "analysis/ladder.h"

#include <fmt/format.h>

#include <algorithm>
#include <boost/math/distributions/chi_squared.hpp>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#include <utility>

#include "data/input_error.h"
#include "data/json_text.h"
#include "data/text_file.h"

namespace pendular {
namespace {

using Json = nlohmann::ordered_json;

std::vector<std::string> sorted(std::vector<std::string> names) {
    std::ranges::sort(names);
    return names;
}

/// Whether two rungs are of the same study, up to what fresh runs may change.
bool same_study(const Rung& a, const Rung& b) {
    return sorted(a.effects) == sorted(b.effects) && a.dof == b.dof &&
           std::abs(a.chi2 - b.chi2) <= 0.05 * (std::max(a.chi2, b.chi2) + a.dof);
}

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

const RungParameter* Rung::find(const std::string& name) const {
    const auto found = std::ranges::find(parameters, name, &RungParameter::name);
    return found == parameters.end() ? nullptr : &*found;
}

Rung rung_of(const Calibration& c, const Comparison& comparison,
             const std::optional<LeftOut>& left_out) {
    Rung rung;
    for (const auto& listed : c.model.effects) {
        rung.effects.push_back(listed.name);
    }
    for (std::size_t k = 0; k < c.parameters.size(); ++k) {
        const auto i = static_cast<Eigen::Index>(k);
        rung.parameters.push_back({c.parameters[k].name, c.parameters[k].unit, c.fit.parameters(i),
                                   c.fit.standard_error(i)});
    }
    rung.chi2 = comparison.total.chi2;
    rung.dof = comparison.total.dof;
    rung.rms_percent = comparison.rms_percent;
    if (left_out) {
        rung.left_out_percent = left_out->rms_percent;
    }
    return rung;
}

void climb(Ladder& ladder, Rung before, Rung after) {
    const auto append = [&](Rung& rung) {
        rung.step = ladder.empty() ? 0 : ladder.back().step + 1;
        ladder.push_back(std::move(rung));
    };
    if (ladder.empty() || !same_study(ladder.back(), before)) {
        before.change = "start";
        before.effect.clear();
        append(before);
    }
    append(after);
}

bool fell_by_chance(const Rung& from, const Rung& to) {
    // Where nothing more is fitted, chi2 may still change, as with a switch: as by one parameter.
    const boost::math::chi_squared law(std::max(1, from.dof - to.dof));
    return from.chi2 - to.chi2 <= boost::math::quantile(law, 0.95);
}

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
