#include "data/study/rig.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "data/study/study_table.h"

namespace pendular {
namespace {

const std::vector<std::string> rig_keys = {
    "normal_stress", "inertial_number", "shear_rate", "liquid_contents", "bead_mass",
    "repeats",       "readings",        "wet_cost",   "filling_cost",    "wait",
    "hour_cost",     "direct"};

/// Range of a key that has one value or the two ends of a range, in SI units; empty if the key is
/// missing.
/// @throws InputError for more than two values and for values that are not positive
std::optional<Span> span(const StudyTable& table, std::string_view key, std::string_view unit) {
    const std::vector<double> values = table.quantities(key, unit);
    if (values.empty()) return std::nullopt;
    if (values.size() > 2) table.refuse(key, "takes one value, or the least and the greatest");
    const auto [least, greatest] = std::ranges::minmax(values);
    if (!(least > 0)) table.refuse(key, "must be positive");
    return Span{least, greatest};
}

double cost(const StudyTable& table, std::string_view key, double by_default) {
    const double value = table.quantity(key, "1").value_or(by_default);
    if (value < 0) table.refuse(key, "must not be negative");
    return value;
}

int count(const StudyTable& table, std::string_view key, int by_default) {
    const double value = table.quantity(key, "1").value_or(by_default);
    if (value < 1 || value > 1000 || value != std::floor(value))
        table.refuse(key, "must be a whole number from 1 to 1000");
    return static_cast<int>(value);
}

Word required(const StudyTable& table, std::string_view key, const char* what) {
    if (auto word = table.stated(key)) return *word;
    throw InputError(table.position(),
                     fmt::format("{} lacks '{}'; add {}", table.name(), key, what));
}

StatedDirect read_one(const StudyTable& table) {
    const Word effect = required(
                   table, "effect",
                   "the effect that was or can be measured, such as effect = \"torque-offset\""),
               error = required(table, "error", "the standard error with its unit");
    StatedDirect stated;
    stated.effect = effect.text, stated.effect_position = effect.position;
    stated.error = error.text, stated.error_position = error.position;
    return stated;
}

}  // namespace

std::vector<StatedDirect> read_direct(const StudyTable& root) {
    std::vector<StatedDirect> all;
    for (const StudyTable& table : root.tables("direct", {"effect", "value", "error"})) {
        all.push_back(read_one(table));
        const Word value = required(table, "value", "the measured value with its unit");
        if (value.text.empty()) table.refuse("value", "is empty; write the measured value");
        all.back().value = value.text, all.back().value_position = value.position;
    }
    return all;
}

std::vector<StatedDirect> read_direct_of_rig(const StudyTable& rig) {
    std::vector<StatedDirect> all;
    for (const StudyTable& table : rig.tables("direct", {"effect", "error", "cost"})) {
        all.push_back(read_one(table));
        all.back().cost = table.quantity("cost", "1").value_or(1);
        if (!(all.back().cost > 0)) table.refuse("cost", "must be positive");
    }
    return all;
}

std::optional<Rig> read_rig(const StudyTable& root, const GrainProperties& grains,
                            bool has_liquid) {
    const auto table = root.table("rig", rig_keys);
    if (!table) return std::nullopt;
    Rig rig;
    const auto stress = span(*table, "normal_stress", "Pa");
    if (!stress)
        throw InputError(
            table->position(),
            "[rig] lacks 'normal_stress'; add its ends, as in [\"0.3 kPa\", \"3 kPa\"]");
    rig.normal_stress = *stress;
    rig.inertial_number = span(*table, "inertial_number", "1");
    rig.shear_rate = span(*table, "shear_rate", "1/s");
    if (rig.inertial_number.has_value() == rig.shear_rate.has_value())
        throw InputError(table->position(),
                         "[rig] needs either 'inertial_number' or 'shear_rate', one of the two");
    if (table->has("liquid_contents"))
        rig.liquid_contents = table->quantities("liquid_contents", "1");
    for (const double content : rig.liquid_contents) {
        if (content < 0) table->refuse("liquid_contents", "must not be negative");
        if (content > 0 && !has_liquid)
            table->refuse("liquid_contents", "has a value above 0, but the study has no [liquid]");
    }
    for (const double mass : table->quantities("bead_mass", "kg")) {
        if (!(mass > 0)) table->refuse("bead_mass", "must be positive");
        rig.bead_volumes.push_back(mass / grains.density);
    }
    rig.repeats = count(*table, "repeats", rig.repeats);
    rig.readings = count(*table, "readings", rig.readings);
    rig.wet_cost = cost(*table, "wet_cost", rig.wet_cost);
    if (!(rig.wet_cost > 0)) table->refuse("wet_cost", "must be positive");
    rig.filling_cost = cost(*table, "filling_cost", rig.filling_cost);
    if (table->has("wait")) rig.waits = table->quantities("wait", "s");
    if (std::ranges::min(rig.waits) < 0) table->refuse("wait", "must not be negative");
    rig.hour_cost = cost(*table, "hour_cost", rig.hour_cost);
    rig.direct = read_direct_of_rig(*table);
    return rig;
}

InstrumentTable read_instrument(const StudyTable& root) {
    InstrumentTable instrument;
    const auto table = root.open_table("instrument");
    if (!table) return instrument;
    for (const std::string& name : table->keys()) {
        if (name == "class") {
            instrument.kind = table->choice("class", {"rheometer", "table"}) == "table"
                                  ? InstrumentTable::Class::table
                                  : InstrumentTable::Class::rheometer;
            instrument.class_position = table->at("class");
            continue;
        }
        const Word value = table->stated(name).value();
        instrument.stated.push_back({name, value.text, value.position});
    }
    return instrument;
}

}  // namespace pendular
