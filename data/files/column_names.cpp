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

bool is_unit(std::string_view text) {
    if (text.empty()) return false;
    try {
        const Unit unit(text);
        return true;
    } catch (const std::invalid_argument&) {
        return false;
    }
}

namespace {

/// Whether a name, with or without a mark of errors, is that of a quantity in this unit; any unit
/// fits if it is empty.
bool is_quantity(std::string_view name, std::string_view unit = "") {
    take_mark(name);
    return !meaning_of_column(trimmed(name), unit).quantity.empty();
}

/// Parts of a header cell before and after a separator; both are empty if it has none.
struct Halves {
    std::string_view name, unit;
};

Halves divided(std::string_view text, std::string_view separator, std::size_t at) {
    if (at == std::string_view::npos) return {};
    return {trimmed(text.substr(0, at)), trimmed(text.substr(at + separator.size()))};
}

/// Name and unit of a header cell without brackets: "Torque in mNm", "Torque / mNm" (ISO 80000),
/// "Torque/mNm", "Couple, mNm". Only " in " and " / " are taken for certain. Other separators occur
/// in names ("phi_L/phi_S", "Time, sequence"), so that they count only where the unit is one of the
/// named quantity.
Halves name_and_unit(std::string_view text) {
    if (const std::size_t in = text.rfind(" in "); in != std::string_view::npos)
        return divided(text, " in ", in);
    if (find_quantity(text)) return {text, ""};
    const Halves apart = divided(text, " / ", text.find(" / "));
    if (!apart.unit.empty() &&
        (is_quantity(apart.name, apart.unit) ||
         (!find_quantity(apart.unit) && (is_quantity(apart.name) || is_unit(apart.unit)))))
        return apart;
    for (const std::string_view separator : {"/", ", ", " en "}) {
        const bool first = separator == "/";  // "Angular velocity/rad/s"
        const Halves parts =
            divided(text, separator, first ? text.find(separator) : text.rfind(separator));
        if (!parts.unit.empty() && is_quantity(parts.name, parts.unit)) return parts;
    }
    return {text, ""};
}

}  // namespace

