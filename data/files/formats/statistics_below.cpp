#include "data/files/formats/statistics_below.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <optional>
#include <string>

#include "data/files/folded_name.h"
#include "data/files/missing_mark.h"
#include "data/quantities/number.h"

namespace pendular {
namespace {

/// Words of a text, as `folded_name` has them, without what stands in brackets.
std::vector<std::string> words_of(std::string_view text) {
    std::vector<std::string> words(1);
    int depth = 0;
    for (const char c : text) {
        depth += c == '(' || c == '[';
        if (depth == 0 && std::string_view(" \t_-./:;=,%*").find(c) == std::string_view::npos)
            words.back() += c;
        else if (!words.back().empty())
            words.emplace_back();
        depth -= depth > 0 && (c == ')' || c == ']');
    }
    if (words.back().empty()) words.pop_back();
    for (std::string& word : words)
        word = word == "Ø" || word == "ø" ? "ø" : folded_name(word);  // which is "o" for the letter
    return words;
}

/// Words that name a statistic by themselves, in the languages of `further_names.cpp`.
constexpr std::string_view statistics =
    "mean means average avg mittel mittelwert mittelw mw durchschnitt moyenne moy "
    "media promedio gemiddelde gemiddeld srednia średnia medel medelvarde gennemsnit "
    "prumer průměr atlag ortalama keskiarvo среднее средняя 平均 平均値 平均值 평균 ø x̄ median "
    "medianwert mediane mediana geomean min max minimum maximum minimo maximo massimo "
    "sum summe somme suma somma total gesamt anzahl count sd std stddev stdev stabw "
    "stdabw standardabweichung streuung ecarttype ecart desv desvest desviacion "
    "deviazione scarto odchylenie odch odchylka smodch szoras standardafvigelse "
    "standardavvikelse standaarddeviatie keskihajonta ско 標準偏差 标准差 표준편차 variance "
    "varianz var varians cv rsd sem se";

/// Words that may stand beside one of these.
constexpr std::string_view beside_statistics =
    "value values wert werte dev deviation abw abweichung error err of der des type "
    "est estandar standard stand std rel relative arith geo geometric sample all the "
    "arithmetic arithm";

/// Whether a word is one of a list, which are separated by blanks.
bool is_among(std::string_view list, std::string_view word) {
    for (std::size_t at = list.find(word); at != list.npos; at = list.find(word, at + 1)) {
        const std::size_t end = at + word.size();
        if ((at == 0 || list[at - 1] == ' ') && (end == list.size() || list[end] == ' '))
            return true;
    }
    return false;
}

bool is_statistic(std::string_view word) {
    return is_among(statistics, word);
}

/// Whether a word is the unit of a load, as in "Avg 1 kPa".
bool is_stress_unit(std::string_view word) {
    constexpr std::string_view units = "pa hpa kpa mpa n kn bar mbar psi";
    return is_among(units, word);
}

/// Number in a cell; of a table whose decimal mark is a comma, too.
std::optional<double> number_in(std::string text) {
    if (const auto number = parse_number(text)) return number;
    std::ranges::replace(text, ',', '.');
    return parse_number(text);
}

/// Label of a row: its first text that is no number; empty if there is none.
std::string label_of(const Row& row) {
    for (const Cell& cell : row.cells)
        if (!cell.text.empty() && !number_in(cell.text) && !marks_no_value(cell.text))
            return cell.text;
    return "";
}

/// Statistics of a column, of n values.
struct Statistics {
    double n = 0, sum = 0, squares = 0;  ///< squares of deviations from the mean

