#include "data/files/column_names.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <iterator>
#include <map>
#include <stdexcept>
#include <string>
#include <vector>

#include "data/files/folded_name.h"
#include "data/files/further_names.h"
#include "data/quantities/number.h"
#include "data/quantities/quantity.h"
#include "data/quantities/units.h"

namespace pendular {
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
          "Elapsed time",
          "Temps écoulé",
          "Tiempo transcurrido",
          "Tempo trascorso",
          "X_Value",
          "Clock time",
          "Time of day",
          "Uhrzeit",
          "Heure",
          "Hora",
          "Ora",
          "Timestamp",
          "Time stamp",
          "Date/Time",
          "Datetime",
          "Zeitstempel",
          "Datum/Uhrzeit",
          "Horodatage",
          "Date/Heure",
          "Fecha/Hora",
          "Fecha y hora",
          "Data/Ora",
          "Data e ora"}},
        {"torque",
         {"Torque", "M", "Couple", "Moment de torsion", "Drehmoment", "Moment", "Torsionsmoment",
          "Par", "Par motor", "Par de torsión", "Momento de torsión", "Momento torcente", "Coppia",
          "Md", "Peak torque"}},
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
          "Drehgeschwindigkeit", "Rotationsgeschwindigkeit", "Velocidad", "Velocidad de giro",
          "Velocidad de rotación", "Numero di giri", "Velocità di rotazione"},
         {"Vitesse", "Velocità"}},
        {"angular_velocity",
         {"Angular velocity", "Ω", "Vitesse angulaire", "Winkelgeschwindigkeit",
          "Velocidad angular", "Velocità angolare"},
         {"Velocity"}},
        {"shear_stress",
         {"Shear Stress", "τ", "Contrainte de Cisaillement", "Schubspannung", "Scherspannung",
          "Esfuerzo cortante", "Tensión de cizalla", "Sforzo di taglio", "Tensione di taglio",
          "Esfuerzo de corte", "Esfuerzo de cizalla", "Tensión cortante", "Tensión de corte",
          "Sforzo tangenziale", "Tensione tangenziale", "Contrainte tangentielle",
          "Wall shear stress", "tau w", "τw", "Wandschubspannung", "Wandscherspannung",
          "Contrainte de cisaillement à la paroi", "Contrainte de cisaillement pariétale",
          "Contrainte pariétale", "Tensión de cizalla en la pared",
          "Tensione di taglio alla parete", "Shear wall stress",
          // At failure, as programs of shear testers call it.
          "Peak shear stress", "Failure shear stress", "Shear stress at failure",
          "Maximum shear stress", "tau sh", "τsh", "tau ab", "τab", "tau f", "τf",
          "Abscherspannung", "Schubspannung beim Abscheren",
          "Contrainte de cisaillement à la rupture", "Tensión de cizalla en la rotura",
          "Tensione di taglio a rottura", "Shear stress peak", "Shear stress at peak",
          "Contrainte de cisaillement au pic", "Contrainte de cisaillement de pic",
          "Contrainte de cisaillement maximale", "Resistencia al corte", "Resistenza di picco",
          "Tensión de corte pico", "Sforzo di taglio di picco", "Mean shear stress",
          "Average shear stress", "Mittlere Schubspannung", "Contrainte de cisaillement moyenne",
          "Tensión de corte media", "Sforzo di taglio medio"},
         {"Stress"}},
        {"normal_stress",
         {"Normal Stress",
          "Contrainte Normale",
          "Normalspannung",
          "Esfuerzo normal",
          "Tensión normal",
          "Sforzo normale",
          "Tensione normale",
          "Applied normal stress",
          "Vertical stress",
          "Normal load stress",
          "Auflastspannung",
          "Wall normal stress",
          "sigma w",
          "σw",
          "Wandnormalspannung",
          "Contrainte normale à la paroi",
          "Tensión normal en la pared",
          "Tensione normale alla parete",
          "Normal wall stress",
          "Normal stress at failure",
          "Failure normal stress",
          "sigma sh",
          "σsh",
          "sigma ab",
          "σab",
          "sigma f",
          "σf",
          "Normalspannung beim Abscheren",
          "Contrainte normale à la rupture",
          "Tensión normal en la rotura",
          "Tensione normale a rottura",
          "Nominal normal stress",
          "Contrainte normale nominale",
          "Mean normal stress",
          "Average normal stress",
          "Contrainte normale moyenne",
          "Tensión normal media",
          "Sforzo normale medio"}},
        {"shear_rate",
         {"Shear Rate", "ɣ̇", "γ̇", "Gradient de Cisaillement", "Vitesse de Cisaillement",
          "Scherrate", "Schergeschwindigkeit", "Schergefälle", "Taux de cisaillement",
          "Velocidad de cizalla", "Velocidad de cizallamiento", "Velocità di taglio"}},
        {"shear_velocity",
         {"Shear velocity", "Shear speed", "Vitesse de Cisaillement", "Schergeschwindigkeit",
          "Velocidad de cizalla", "Velocidad de cizallamiento", "Velocità di taglio"}},
        {"solid_fraction",
         {"Solid fraction", "Packing fraction", "Volume fraction", "Solid volume fraction",
          "Feststoffanteil", "Feststoffvolumenanteil", "Packungsdichte", "Volumenanteil",
          "Compacité", "Fraction solide", "Fraction volumique", "Fracción sólida", "Compacidad",
          "Frazione solida", "Compattezza"}},
        {"bulk_density",
         {"Bulk density", "rho b", "ρb", "Schüttdichte", "Masse volumique apparente",
          "Densité apparente", "Densidad aparente", "Densità apparente"}},
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
         {"Preshear stress",
          "sigma pre",
          "σpre",
          "Vorscherspannung",
          "Anscherspannung",
          "Contrainte de précisaillement",
          "Tensión de precizalla",
          "Tensione di pretaglio",
          "sigma an",
          "σan",
          "Preshear normal stress",
          "Normalspannung beim Anscheren",
          "Consolidation stress",
          "Initial consolidation stress",
          "Preconsolidation stress",
          "Verfestigungsspannung",
          "Konsolidierungsspannung",
          "Contrainte de consolidation",
          "Tensión de consolidación",
          "Esfuerzo de consolidación",
          "Tensione di consolidamento",
          "Tensione di consolidazione",
          "Preshear normal load",
          "Pre-consolidation normal stress",
          "Consolidation normal stress",
          "Normal stress at preshear",
          "Normal consolidation stress",
          "Contrainte normale de consolidation",
          "Contrainte normale de précisaillement",
          "Contrainte de préconsolidation",
          "Tension de préconsolidation",
          "Charge de précisaillement",
          "Charge de consolidation",
          "Tensión de preconsolidación",
          "Tensión normal de consolidación",
          "Nivel de consolidación",
          "Sforzo di consolidazione",
          "Sforzo di consolidamento",
          "Sforzo di preconsolidazione",
          "Tensione di preconsolidazione",
          "Sforzo di pretaglio",
          "Konsolidationsspannung",
          "Vorverdichtungsspannung",
          "Consolidation level",
          "Preshear level",
          "Niveau de consolidation",
          "Niveau de précisaillement",
          "Consolidation",
          "Preconsolidation",
          "Préconsolidation",
          "Preconsolidación",
          "Consolidación",
          "Consolidazione",
          "Preconsolidazione",
          "Precarico",
          "Preshear",
          "Preshear load",
          "Consolidation load",
          "Anscherlast",
          "Anscheren",
          "Vorscheren",
          "Vorlast",
          "Konsolidierung",
          "Précisaillement",
          "Precizalla",
          "Precarga",
          "Pretaglio"}},
        {"preshear_shear_stress",
         {"Preshear shear stress", "tau pre", "τpre", "tau an", "τan", "Anscherwiderstand",
          "Anscherschubspannung", "Schubspannung beim Anscheren",
          "Contrainte de cisaillement au précisaillement", "Tensión de cizalla en la precizalla",
          "Tensione di taglio al pretaglio"}},
        {"interval",
         {"Intervall", "Abschnitt", "Schritt", "Intervalle", "Étape", "étape", "Intervalo",
          "Segmento", "Intervallo", "Passo", "Paso", "Tramo", "Tratto", "Palier", "Stufe"}},
    };
    return all;
}

