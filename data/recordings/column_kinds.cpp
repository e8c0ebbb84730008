#include "data/recordings/column_kinds.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string_view>
#include <vector>

#include "data/files/folded_name.h"
#include "data/quantities/number.h"

namespace pendular {
namespace {

/// Words with which the names of columns begin that only one kind of test has, in small letters.
struct KindOfTest {
    const char* kind;
    const char* consequence;
    std::vector<std::string_view> words;
    /// Words that a recording of steady shear may have too, for the frequency of a motor say: they
    /// count where no speed is read.
    std::vector<std::string_view> unless_speed = {};
};

/// In the languages of `column_names.cpp` and `further_names.cpp`, and in Japanese and Chinese.
const std::vector<KindOfTest>& kinds_of_test() {
    static const std::vector<KindOfTest> all = {
        {"oscillation",
         "its stresses are amplitudes",
         {"storage modulus",
          "loss modulus",
          "complex viscosity",
          "complex modulus",
          "complex shear modulus",
          "loss factor",
          "loss tangent",
          "phase angle",
          "phase shift",
          "strain amplitude",
          "stress amplitude",
          "tan(delta)",
          "tan delta",
          "tan δ",
          "tan(δ)",
          "tanδ",
          "waveform",
          "oscillation",
          "raw phase",
          "speichermodul",
          "verlustmodul",
          "verlustfaktor",
          "komplexe viskosität",
          "komplexer schubmodul",
          "komplexer modul",
          "phasenwinkel",
          "phasenverschiebung",
          "deformationsamplitude",
          "scheramplitude",
          "schubspannungsamplitude",
          "oszillation",
          "module de conservation",
          "module de perte",
          "module complexe",
          "viscosité complexe",
          "facteur de perte",
          "angle de phase",
          "déphasage",
          "amplitude de déformation",
          "amplitude de contrainte",
          "módulo de almacenamiento",
          "módulo de pérdida",
          "módulo complejo",
          "viscosidad compleja",
          "ángulo de fase",
          "factor de pérdida",
          "amplitud de deformación",
          "modulo conservativo",
          "modulo dissipativo",
          "modulo complesso",
          "viscosità complessa",
          "angolo di fase",
          "angolo di sfasamento",
          "fattore di perdita",
          "ampiezza di deformazione",
          "módulo elástico",
          "módulo viscoso",
          "modulo elastico",
          "modulo viscoso",
          "moduł zachowawczy",
          "moduł stratności",
          "lepkość zespolona",
          "kąt fazowy",
          "kąt przesunięcia fazowego",
          "paměťový modul",
          "ztrátový modul",
          "komplexní viskozita",
          "fázový úhel",
          "opslagmodulus",
          "verliesmodulus",
          "complexe viscositeit",
          "fasehoek",
          "lagringsmodul",
          "förlustmodul",
          "tabsmodul",
          "komplex viskositet",
          "fasvinkel",
          "fasevinkel",
          "módulo de armazenamento",
          "módulo de perda",
          "viscosidade complexa",
          "ângulo de fase",
          "depolama modülü",
          "kayıp modülü",
          "faz açısı",
          "tárolási modulus",
          "veszteségi modulus",
          "fázisszög",
          "varastomoduuli",
          "häviömoduuli",
          "vaihekulma",
          "貯蔵弾性率",
          "損失弾性率",
          "複素弾性率",
          "複素粘度",
          "損失正接",
          "位相角",
          "储能模量",
          "损耗模量",
          "复数粘度",
          "相位角",
          "i3/i1",
          "g'",
          "g\"",
          "g′",
          "g″",
          "|g*|",
          "|η*|",
          "η*",
          "g*"},
         {"angular frequency",
          "ang. frequency",
          "frequency",
          "kreisfrequenz",
          "frequenz",
          "pulsation",
          "pulsazione",
          "pulsación",
          "pulsação",
          "fréquence",
          "frecuencia",
          "frequenza",
          "frequência",
          "częstość",
          "częstotliwość",
          "frekvence",
          "úhlová frekvence",
          "hoekfrequentie",
          "frequentie",
          "vinkelfrekvens",
          "frekvens",
          "frekans",
          "açısal frekans",
          "körfrekvencia",
          "frekvencia",
          "kulmataajuus",
          "taajuus",
          "角周波数",
          "周波数",
          "角频率",
          "频率"}},
        {"creep",
         "the shear stress is imposed",
         {"compliance", "recoverable compliance", "recovery compliance", "creep", "kriech", "j(t)",
          "complaisance", "nachgiebigkeit", "cedevolezza", "fluencia", "cumplimiento", "podatność",
          "kryp", "pełzanie", "クリープ", "コンプライアンス"}},
        {"relaxation",
         "the strain is imposed",
         {"relaxation modulus", "relaxationsmodul", "module de relaxation", "módulo de relajación",
          "modulo di rilassamento", "moduł relaksacji", "relaxatiemodulus", "g(t)", "緩和弾性率"}}};
    return all;
}

/// Whether any cell of a column holds a number other than 0, which instruments write where they
/// measure nothing.
bool holds_values(const Block& block, std::size_t column) {
    return std::ranges::any_of(block.table.rows, [&](const Row& row) {
        return parse_number(row.cells[column].text).value_or(0) != 0;
    });
}

}  // namespace

std::optional<std::string> kind_shown_by_columns(const Block& block) {
    const bool has_speed = std::ranges::any_of(block.columns, [](const BlockColumn& column) {
        return column.quantity == "angular_velocity" || column.quantity == "rotational_speed" ||
               column.quantity == "shear_velocity";
    });
    for (const auto& [kind, consequence, words, unless_speed] : kinds_of_test()) {
        for (std::size_t i = 0; i < block.columns.size(); ++i) {
            const BlockColumn& column = block.columns[i];
            if (!column.quantity.empty()) continue;
            const std::string name = lower_case(column.name);
            const auto begins = [&](std::string_view word) { return name.starts_with(word); };
            const bool shows = std::ranges::any_of(words, begins) ||
                               (!has_speed && std::ranges::any_of(unless_speed, begins));
            if (shows && holds_values(block, i))
                return fmt::format("{}: the file has '{}', so that {}", kind, column.name,
                                   consequence);
        }
    }
    return std::nullopt;
}

bool names_result_of_locus(const BlockColumn& column) {
    constexpr std::array<std::string_view, 11> symbols = {
        "σ1", "σc", "sigma1", "sigmac", "fc", "ff", "ffc", "ffρ", "uys", "mps", "mcs"};
    constexpr std::array<std::string_view, 13> words = {
        "unconfined",     "principal",     "consolidatingstress",
        "flowfunction",   "flowability",   "fliessfahig",
        "fliessfunktion", "hauptspannung", "druckfestigkeit",
        "cohesion",       "kohasion",      "tensilestrength",
        "flowindex"};
    const std::string name = folded_name(column.name);
    return std::ranges::find(symbols, name) != symbols.end() ||
           std::ranges::any_of(
               words, [&](std::string_view word) { return name.find(word) != std::string::npos; });
}

}  // namespace pendular