    double mean() const { return sum / n; }
    std::vector<double> all() const {
        const double variance = squares / (n - 1), deviation = std::sqrt(variance);
        return {mean(),   deviation,          std::sqrt(squares / n),   deviation / std::sqrt(n),
                variance, deviation / mean(), 100 * deviation / mean(), sum,
                n};
    }
};

/// Rows from the first to that before the last.
struct Range {
    std::size_t begin = 0, end = 0;
};

Statistics statistics_of(const std::vector<Row>& rows, Range range, std::size_t column) {
    Statistics found;
    std::vector<double> values;
    for (std::size_t i = range.begin; i < range.end; ++i)
        if (column < rows[i].cells.size())
            if (const auto number = number_in(rows[i].cells[column].text))
                values.push_back(*number);
    found.n = static_cast<double>(values.size());
    for (const double value : values)
        found.sum += value;
    for (const double value : values)
        found.squares += std::pow(value - found.mean(), 2);
    return found;
}

std::size_t decimals_of(std::string text) {
    std::ranges::replace(text, ',', '.');
    const std::size_t point = text.find('.');
    const std::size_t end = std::min(text.find_first_of("eE"), text.size());
    return point >= end ? 0 : end - point - 1;
}

/// Half of the last place of a number as it is written, and a little for rounding twice.
double half_of_last_place(const std::string& text) {
    return 0.55 * std::pow(10.0, -static_cast<double>(decimals_of(text)));
}

/// Whether the numbers of a row are one statistic of the columns above. One number alone may be so
/// by chance, unless the row names a statistic. A number that all rows above have, such as their
/// load, may be repeated.
/// @param fewest_rows with a number in each of its columns
bool is_computed(const Row& row, const std::vector<Row>& rows, Range range, double fewest_rows = 3,
                 std::size_t fewest_numbers = 2) {
    constexpr std::size_t kinds = 9;
    constexpr double unrounded = 3e-5;  // computed from values with more digits than are written
    std::array<bool, kinds> agrees;
    agrees.fill(true);
    std::size_t numbers = 0;
    for (std::size_t column = 0; column < row.cells.size(); ++column) {
        const std::string& text = row.cells[column].text;
        const auto number = number_in(text);
        if (!number) continue;
        const Statistics above = statistics_of(rows, range, column);
        if (above.n < fewest_rows) return false;
        if (fewest_numbers == 1 && above.squares == 0 && *number == above.mean()) continue;
        ++numbers;
        const std::vector<double> all = above.all();
        for (std::size_t k = 0; k < kinds; ++k)
            agrees[k] = agrees[k] && std::abs(*number - all[k]) <=
                                         half_of_last_place(text) + unrounded * std::abs(all[k]);
    }
    return numbers >= fewest_numbers && std::ranges::any_of(agrees, [](bool each) { return each; });
}

/// Whether a number of a row has more decimals than all above it, as computed ones have.
bool is_finer(const Row& row, const std::vector<Row>& rows, Range range) {
    for (std::size_t column = 0; column < row.cells.size(); ++column) {
        if (!number_in(row.cells[column].text)) continue;
        std::size_t most = 0;
        for (std::size_t i = range.begin; i < range.end; ++i)
            if (column < rows[i].cells.size())
                most = std::max(most, decimals_of(rows[i].cells[column].text));
        if (decimals_of(row.cells[column].text) > most) return true;
    }
    return false;
}

/// Words and letters that begin the name of a result of a line, or of a yield locus, as
/// `folded_name` has them ("cosione").
bool names_result(std::string_view text) {
    constexpr std::string_view results =
        "slope pente steigung pendiente pendenza intercept ordonnee achsenabschnitt ordenada "
        "intercetta r2 r² r c phi φ ϕ tan tanφ tanphi angle angolo angulo winkel cohesion "
        "kohasion cosione adhesion adherence ffc fc σc σ1 friction frottement attrito rozamiento "
        "reibungswinkel reibung flowability coulabilite fließfahigkeit fliessfahigkeit ucs mu μ "
        "b a resistance";
    const std::vector<std::string> words = words_of(text);
    return !words.empty() && is_among(results, words.front());
}

/// Whether a row is a result with its name, in a column of numbers: "pente;0,53", or "R² = 0,99"
/// alone.
bool is_result(const Row& row, const std::vector<Row>& rows) {
    std::size_t numbers = 0, first = row.cells.size();
    for (std::size_t i = 0; i < row.cells.size(); ++i) {
        if (row.cells[i].text.empty()) continue;
        first = std::min(first, i);
        numbers += number_in(row.cells[i].text).has_value();
    }
    if (numbers > 1 || first == row.cells.size() || first >= rows.front().cells.size() ||
        !number_in(rows.front().cells[first].text) || number_in(row.cells[first].text))
        return false;
    return names_result(row.cells[first].text);
}

/// Whether a row has the names of two results or more, with nothing else: the head of a table of
/// results.
bool heads_results(const Row& row) {
    std::size_t texts = 0, results = 0;
    for (const Cell& cell : row.cells) {
        if (cell.text.empty()) continue;
        if (number_in(cell.text)) return false;
        ++texts;
        results += names_result(cell.text);
    }
    return texts > 1 && results > 0;
}

/// The first cell of a row that names a statistic; empty if none does.
std::string named_statistic(const Row& row) {
    for (const Cell& cell : row.cells)
        if (!number_in(cell.text) && names_statistic(cell.text)) return cell.text;
    return "";
}

/// Whether a row names a statistic that its neighbours do not: several rows of one name in
/// succession are those of a sample.
bool names_statistic_alone(const std::vector<Row>& rows, std::size_t i) {
    const std::string name = named_statistic(rows[i]);
    return !name.empty() && (i == 0 || named_statistic(rows[i - 1]) != name) &&
           (i + 1 == rows.size() || named_statistic(rows[i + 1]) != name);
}

}  // namespace

bool names_statistic(std::string_view text) {
    const std::vector<std::string> words = words_of(text);
    const bool of_load = std::ranges::any_of(words, is_stress_unit);
    return std::ranges::any_of(words, is_statistic) &&
           std::ranges::all_of(words, [&](const std::string& word) {
               return is_statistic(word) || is_among(beside_statistics, word) ||
                      (of_load && (number_in(word) || is_stress_unit(word)));
           });
}

namespace {

/// Number of rows above the statistics and results below a table.
std::size_t rows_above_statistics(const std::vector<Row>& rows) {
    constexpr std::size_t most_statistics = 8, fewest_rows = 3;
    std::vector<std::string> labels;
    for (const Row& row : rows)
        labels.push_back(label_of(row));
    const auto states_statistic = [&](std::size_t i, std::size_t count) {
        const std::string& label = labels[i];
        const Range above = {0, count};
        if (is_result(rows[i], rows)) return true;
        if (label.empty())
            return is_computed(rows[i], rows, above) && is_finer(rows[i], rows, above);
        if (std::ranges::count(labels, label) > 1) return false;
        // "B1" is a further sample, even in the middle of the others.
        const bool numbered = std::isdigit(static_cast<unsigned char>(label.back())) != 0;
        return names_statistic(label) || (!numbered && is_computed(rows[i], rows, above));
    };
    const std::size_t least =
        std::max(fewest_rows, rows.size() - std::min(rows.size(), most_statistics));
    for (std::size_t count = least; count < rows.size(); ++count) {
        bool all = true, results = false;
        for (std::size_t i = count; all && i < rows.size(); ++i) {
            results = results || heads_results(rows[i]);
            all = results || states_statistic(i, count);
        }
        if (all) return count;
    }
    return rows.size();
}

}  // namespace

std::vector<std::size_t> rows_of_statistics(const std::vector<Row>& rows) {
    constexpr double fewest_repeats = 2;
    const std::size_t count = rows_above_statistics(rows);
    std::vector<std::size_t> found;
    Range above;  // rows since the last statistics
    for (std::size_t i = 0; i < count; ++i) {
        const bool behind_statistic = !found.empty() && found.back() + 1 == i;
        if (!behind_statistic) above.end = i;
        if (names_statistic_alone(rows, i) && is_computed(rows[i], rows, above, fewest_repeats, 1))
            found.push_back(i);
        else if (behind_statistic)
            above = {i, i};
    }
    for (std::size_t i = count; i < rows.size(); ++i)
        found.push_back(i);
    return found;
}

}  // namespace pendular