/// Name for comparison (`folded_name`). Symbols of up to two bytes (M, t, τ, Fn) keep their case.
std::string compared(std::string_view name) {
    constexpr std::size_t longest = 200;  // bytes of a name; longer texts are none
    return name.size() <= 2 || name.size() > longest ? std::string(name) : folded_name(name);
}

/// Text in lower case with single blanks.
std::string spaced(std::string_view text) {
    std::string result;
    for (const char c : text) {
        if (c == ' ' && (result.empty() || result.back() == ' ')) continue;
        result += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    }
    return result;
}

}  // namespace

namespace {

/// Whether a text in place of a unit says how clock times are written: "min:s", "hh:mm:ss".
bool is_clock_form(std::string_view unit) {
    return unit.find(':') != std::string_view::npos &&
           unit.find_first_not_of("hHmMsSin:.,") == std::string_view::npos;
}

}  // namespace

bool unit_fits(std::string_view unit, std::string_view quantity_name) {
    if (unit.empty() || (quantity_name == "time" && is_clock_form(unit))) return true;
    const bool angular = quantity_name == "rotational_speed" || quantity_name == "angular_velocity";
    try {
        const Unit stated(unit);
        return stated.same_dimension(Unit(quantity(quantity_name).unit)) ||
               (angular && stated.same_dimension(Unit("1/s")));
    } catch (const std::invalid_argument&) {
        return false;
    }
}

