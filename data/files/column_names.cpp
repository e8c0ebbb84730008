#include "data/files/column_names.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <map>
#include <stdexcept>
#include <string>
#include <vector>

#include "data/quantities/number.h"
#include "data/quantities/quantity.h"
#include "data/quantities/units.h"

namespace pendular {
namespace {

/// Index of the bracket that opens the pair which the last character of a text closes; npos if the
/// text does not end with such a pair.
std::size_t opening_bracket(std::string_view text) {
    if (text.empty() || (text.back() != ']' && text.back() != ')')) return std::string_view::npos;
    int depth = 0;
    for (std::size_t i = text.size(); i-- > 0;) {
        if (text[i] == ']' || text[i] == ')') ++depth;
        if (text[i] == '[' || text[i] == '(') --depth;
        if (depth == 0) return i;
    }
    return std::string_view::npos;
}

struct Spelling {
    std::string_view text;
    ErrorMark mark;
};
constexpr std::array spellings = {Spelling{"standard deviation", ErrorMark::standard_deviation},
                                  Spelling{"standard error", ErrorMark::standard_error},
                                  Spelling{"uncertainty", ErrorMark::standard_error},
                                  Spelling{"stddev", ErrorMark::standard_deviation},
                                  Spelling{"stdev", ErrorMark::standard_deviation},
                                  Spelling{"stderr", ErrorMark::standard_error},
                                  Spelling{"error", ErrorMark::standard_error},
                                  Spelling{"std", ErrorMark::standard_deviation},
                                  Spelling{"u95", ErrorMark::half_width},
                                  Spelling{"sd", ErrorMark::standard_deviation},
                                  Spelling{"se", ErrorMark::standard_error}};

/// Takes a mark of errors such as "_sd" off the end of a name, with its separator.
ErrorMark take_mark(std::string_view& name) {
    std::string lower(name);
    std::transform(lower.begin(), lower.end(), lower.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    for (const auto& [text, mark] : spellings) {
        if (!lower.ends_with(text) || lower.size() <= text.size()) continue;
        const char separator = lower[lower.size() - text.size() - 1];
        if (separator != '_' && separator != ' ') continue;
        name.remove_suffix(text.size() + 1);
        return mark;
    }
    return ErrorMark::none;
}

}  // namespace

HeaderCell parse_header_cell(std::string_view text) {
    text = trimmed(text);
    HeaderCell cell;
    std::string_view name = text;
    if (const std::size_t bracket = opening_bracket(text); bracket != std::string_view::npos) {
        name = text.substr(0, bracket);
        cell.unit = trimmed(text.substr(bracket + 1, text.size() - bracket - 2));
    } else if (const std::size_t in = text.rfind(" in "); in != std::string_view::npos) {
        name = text.substr(0, in);
        cell.unit = trimmed(text.substr(in + 4));
    }
    name = trimmed(name);
    cell.mark = take_mark(name);
    cell.name = trimmed(name);
    return cell;
}

namespace {

struct VendorName {
    std::string_view quantity;
    /// Names in the order of preference where a file has several.
    std::vector<std::string_view> names;
};

/// Names in rheometers' exports that a header of the program's own layout does not use. Those that
/// are shared with other quantities there ("Stress", "Velocity") are read only in these files.
const std::vector<VendorName>& vendor_names() {
    static const std::vector<VendorName> all = {
        {"time",
         {"Time", "t", "Temps", "Zeit", "Step time", "t_seg", "Time (action)", "Interval Time",
          "Intervalle Temps", "Abschnittszeit", "Run time", "Time (sequence)"}},
        {"torque", {"Torque", "M", "Couple", "Moment de torsion", "Drehmoment"}},
        {"normal_force", {"Normal Force", "Fn", "Axial force", "Force Normale", "Normalkraft"}},
        {"height", {"Gap", "h", "Entrefer", "Position", "Spalt", "Spaltweite", "Messspalt"}},
        {"rotational_speed",
         {"Rotational Speed", "Speed", "n", "Vitesse de rotation", "Vitesse", "Drehzahl"}},
        {"angular_velocity",
         {"Angular velocity", "Velocity", "Ω", "Vitesse angulaire", "Winkelgeschwindigkeit"}},
        {"shear_stress",
         {"Shear Stress", "Stress", "τ", "Contrainte de Cisaillement", "Schubspannung"}},
        {"normal_stress", {"Normal Stress", "Contrainte Normale", "Normalspannung"}},
        {"shear_rate",
         {"Shear Rate", "ɣ̇", "γ̇", "Gradient de Cisaillement", "Vitesse de Cisaillement",
          "Scherrate"}},
    };
    return all;
}

/// Name in lower case with single blanks, for comparison. Symbols of up to two bytes (M, t, τ, Fn)
/// keep their case.
std::string compared(std::string_view name) {
    if (name.size() <= 2) return std::string(name);
    std::string result;
    for (const char c : name) {
        const auto byte = static_cast<unsigned char>(c);
        if (c == ' ' && (result.empty() || result.back() == ' ')) continue;
        result += static_cast<char>(std::tolower(byte));
    }
    return result;
}

/// Whether a unit can be that of a quantity; a missing unit can.
bool unit_fits(std::string_view unit, std::string_view name) {
    if (unit.empty()) return true;
    const bool angular = name == "rotational_speed" || name == "angular_velocity";
    try {
        const Unit stated(unit);
        return stated.same_dimension(Unit(quantity(name).unit)) ||
               (angular && stated.same_dimension(Unit("1/s")));
    } catch (const std::invalid_argument&) {
        return false;
    }
}

}  // namespace

ColumnMeaning meaning_of_column(std::string_view name, std::string_view unit) {
    const std::string wanted = compared(name);
    if (wanted.empty()) return {};
    static const std::multimap<std::string, ColumnMeaning> by_name = [] {
        std::multimap<std::string, ColumnMeaning> all;
        for (const VendorName& each : vendor_names())
            for (std::size_t i = 0; i < each.names.size(); ++i)
                all.emplace(compared(each.names[i]),
                            ColumnMeaning{each.quantity, static_cast<int>(i)});
        return all;
    }();
    for (auto [each, end] = by_name.equal_range(wanted); each != end; ++each)
        if (unit_fits(unit, each->second.quantity)) return each->second;
    const Quantity* const known = find_quantity(name);
    if (!known || known->unit.empty() || !unit_fits(unit, known->name)) return {};
    return {known->name, 100};  // after all names of instruments
}

std::string_view set_point_of(std::string_view name, std::string_view unit) {
    static const std::vector<std::string> marks = {
        "set point", "setpoint", "set value",  "set",       "setting",  "target",
        "demand",    "demanded", "commanded",  "requested", "sollwert", "soll",
        "consigne",  "preset",   "prescribed", "imposed"};
    const std::string text = compared(name);
    const auto remainder = [&](const std::string& mark) -> std::string_view {
        std::string_view rest = text;
        for (const std::string& end : {" " + mark, "_" + mark, "(" + mark + ")", "[" + mark + "]"})
            if (rest.ends_with(end)) return trimmed(rest.substr(0, rest.size() - end.size()));
        for (const std::string& begin : {mark + " ", mark + "_"})
            if (rest.starts_with(begin)) return trimmed(rest.substr(begin.size()));
        return "";
    };
    for (const std::string& mark : marks) {
        const std::string_view rest = remainder(mark);
        if (rest.empty()) continue;
        if (const ColumnMeaning meaning = meaning_of_column(rest, unit); !meaning.quantity.empty())
            return meaning.quantity;
    }
    return "";
}

bool counts_points(std::string_view name) {
    static const std::vector<std::string> names = {
        "point",       "point no.",        "point no,",  "point no",  "meas. pts.",
        "meas. point", "messpunkt",        "messpunkte", "punkt nr.", "punkt-nr.",
        "point n°",    "points de mesure", "datapoint"};
    return std::ranges::find(names, compared(name)) != names.end();
}

}  // namespace pendular