HeaderCell parse_header_cell(std::string_view text) {
    text = trimmed(text);
    HeaderCell cell;
    std::string_view name = text;
    if (const std::size_t bracket = opening_bracket(text); bracket != std::string_view::npos) {
        name = text.substr(0, bracket);
        cell.unit = trimmed(text.substr(bracket + 1, text.size() - bracket - 2));
    } else {
        const Halves parts = name_and_unit(text);
        name = parts.name;
        cell.unit = parts.unit;
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
    /// Names that a table of someone's own may give to another quantity: not read in the layout
    /// "plain".
    std::vector<std::string_view> shared = {};
};

/// Names in rheometers' exports and in tables of people's own, in English, French, German, Spanish
/// and Italian. A name of several quantities is that of the first whose unit fits.
const std::vector<VendorName>& vendor_names() {
    static const std::vector<VendorName> all = {
        {"time",
         {"Time",
          "t",
          "Temps",
          "Zeit",
          "Step time",
          "t_seg",
          "Time (action)",
          "Interval Time",
          "Intervalle Temps",
          "Abschnittszeit",
          "Run time",
          "Time (sequence)",
          "Messzeit",
          "Versuchszeit",
          "Tiempo",
          "Tempo",
          "Clock time",
          "Time of day",
          "Uhrzeit",
          "Heure",
          "Hora",
          "Ora"}},
        {"torque",
         {"Torque", "M", "Couple", "Moment de torsion", "Drehmoment", "Moment", "Torsionsmoment",
          "Par", "Par motor", "Par de torsión", "Momento de torsión", "Momento torcente", "Coppia",
          "Md"}},
        {"normal_force",
         {"Normal Force",
          "Fn",
          "FN",
          "Axial force",
          "Force Normale",
          "Normalkraft",
          "Axialkraft",
          "Force axiale",
          "Normal load",
          "Vertical load",
          "Vertical force",
          "Applied normal force",
          "Auflast",
          "Vertikalkraft",
          "Charge normale",
          "Force verticale",
          "Carga normal",
          "Carico normale",
          "Fuerza normal",
          "Fuerza axial",
          "Forza normale",
          "Forza assiale"}},
        {"lever_force",
         {"Shear force", "Lever force", "Force on lever", "Scherkraft", "Hebelkraft",
          "Kraft am Hebel", "Force de cisaillement", "Force sur le levier", "Fuerza de corte",
          "Fuerza de cizalla", "Forza di taglio", "F_S", "Fs"}},
        {"height",
         {"Gap", "h", "Entrefer", "Spalt", "Spaltweite", "Messspalt", "Measuring gap", "Gap width",
          "Spalthöhe", "Probenhöhe", "Höhe", "Plattenabstand", "Hauteur", "Entrehierro",
          "Separación", "Altura", "Traferro", "Altezza"},
         {"Position"}},
        {"rotational_speed",
         {"Rotational Speed", "Speed", "n", "Vitesse de rotation", "Drehzahl", "Umdrehungszahl",
          "Velocidad", "Velocidad de giro", "Velocidad de rotación", "Numero di giri",
          "Velocità di rotazione"},
         {"Vitesse"}},
        {"angular_velocity",
         {"Angular velocity", "Ω", "Vitesse angulaire", "Winkelgeschwindigkeit",
          "Drehgeschwindigkeit", "Rotationsgeschwindigkeit", "Velocidad angular",
          "Velocità angolare"},
         {"Velocity"}},
        {"shear_stress",
         {"Shear Stress", "τ", "Contrainte de Cisaillement", "Schubspannung", "Scherspannung",
          "Esfuerzo cortante", "Tensión de cizalla", "Sforzo di taglio", "Tensione di taglio",
          "Wall shear stress", "tau w", "tau_w", "τw", "Wandschubspannung", "Wandscherspannung",
          "Contrainte de cisaillement à la paroi", "Tensión de cizalla en la pared",
          "Tensione di taglio alla parete"},
         {"Stress"}},
        {"normal_stress",
         {"Normal Stress", "Contrainte Normale", "Normalspannung", "Esfuerzo normal",
          "Tensión normal", "Sforzo normale", "Tensione normale", "Applied normal stress",
          "Vertical stress", "Normal load stress", "Auflastspannung", "Wall normal stress",
          "sigma w", "sigma_w", "σw", "Wandnormalspannung", "Contrainte normale à la paroi",
          "Tensión normal en la pared", "Tensione normale alla parete"}},
        {"shear_rate",
         {"Shear Rate", "ɣ̇", "γ̇", "Gradient de Cisaillement", "Vitesse de Cisaillement",
          "Scherrate", "Schergeschwindigkeit", "Schergefälle", "Taux de cisaillement",
          "Velocidad de cizalla", "Velocidad de cizallamiento", "Velocità di taglio"}},
        {"shear_velocity",
         {"Shear velocity", "Shear speed", "Vitesse de Cisaillement", "Schergeschwindigkeit",
          "Velocidad de cizalla", "Velocidad de cizallamiento", "Velocità di taglio"}},
        {"solid_fraction",
         {"Solid fraction", "Packing fraction", "Volume fraction", "Feststoffanteil",
          "Packungsdichte", "Volumenanteil", "Compacité", "Fraction volumique", "Fracción sólida",
          "Compacidad", "Frazione solida", "Compattezza"}},
        {"bulk_density",
         {"Bulk density", "Schüttdichte", "Masse volumique apparente", "Densité apparente",
          "Densidad aparente", "Densità apparente"}},
        {"stress_ratio",
         {"Stress ratio", "Effective friction", "Spannungsverhältnis", "Reibungsverhältnis",
          "Rapport des contraintes", "Relación de esfuerzos", "Rapporto degli sforzi"}},
        {"inertial_number",
         {"Inertial number", "Trägheitszahl", "Inertialzahl", "Nombre inertiel", "Número inercial",
          "Numero inerziale"}},
        {"liquid_content",
         {"Liquid content", "Flüssigkeitsgehalt", "Teneur en liquide", "Contenido de líquido",
          "Contenuto di liquido"}},
        {"preshear_stress",
         {"Preshear stress", "sigma pre", "σpre", "Vorscherspannung", "Anscherspannung",
          "Contrainte de précisaillement", "Tensión de precizalla", "Tensione di pretaglio",
          "sigma_pre", "Preshear normal stress", "Normalspannung beim Anscheren"}},
        {"preshear_shear_stress",
         {"Preshear shear stress", "tau pre", "tau_pre", "τpre", "Anscherwiderstand",
          "Anscherschubspannung", "Schubspannung beim Anscheren"}},
        {"interval",
         {"Intervall", "Abschnitt", "Schritt", "Intervalle", "Étape", "étape", "Intervalo",
          "Segmento", "Intervallo"}},
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

}  // namespace

bool unit_fits(std::string_view unit, std::string_view quantity_name) {
    if (unit.empty()) return true;
    const bool angular = quantity_name == "rotational_speed" || quantity_name == "angular_velocity";
    try {
        const Unit stated(unit);
        return stated.same_dimension(Unit(quantity(quantity_name).unit)) ||
               (angular && stated.same_dimension(Unit("1/s")));
    } catch (const std::invalid_argument&) {
        return false;
    }
}

ColumnMeaning meaning_of_column(std::string_view name, std::string_view unit) {
    const std::string wanted = compared(name);
    if (wanted.empty()) return {};
    static const std::multimap<std::string, ColumnMeaning> by_name = [] {
        std::multimap<std::string, ColumnMeaning> all;
        for (const VendorName& each : vendor_names())
            for (const auto* names : {&each.names, &each.shared})
                for (std::size_t i = 0; i < names->size(); ++i)
                    all.emplace(
                        compared((*names)[i]),
                        ColumnMeaning{each.quantity,
                                      static_cast<int>(i) + (names == &each.shared ? 50 : 0),
                                      names == &each.shared});
        return all;
    }();
    for (auto [each, end] = by_name.equal_range(wanted); each != end; ++each)
        if (unit_fits(unit, each->second.quantity)) return each->second;
    const Quantity* const known = find_quantity(name);
    if (!known || known->unit.empty() || !unit_fits(unit, known->name)) return {};
    return {known->name, 100, false};  // after all names of instruments
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