std::string why_unit_is_wrong(std::string_view unit, std::string_view quantity_name) {
    try {
        return wrong_dimension(Unit(unit), Unit(quantity(quantity_name).unit));
    } catch (const std::invalid_argument& error) {
        return error.what();
    }
}

namespace {

/// Whether a name is a letter, or the name of a Greek one, and no word.
bool is_symbol(std::string_view name) {
    constexpr std::array<std::string_view, 8> letters = {"phi",   "mu",    "tau",   "sigma",
                                                         "kappa", "omega", "phi_S", "Phi"};
    const bool greek =
        name.size() <= 6 && !name.empty() && static_cast<unsigned char>(name[0]) > 0x7f;
    return name.size() == 1 || greek || std::ranges::find(letters, name) != letters.end();
}

}  // namespace

const Quantity* quantity_of_cell(std::string_view name, std::string_view unit) {
    const Quantity* const known = find_quantity(name);
    if (!known || known->unit.empty() || unit.empty() || !is_symbol(name)) return known;
    try {
        const Unit stated(unit);
    } catch (const std::invalid_argument&) {
        return known;  // its reader names what is wrong
    }
    return unit_fits(unit, known->name) ? known : nullptr;
}

namespace {

/// Name without the word that it is measured and no set point: "Normal stress" for "Measured normal
/// stress". Empty if there is no such word.
std::string name_of_measured(std::string_view name) {
    static const std::vector<std::string> words = {
        "measured", "actual",  "gemessen", "gemessene", "gemessenes",
        "ist",      "istwert", "mesuré",   "mesurée",   "réel",
        "réelle",   "medido",  "medida",   "misurato",  "misurata"};
    // Names that are not known come here, of which a file may have many.
    static const std::vector<std::string> ends = [] {
        std::vector<std::string> all;
        for (const std::string& word : words)
            for (const std::string& end : {" " + word, " (" + word + ")", "_" + word, ", " + word})
                all.push_back(end);
        return all;
    }();
    const std::string text = spaced(name);
    for (const std::string& end : ends)
        if (text.ends_with(end)) return text.substr(0, text.size() - end.size());
    for (const std::string& word : words)
        if (text.starts_with(word) && text[word.size()] == ' ') return text.substr(word.size() + 1);
    return "";
}

}  // namespace

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
        constexpr int after_the_five = 50;  // a name in another language beside one of these
        for (const auto& [quantity, names] : further_names())
            for (std::size_t i = 0; i < names.size(); ++i)
                all.emplace(compared(names[i]),
                            ColumnMeaning{quantity, static_cast<int>(i) + after_the_five, false});
        return all;
    }();
    for (auto [each, end] = by_name.equal_range(wanted); each != end; ++each)
        if (unit_fits(unit, each->second.quantity)) return each->second;
    const Quantity* const known = find_quantity(name);
    if (known && !known->unit.empty() && unit_fits(unit, known->name))
        return {known->name, 100, false};  // after all names of instruments
    const std::string measured = name_of_measured(name);
    if (measured.empty()) return {};
    ColumnMeaning meaning = meaning_of_column(measured, unit);
    meaning.rank = -1;  // before set points, which may have the name alone
    return meaning;
}

std::string_view usual_unit(std::string_view quantity_name) {
    constexpr std::pair<std::string_view, std::string_view> usual[] = {
        {"torque", "mN m"},
        {"height", "mm"},
        {"rotational_speed", "1/min"},
        {"shear_velocity", "mm/min"}};
    const auto* const found = std::ranges::find(
        usual, quantity_name, &std::pair<std::string_view, std::string_view>::first);
    return found != std::end(usual) ? found->second : quantity(quantity_name).unit;
}

std::string_view set_point_of(std::string_view name, std::string_view unit) {
    static const std::vector<std::string> marks = {
        "set point", "setpoint", "set value",  "set",       "setting",  "target",
        "demand",    "demanded", "commanded",  "requested", "sollwert", "soll",
        "consigne",  "preset",   "prescribed", "imposed",   "vorgabe"};
    const std::string text = spaced(name);
    const auto remainder = [&](const std::string& mark) -> std::string_view {
        std::string_view rest = text;
        for (const std::string& end :
             {" " + mark, "_" + mark, "-" + mark, "(" + mark + ")", "[" + mark + "]"})
            if (rest.ends_with(end)) return trimmed(rest.substr(0, rest.size() - end.size()));
        for (const std::string& begin : {mark + " ", mark + "_", mark + "-"})
            if (rest.starts_with(begin)) return trimmed(rest.substr(begin.size()));
        // German joins words: "Solldrehzahl", "Drehzahlsollwert".
        if (mark.starts_with("soll") && rest.ends_with(mark))
            return rest.substr(0, rest.size() - mark.size());
        return mark == "soll" && rest.starts_with(mark) ? rest.substr(mark.size()) : "";
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
    return std::ranges::find(names, spaced(name)) != names.end();
}

}  // namespace pendular
