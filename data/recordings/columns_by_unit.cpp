#include "data/recordings/columns_by_unit.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <optional>
#include <stdexcept>
#include <string_view>
#include <utility>
#include <vector>

#include "data/files/column_names.h"
#include "data/files/folded_name.h"
#include "data/files/formats/clock_times.h"
#include "data/files/formats/layouts.h"
#include "data/files/header_cell.h"
#include "data/quantities/number.h"
#include "data/quantities/units.h"
#include "data/recordings/column_kinds.h"
#include "data/recordings/steps.h"
#include "data/recordings/test_kinds.h"

namespace pendular {
namespace {

/// Quantities of which steady shear needs one, and those of them that a unit alone may show. A
/// speed in mm/s may be that of the gap, a force also that on a lever.
struct NeededGroup {
    std::vector<std::string_view> quantities, by_unit;
};

const std::vector<NeededGroup>& groups() {
    static const std::vector<NeededGroup> all = {
        {{"time"}, {"time"}},
        {{"torque", "shear_stress", "lever_force", "stress_ratio"}, {"torque", "shear_stress"}},
        {{"normal_force", "normal_stress"}, {"normal_force", "normal_stress"}},
        {{"height"}, {"height"}},
        {{"rotational_speed", "angular_velocity", "shear_velocity", "shear_rate"},
         {"rotational_speed"}}};
    return all;
}

/// Parts of names of columns, as `folded_name` has them, that are no measured values of a quantity
/// that is needed. Those of up to four letters count at the begin of a word.
struct OtherNames {
    std::string_view quantity;  ///< or the end of its name: "stress" for both; empty: of any
    std::vector<std::string_view> parts;
};

const std::vector<OtherNames>& other_names() {
    static const std::vector<OtherNames> all = {
        {"", {"change",    "anderung",  "delta",   "difference", "differenz", "variation",
              "amplitud",  "ampiezza",  "noise",   "offset",     "residu",    "leerlauf",
              "error",     "desv",      "stabw",   "ecart",      "scarto",    "deviat",
              "increment", "inkrement", "zuwachs", "zunahme",    "accroiss"}},
        {"height",
         {"dilat",    "settl",     "setzung", "tassement", "compaction", "diam",     "durchmesser",
          "radius",   "rayon",     "radio",   "raggio",    "arm",        "lever",    "hebel",
          "levier",   "brazo",     "braccio", "pitch",     "lange",      "length",   "longueur",
          "longitud", "lunghezza", "rough",   "rauheit",   "size",       "grosse",   "wobble",
          "runout",   "eccentric", "exzentr", "extension", "lvdt",       "elongati", "allonge"}},
        {"normal_force",
         {"tangen",  "friction", "reibung", "frottement", "attrito", "friccion", "rozamiento",
          "shear",   "scher",    "cisaill", "taglio",     "cizalla", "radial",   "lateral",
          "seiten",  "quer",     "transv",  "horizontal", "zug",     "pull",     "tensile",
          "tension", "traction", "weight",  "gewicht",    "poids",   "peso",     "drag",
          "lift",    "adhesi",   "cohesi",  "lever",      "hebel",   "buoyan",   "inertia"}},
        {"normal_stress",
         {"fluid", "water", "wasser", "gas", "vapo", "dampf", "hydraul", "pneumat", "supply",
          "tangen"}},
        {"stress", {"air",     "ambient", "umgebung", "atmo",     "luft",    "baro",   "pore",
                    "suction", "succi",   "saug",     "vacuum",   "vakuum",  "capill", "kapill",
                    "modul",   "yield",   "fliess",   "strength", "festigk", "cohesi", "kohasi"}},
        {"torque",
         {"bearing", "lager", "friction", "reibung", "frottement", "attrito", "inertia", "tragheit",
          "idle", "seal", "dichtung", "zero", "null", "energy", "work"}},
        {"rotational_speed", {"fan", "lufter", "ventilat", "pump", "stirrer", "mixer", "entrifug"}},
        {"time",
         {"sampl", "abtast", "interval", "relax", "retard", "delay", "lag", "period", "response",
          "rise", "dead", "half", "date", "datum", "rest", "ruhe", "age", "alter", "constant"}}};
    return all;
}

/// Words of a name, each as `folded_name` has it.
std::vector<std::string> folded_words(std::string_view name) {
    std::vector<std::string> words;
    std::string word;
    for (const char c : name) {
        const auto byte = static_cast<unsigned char>(c);
        if (byte > 0x7f || std::isalnum(byte)) {
            word += c;
        } else if (!word.empty()) {
            words.push_back(folded_name(std::exchange(word, "")));
        }
    }
    if (!word.empty()) words.push_back(folded_name(word));
    return words;
}

/// Whether a name is that of something else than a quantity, by its words.
bool has_words_of_another(std::string_view name, std::string_view quantity) {
    constexpr std::size_t short_part = 4;
    const std::vector<std::string> words = folded_words(name);
    const auto has = [&](std::string_view part) {
        return std::ranges::any_of(words, [&](const std::string& word) {
            return part.size() <= short_part ? word.starts_with(part)
                                             : word.find(part) != std::string::npos;
        });
    };
    // Components across the axis, and changes: "Fx", "Δh".
    const auto across = [](const std::string& word) {
        return word.size() == 2 && (word[1] == 'x' || word[1] == 'y');
    };
    return std::ranges::any_of(words, across) || name.starts_with("Δ") ||
           std::ranges::any_of(other_names(), [&](const OtherNames& each) {
               return quantity.ends_with(each.quantity) && std::ranges::any_of(each.parts, has);
           });
}

/// Whether a name has a factor, as "Torque × 10³": the numbers may be larger or smaller by it.
bool names_factor(std::string_view name) {
    const auto digit_follows = [&](std::string_view sign) {
        const std::size_t at = name.find(sign);
        const std::size_t next =
            at == std::string_view::npos ? at : name.find_first_not_of(' ', at + sign.size());
        return next != std::string_view::npos &&
               std::isdigit(static_cast<unsigned char>(name[next]));
    };
    constexpr std::array<std::string_view, 6> signs = {"×", "·", "⋅", "*", " x", " X"};
    constexpr std::array<std::string_view, 8> powers = {"10^", "10**", "10²", "10³",
                                                        "10⁴", "10⁵",  "10⁶", "10⁻"};
    return std::ranges::any_of(signs, digit_follows) ||
           std::ranges::any_of(powers, [&](std::string_view power) {
               return name.find(power) != std::string_view::npos;
           });
}

/// Whether a name is that of a set point or a limit, or has a factor.
bool says_otherwise(std::string_view name) {
    const std::string folded = folded_name(name);
    const auto has = [&](std::string_view word) { return folded.find(word) != std::string::npos; };
    constexpr std::array<std::string_view, 8> set = {"set",      "soll",    "target", "demand",
                                                     "consigne", "nominal", "limit",  "max"};
    return std::ranges::any_of(set, has) || names_factor(name);
}

/// Whether a unit shows a quantity. A speed needs an angle or minutes, since 1/s and Hz are those
/// of rates and frequencies, and joules are no torque.
bool shows(const std::string& unit, std::string_view quantity) {
    if (!unit_fits(unit, quantity)) return false;
    if (quantity == "torque") return unit.find('J') == std::string::npos;
    if (quantity != "rotational_speed") return true;
    const Unit stated(unit);
    constexpr double minute = 60;
    return !stated.same_dimension(Unit("1/s")) || stated.to_si(minute) == 1;
}

/// Whether numbers may be times: they never fall, and several do not stay the same.
bool may_be_times(const Block& block, std::size_t column) {
    std::optional<double> first, before;
    for (const Row& row : block.table.rows) {
        const auto value = parse_number(row.cells[column].text);
        if (value && before && *value < *before) return false;
        if (value) before = value;
        if (value && !first) first = value;
    }
    return before.has_value() && (*before > *first || block.table.rows.size() == 1);
}

/// Whether all cells of a column with a text are clock times.
bool has_clock_times(const Block& block, std::size_t column) {
    bool any = false;
    for (const Row& row : block.table.rows) {
        const std::string& text = row.cells[column].text;
        if (text.empty()) continue;
        if (!clock_time(text)) return false;
        any = true;
    }
    return any;
}

/// Quantity of a group that a column shows by its unit; empty for none.
std::string_view shown_by(const Block& block, std::size_t index, const NeededGroup& group) {
    const BlockColumn& column = block.columns[index];
    const bool marked =
        parse_header_cell(block.table.header.cells[index].text).mark != ErrorMark::none;
    if (!column.quantity.empty() || !column.set_point_of.empty() || marked) return "";
    // Its name need not say so: "Datum", "Clock".
    const bool of_time = group.by_unit.front() == "time";
    if (of_time && !is_unit(column.unit) && has_clock_times(block, index)) return "time";
    if (column.unit.empty()) return "";
    for (const std::string_view quantity : group.by_unit)
        if (shows(column.unit, quantity) && !names_another(column.name, quantity) &&
            !says_otherwise(column.name) && (quantity != "time" || may_be_times(block, index)))
            return quantity;
    return "";
}

/// Whether another column has a peak in a unit of the same group, as "Shear stress max" beside
/// "Shear stress min": what is left is not what is sought.
bool another_has_the_peak(const Block& block, std::size_t index, const NeededGroup& group) {
    constexpr std::array<std::string_view, 8> peaks = {"max",  "peak",  "spitze",   "pic",
                                                       "pico", "picco", "strength", "resisten"};
    for (std::size_t i = 0; i < block.columns.size(); ++i) {
        const BlockColumn& column = block.columns[i];
        if (i == index || !column.quantity.empty() || column.unit.empty()) continue;
        const std::string folded = folded_name(column.name);
        const auto has = [&](std::string_view word) {
            return folded.find(word) != std::string::npos;
        };
        const auto fits = [&](std::string_view quantity) { return shows(column.unit, quantity); };
        if (std::ranges::any_of(peaks, has) && std::ranges::any_of(group.by_unit, fits))
            return true;
    }
    return false;
}

/// Groups of which a block has no column.
std::vector<const NeededGroup*> missing_groups(const Block& block) {
    std::vector<const NeededGroup*> missing;
    for (const NeededGroup& group : groups())
        if (std::ranges::none_of(group.quantities, [&](std::string_view quantity) {
                return block.has_column(quantity);
            }))
            missing.push_back(&group);
    return missing;
}

/// Rows at which a column of whole numbers changes; empty for any other column.
std::vector<std::size_t> changes_of(const Block& block, std::size_t column) {
    std::vector<std::size_t> changes;
    std::optional<double> before;
    for (std::size_t i = 0; i < block.table.rows.size(); ++i) {
        const auto number = parse_number(block.table.rows[i].cells[column].text);
        if (!number || *number != std::floor(*number)) return {};
        if (before && *number != *before) changes.push_back(i);
        before = number;
    }
    return changes;
}

/// Whole numbers without a unit in a column of no known quantity, with the rows at which they
/// change.
struct Counter {
    BlockColumn column;
    std::vector<std::size_t> changes;
};

std::vector<Counter> counters_of(const Block& block) {
    std::vector<Counter> found;
    for (std::size_t i = 0; i < block.columns.size(); ++i) {
        const BlockColumn& column = block.columns[i];
        if (!column.quantity.empty() || !column.set_point_of.empty() ||
            !(column.unit.empty() || column.unit == "-" || column.unit == "1"))
            continue;
        if (std::vector<std::size_t> changes = changes_of(block, i); !changes.empty())
            found.push_back({{column.name, column.unit, "interval"}, std::move(changes)});
    }
    return found;
}

}  // namespace

bool names_another(std::string_view name, std::string_view quantity) {
    const std::string folded = folded_name(name);
    const auto has = [&](std::string_view word) { return folded.find(word) != std::string::npos; };
    constexpr std::array<std::string_view, 11> ways = {
        "lidheight",      "deckelhohe",  "displacement", "stroke",   "weg",        "deplacement",
        "desplazamiento", "spostamento", "travel",       "position", "deformation"};
    return (quantity == "height" && std::ranges::any_of(ways, has)) ||
           has_words_of_another(name, quantity);
}

std::vector<BlockColumn> columns_like_intervals(const BlockFile& file,
                                                const std::vector<IntervalSeries>& series) {
    std::vector<BlockColumn> found;
    const Block& block = file.blocks.front();
    if (!is_own_table(file.layout) || file.blocks.size() != 1 ||
        series.front().size() != block.table.rows.size() || block.has_column("interval"))
        return found;
    const std::vector<Counter> counters = counters_of(block);
    if (counters.empty()) return found;
    std::vector<std::size_t> begins;
    for (const Step& step : steps_of(series.front()))
        if (step.begin > 0) begins.push_back(step.begin);
    constexpr std::size_t lag = 2;  // rows by which a measured value follows its set point
    const auto near = [](std::size_t a, std::size_t b) { return a <= b + lag && b <= a + lag; };
    for (const Counter& each : counters)
        if (std::ranges::equal(each.changes, begins, near)) found.push_back(each.column);
    return found;
}

namespace {

/// Whether the file states a gear, so that the speed of the motor is not that of the lid.
bool states_gear(const BlockFile& file) {
    constexpr std::array<std::string_view, 7> gears = {
        "gear", "getriebe", "ubersetzung", "untersetzung", "reduction", "riduzione", "reduccion"};
    return std::ranges::any_of(file.facts, [&](const Fact& fact) {
        const std::string name = folded_name(fact.key + " " + fact.value);
        return std::ranges::any_of(
            gears, [&](std::string_view gear) { return name.find(gear) != std::string::npos; });
    });
}

bool is_of_motor(const BlockColumn& column) {
    const std::string name = folded_name(column.name);
    // French ends the word in its own way.
    return name.find("motor") != std::string::npos || name.find("moteu") != std::string::npos;
}

}  // namespace

std::map<std::string, std::string> columns_by_unit(const BlockFile& file) {
    if (!is_own_table(file.layout) || file.blocks.empty()) return {};
    const Block& block = file.blocks.front();
    if (is_table_of_readings(block) || kind_shown_by_columns(block)) return {};
    const auto missing = missing_groups(block);
    if (missing.empty() || is_table_of_points(block, series_of(block))) return {};
    std::map<std::string, std::string> found;
    const bool geared = states_gear(file);
    for (const NeededGroup* const group : missing) {
        std::vector<std::size_t> fitting;
        for (std::size_t i = 0; i < block.columns.size(); ++i)
            if (!(geared && is_of_motor(block.columns[i])) && !shown_by(block, i, *group).empty())
                fitting.push_back(i);
        if (fitting.size() != 1 || another_has_the_peak(block, fitting.front(), *group)) continue;
        const std::size_t index = fitting.front();
        const auto fits = [&](const NeededGroup* each) {
            return !shown_by(block, index, *each).empty();
        };
        if (std::ranges::count_if(missing, fits) > 1)
            continue;  // a stress, of two that are missing
        const BlockColumn& column = block.columns[index];
        found[std::string(shown_by(block, index, *group))] =
            column.unit.empty() ? column.name : fmt::format("{} [{}]", column.name, column.unit);
    }
    // One column with a unit does not make a recording of a table of other things.
    constexpr std::size_t fewest = 3;
    const bool any_named = std::ranges::any_of(
        block.columns, [](const BlockColumn& column) { return !column.quantity.empty(); });
    if (!any_named && found.size() < fewest) return {};
    return found;
}

}  // namespace pendular
