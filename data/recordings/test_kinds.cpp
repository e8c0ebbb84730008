#include "data/recordings/test_kinds.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

#include "data/files/missing_mark.h"
#include "data/quantities/number.h"
#include "data/recordings/step_series.h"

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
         {"storage modulus",   "loss modulus",        "complex viscosity",
          "complex modulus",   "loss factor",         "phase angle",
          "tan(delta)",        "tan delta",           "waveform",
          "oscillation",       "raw phase",           "speichermodul",
          "verlustmodul",      "phasenwinkel",        "module de conservation",
          "module de perte",   "angle de phase",      "módulo de almacenamiento",
          "módulo de pérdida", "modulo conservativo", "modulo dissipativo"},
         {"angular frequency", "frequency", "kreisfrequenz", "frequenz", "pulsation", "fréquence",
          "frecuencia", "frequenza"}},
        {"creep",
         "the shear stress is imposed",
         {"compliance", "creep", "kriech", "complaisance", "nachgiebigkeit", "cedevolezza",
          "fluencia"}},
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

std::optional<std::string> load_ramp(const IntervalSeries& series) {
    const auto ramp = speed_ramp(series.normal());
    if (!ramp) return std::nullopt;
    return fmt::format("load ramp: the normal {} changes {}",
                       series.normal_stress.empty() ? "force" : "stress", ramp->change());
}

bool has_column_of_readings(const Block& block) {
    constexpr std::array<std::string_view, 6> names = {"shear_velocity", "shear_rate",
                                                       "height",         "solid_fraction",
                                                       "bulk_density",   "inertial_number"};
    return std::ranges::any_of(block.columns, [&](const BlockColumn& column) {
        return std::ranges::find(names, column.quantity) != names.end();
    });
}

bool is_table_of_points(const Block& block, const IntervalSeries& series) {
    constexpr std::size_t most_points = 1000, fewest_points = 3;
    // Two thirds of the least step between set points that steps.cpp tells apart.
    constexpr double jump = 0.05;
    const bool stresses = !series.shear_stress.empty() && !series.normal_stress.empty();
    if (!stresses || !series.time.empty() || !series.angular_velocity.empty() ||
        !series.interval.empty() || has_column_of_readings(block) || block.declared_rows ||
        series.size() < fewest_points || series.size() > most_points)
        return false;
    std::size_t jumps = 0;
    for (std::size_t i = 1; i < series.size(); ++i) {
        const double before = series.normal_stress[i - 1], now = series.normal_stress[i];
        jumps += std::abs(now - before) > jump * std::max(std::abs(now), std::abs(before));
    }
    return jumps >= 2 && 4 * jumps >= series.size();
}

}  // namespace pendular
