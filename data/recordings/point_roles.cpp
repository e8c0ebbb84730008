#include "data/recordings/point_roles.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "data/files/folded_name.h"
#include "data/quantities/number.h"
#include "data/recordings/nines.h"

namespace pendular {
namespace {

template <std::size_t Size>
bool begins_with(std::string_view word, const std::array<std::string_view, Size>& begins) {
    return std::ranges::any_of(begins,
                               [&](std::string_view each) { return word.starts_with(each); });
}

template <std::size_t Size>
bool is_one_of(std::string_view word, const std::array<std::string_view, Size>& words) {
    return std::ranges::find(words, word) != words.end();
}

/// Label without its number and signs: "p" for "P 1", "preshear" for "Preshear?".
std::string label_of(std::string_view text) {
    std::string word = folded_name(text);
    while (!word.empty() &&
           std::string_view("0123456789#?:()*").find(word.back()) != std::string_view::npos)
        word.pop_back();
    return word;
}

}  // namespace

bool names_preshear(std::string_view text) {
    constexpr std::array<std::string_view, 10> begins = {
        "preshear", "anscher",  "vorscher", "precisai",   "precizal",
        "pretagl",  "consolid", "konsolid", "verfestigt", "preconsolid"};
    return begins_with(label_of(text), begins);
}

namespace {

bool names_steady_shear(std::string_view label) {
    constexpr std::array<std::string_view, 12> begins = {
        "steady",    "stationa", "critical",    "critique", "critico",   "residu",
        "stationar", "kritisch", "regimeperma", "residual", "estaciona", "stazionari"};
    return begins_with(label, begins);
}

bool abbreviates_preshear(std::string_view label) {
    constexpr std::array<std::string_view, 8> labels = {"p",  "pre", "ps",   "an",
                                                        "vs", "as",  "cons", "pc"};
    return is_one_of(label, labels);
}

bool names_failure(std::string_view label) {
    constexpr std::array<std::string_view, 17> begins = {
        "peak",    "shear",  "fail",  "incipient", "yield",     "max",
        "abscher", "bruch",  "scher", "cisaill",   "anfliesse", "ruptur",
        "rotur",   "rottur", "corte", "cizall",    "taglio"};
    constexpr std::array<std::string_view, 9> labels = {"s",    "f",     "sh", "ab", "pic",
                                                        "pico", "picco", "c",  ""};
    return is_one_of(label, labels) || begins_with(label, begins);
}

/// Whether a label is a yes; `folded_name` makes "tru" of "true", as if it were German.
bool says_yes(std::string_view label) {
    constexpr std::array<std::string_view, 12> words = {"tru", "yes", "y",    "ja",   "j",    "oui",
                                                        "si",  "sí",  "true", "wahr", "vrai", "x"};
    return is_one_of(label, words);
}

bool says_no(std::string_view label) {
    constexpr std::array<std::string_view, 8> words = {"",    "no",    "n",      "nein",
                                                       "non", "false", "falsch", "faux"};
    return is_one_of(label, words);
}

/// Whether rows are preshears by "yes" and "no", or their number and 0, in a column that a preshear
/// names.
std::vector<bool> answers(const std::vector<std::string>& cells) {
    constexpr double most = 99;  // a larger number is a stress
    std::vector<bool> marked;
    for (const std::string& cell : cells) {
        const std::string word = folded_name(cell);
        const double number = parse_number(cell).value_or(0);
        const bool counted = number > 0 && number <= most && number == std::floor(number);
        const bool yes = says_yes(word) || counted;
        if (!yes && !says_no(word) && word != "0") return {};
        marked.push_back(yes);
    }
    return marked;
}

}  // namespace

bool is_answer(const std::string& text) {
    const std::string word = folded_name(text);
    return !word.empty() && (says_yes(word) || says_no(word));
}

namespace {

/// Rows of which some are marked and others not; else none.
std::vector<bool> some_of(std::vector<bool> marked) {
    const auto count = std::ranges::count(marked, true);
    if (count == 0 || count == std::ssize(marked)) marked.clear();
    return marked;
}

std::vector<bool> rows_where(const std::vector<std::string>& cells,
                             bool (*holds)(std::string_view)) {
    std::vector<bool> marked;
    for (const std::string& cell : cells)
        marked.push_back(holds(label_of(cell)));
    return some_of(std::move(marked));
}

/// Whether each marked row is followed by rows of lower loads that are not marked.
bool precede_lower_loads(const std::vector<bool>& marked, const std::vector<double>& loads) {
    if (marked.empty() || !marked.front() || marked.back() || loads.size() != marked.size())
        return false;
    std::size_t before = 0;
    for (std::size_t i = 1; i < marked.size(); ++i) {
        if (marked[i] && marked[i - 1]) return false;
        if (marked[i])
            before = i;
        else if (!is_lower_load(loads[i], loads[before]))
            return false;
    }
    return true;
}

/// Whether marked rows are points of a sample of their own, such as one that was consolidated for
/// longer, rather than preshears: three in succession have different loads, and others have loads
/// as high.
bool are_points(const std::vector<bool>& marked, const std::vector<double>& loads) {
    constexpr std::size_t fewest = 3;  // of a line that is fitted
    if (loads.size() != marked.size()) return false;
    std::size_t most = 0, run = 0;
    double highest = 0, highest_of_others = 0;
    for (std::size_t i = 0; i < marked.size(); ++i) {
        double& top = marked[i] ? highest : highest_of_others;
        top = std::max(top, loads[i]);
        const bool goes_on = marked[i] && run > 0 && !is_same_load(loads[i], loads[i - 1]);
        run = goes_on ? run + 1 : marked[i] ? 1 : 0;
        most = std::max(most, run);
    }
    return most >= fewest && !is_lower_load(highest_of_others, highest);
}

std::vector<std::string> given_to(const std::vector<bool>& marked, const char* role) {
    std::vector<std::string> roles;
    for (const bool each : marked)
        roles.emplace_back(each ? role : "");
    return roles;
}

double first_or_none(const std::vector<double>& column) {
    return column.empty() ? std::nan("") : column.front();
}

double stress_ratio(const IntervalSeries& point) {
    return std::abs(first_or_none(point.shear_stress)) / first_or_none(point.normal_stress);
}

/// Sign of most shear stresses: -1 where a tester turns the other way.
double most_usual_sign(const std::vector<IntervalSeries>& points) {
    const auto negative = std::ranges::count_if(
        points, [](const IntervalSeries& each) { return first_or_none(each.shear_stress) < 0; });
    return 2 * negative > std::ssize(points) ? -1 : 1;
}

/// Whether the stress ratio of a point is one that the others may have too, so that a stress of
/// nines is a value: within a factor of 3 of theirs, as in `marks_of_nines`.
bool fits_others(const IntervalSeries& point, const std::vector<double>& others) {
    constexpr double far = 3;
    const double ratio = stress_ratio(point);
    if (others.empty() || !(ratio > 0)) return false;
    const auto [least, greatest] = std::ranges::minmax(others);
    return ratio > least / far && ratio < greatest * far;
}

/// Numbers in a column of a quantity, one for each row of a table of points, in the unit of the
/// file; NaN where a cell is none.
std::vector<double> numbers_of(const BlockFile& file, std::string_view quantity) {
    std::vector<double> numbers;
    for (const Block& block : file.blocks) {
        const auto column = std::ranges::find(block.columns, quantity, &BlockColumn::quantity);
        const std::optional<double> number =
            column == block.columns.end() || block.table.rows.empty()
                ? std::nullopt
                : parse_number(block.table.rows.front()
                                   .cells[static_cast<std::size_t>(column - block.columns.begin())]
                                   .text);
        numbers.push_back(number.value_or(std::nan("")));
    }
    return numbers;
}

/// Whether all rows that are not marked are labelled as points of failure.
bool others_fail(const std::vector<std::string>& cells, const std::vector<bool>& marked) {
    for (std::size_t i = 0; i < cells.size(); ++i)
        if (!marked[i] && !names_failure(label_of(cells[i]))) return false;
    return true;
}

}  // namespace

bool is_same_load(double a, double b) {
    constexpr double other_load = 0.05;
    return std::abs(a - b) <= other_load * std::max(std::abs(a), std::abs(b));
}

bool is_lower_load(double lower, double load) {
    return lower < load && !is_same_load(lower, load);
}

std::vector<std::string> roles_in_column(std::string_view name,
                                         const std::vector<std::string>& cells,
                                         const std::vector<double>& loads) {
    if (names_preshear(name))
        if (const auto marked = some_of(answers(cells));
            !marked.empty() && !are_points(marked, loads))
            return given_to(marked, "preshear");
    if (const auto marked = rows_where(cells, names_preshear);
        !marked.empty() && !are_points(marked, loads))
        return given_to(marked, "preshear");
    if (const auto marked = rows_where(cells, abbreviates_preshear);
        precede_lower_loads(marked, loads) && others_fail(cells, marked))
        return given_to(marked, "preshear");
    const auto steady = rows_where(cells, names_steady_shear);
    if (steady.empty() || !others_fail(cells, steady)) return {};
    return given_to(steady, precede_lower_loads(steady, loads) ? "preshear" : "other");
}

std::vector<bool> impossible_points(const BlockFile& file,
                                    const std::vector<IntervalSeries>& series) {
    std::vector<bool> of_nines(series.size(), false);
    if (!file.table_of_points) return of_nines;
    for (const char* const quantity : {"normal_stress", "shear_stress"})
        for (const std::size_t i : marks_of_nines(numbers_of(file, quantity)))
            of_nines[i] = true;
    std::vector<double> ratios;  // of the other points
    for (std::size_t i = 0; i < series.size(); ++i)
        if (!of_nines[i] && stress_ratio(series[i]) > 0) ratios.push_back(stress_ratio(series[i]));
    const double sense = most_usual_sign(series);
    for (std::size_t i = 0; i < series.size(); ++i)
        of_nines[i] = of_nines[i] && (sense * first_or_none(series[i].shear_stress) < 0 ||
                                      !fits_others(series[i], ratios));
    return of_nines;
}

}  // namespace pendular
