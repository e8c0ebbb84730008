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
        word = folded_name(word);
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

Statistics statistics_of(const std::vector<Row>& rows, std::size_t count, std::size_t column) {
    Statistics found;
    std::vector<double> values;
    for (std::size_t i = 0; i < count; ++i)
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

/// Half of the last place of a number as it is written, and a little for rounding twice.
double half_of_last_place(std::string text) {
    std::ranges::replace(text, ',', '.');
    const std::size_t point = text.find('.');
    const std::size_t end = std::min(text.find_first_of("eE"), text.size());
    const auto decimals = point == std::string::npos ? 0.0 : static_cast<double>(end - point - 1);
    return 0.55 * std::pow(10.0, -decimals);
}

/// Whether the numbers of a row are one statistic of the columns above. One number alone may be so
/// by chance.
bool is_computed(const Row& row, const std::vector<Row>& rows, std::size_t count) {
    constexpr std::size_t kinds = 9, fewest_numbers = 2;
    std::array<bool, kinds> agrees;
    agrees.fill(true);
    std::size_t numbers = 0;
    for (std::size_t column = 0; column < row.cells.size(); ++column) {
        const std::string& text = row.cells[column].text;
        const auto number = number_in(text);
        if (!number) continue;
        const Statistics above = statistics_of(rows, count, column);
        if (above.n < 3) return false;
        ++numbers;
        const std::vector<double> all = above.all();
        for (std::size_t k = 0; k < kinds; ++k)
            agrees[k] = agrees[k] && std::abs(*number - all[k]) <= half_of_last_place(text);
    }
    return numbers >= fewest_numbers && std::ranges::any_of(agrees, [](bool each) { return each; });
}

}  // namespace

bool names_statistic(std::string_view text) {
    const std::vector<std::string> words = words_of(text);
    return std::ranges::any_of(words, is_statistic) &&
           std::ranges::all_of(words, [](const std::string& word) {
               return is_statistic(word) || is_among(beside_statistics, word);
           });
}

std::size_t rows_above_statistics(const std::vector<Row>& rows) {
    constexpr std::size_t most_statistics = 8, fewest_rows = 3;
    std::vector<std::string> labels;
    for (const Row& row : rows)
        labels.push_back(label_of(row));
    const auto states_statistic = [&](std::size_t i, std::size_t count) {
        const std::string& label = labels[i];
        if (label.empty() || std::ranges::count(labels, label) > 1) return false;
        // "B1" is a further sample, even in the middle of the others.
        const bool numbered = std::isdigit(static_cast<unsigned char>(label.back())) != 0;
        return names_statistic(label) || (!numbered && is_computed(rows[i], rows, count));
    };
    const std::size_t least =
        std::max(fewest_rows, rows.size() - std::min(rows.size(), most_statistics));
    for (std::size_t count = least; count < rows.size(); ++count) {
        bool all = true;
        for (std::size_t i = count; all && i < rows.size(); ++i)
            all = states_statistic(i, count);
        if (all) return count;
    }
    return rows.size();
}

}  // namespace pendular
