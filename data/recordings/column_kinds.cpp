#include "data/recordings/column_kinds.h"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>
#include <vector>

#include "data/files/missing_mark.h"
#include "data/quantities/number.h"

namespace pendular {
namespace {

/// Words in the names of columns that only one kind of test has.
struct KindOfTest {
    const char* kind;
    const char* consequence;
    std::vector<std::string_view> words;
    /// Words that a recording of steady shear may have too, for the frequency of a motor say: they
    /// count where no speed is read.
    std::vector<std::string_view> unless_speed = {};
};

const std::vector<KindOfTest>& kinds_of_test() {
    static const std::vector<KindOfTest> all = {
        {"oscillation",
         "its stresses are amplitudes",
         {"storage modulus",
          "loss modulus",
          "complex viscosity",
          "complex modulus",
          "loss factor",
          "phase angle",
          "tan(delta)",
          "tan delta",
          "waveform",
          "oscillation",
          "raw phase",
          "speichermodul",
          "verlustmodul",
          "phasenwinkel",
          "module de conservation",
          "module de perte",
          "angle de phase",
          "módulo de almacenamiento",
          "módulo de pérdida",
          "modulo conservativo",
          "modulo dissipativo",
          "módulo elástico",
          "módulo viscoso",
          "modulo elastico",
          "modulo viscoso",
          "g'",
          "g\"",
          "g′",
          "g″",
          "|g*|",
          "g*"},
         {"angular frequency", "ang. frequency", "frequency", "kreisfrequenz", "frequenz",
          "pulsation", "fréquence", "frecuencia", "frequenza"}},
        {"creep",
         "the shear stress is imposed",
         {"compliance", "creep", "kriech", "complaisance", "nachgiebigkeit", "cedevolezza",
          "fluencia", "cumplimiento"}},
        {"relaxation",
         "the strain is imposed",
         {"relaxation modulus", "relaxationsmodul", "module de relaxation"}}};
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
            const std::string name = in_small_letters(column.name);
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

}  // namespace pendular
