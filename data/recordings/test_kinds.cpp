#include "data/recordings/test_kinds.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <filesystem>
#include <numeric>
#include <string_view>

#include "data/files/columns.h"
#include "data/files/folded_name.h"
#include "data/files/text_pattern.h"
#include "data/quantities/statistics.h"
#include "data/recordings/findings/detectors.h"
#include "data/recordings/stated_facts.h"
#include "data/recordings/step_series.h"
#include "data/recordings/time_series.h"

namespace pendular {

namespace {

/// Whether values are steps of constant load rather than a ramp: a few jumps pass most of the
/// range.
bool has_steps(const std::vector<double>& values) {
    // Chosen: a ramp of so many rows changes by less from one row to the next.
    constexpr double jump = 0.1, most_of_range = 0.8;
    constexpr std::size_t rows_of_step = 10;
    const auto [least, greatest] = std::ranges::minmax_element(values);
    const double range = *greatest - *least;
    double passed = 0;
    std::size_t jumps = 0;
    for (std::size_t i = 1; i < values.size(); ++i) {
        const double change = std::abs(values[i] - values[i - 1]);
        if (change < jump * range) continue;
        passed += change;
        ++jumps;
    }
    return passed >= most_of_range * range && jumps * rows_of_step <= values.size();
}

}  // namespace

std::optional<std::string> load_ramp(const IntervalSeries& series) {
    const auto ramp = speed_ramp(series.normal());
    if (!ramp || has_steps(series.normal())) return std::nullopt;
    return fmt::format("load ramp: the normal {} changes {}",
                       series.normal_stress.empty() ? "force" : "stress", ramp->change());
}

bool has_column_of_readings(const Block& block) {
    constexpr std::array<std::string_view, 5> names = {
        "shear_velocity", "shear_rate", "inertial_number", "height", "solid_fraction"};
    // Results of ring shear testers give the height at each point.
    const bool of_points = block.has_column("preshear_stress");
    return std::ranges::any_of(block.columns, [&](const BlockColumn& column) {
        const bool also_of_points =
            of_points && (column.quantity == "height" || column.quantity == "solid_fraction");
        return std::ranges::find(names, column.quantity) != names.end() && !also_of_points;
    });
}

bool is_table_of_readings(const Block& block) {
    const auto has = [&](std::string_view name) { return block.has_column(name); };
    return (!has("time") || has("error_assumed") || has("sampled_seconds")) &&
           has("normal_stress") && (has("shear_stress") || has("stress_ratio")) &&
           (has("solid_fraction") || has("bulk_density")) &&
           (has("shear_rate") || has("inertial_number") || has("inertial_number_diameter_density"));
}

bool is_stated_failure(const Block& block) {
    if (!block.has_column("failure") || block.has_column("time")) return false;
    const Columns columns(block.table);
    return columns.has("failure") && std::ranges::all_of(block.table.rows, [&](const Row& row) {
               return columns.value_if_any(row, "failure").value_or(0) != 0;
           });
}

namespace {

constexpr std::size_t most_points = 1000, fewest_points = 3;

}  // namespace

bool loads_differ_by_row(const IntervalSeries& series) {
    // Two thirds of the least step between set points that steps.cpp tells apart.
    constexpr double jump = 0.05;
    const std::vector<double>& load = series.normal();
    if (load.size() < fewest_points || load.size() > most_points) return false;
    std::size_t jumps = 0;
    for (std::size_t i = 1; i < load.size(); ++i) {
        const double before = load[i - 1], now = load[i];
        jumps += std::abs(now - before) > jump * std::max(std::abs(now), std::abs(before));
    }
    return jumps >= 2 && 4 * jumps >= load.size();
}

bool is_table_of_points(const Block& block, const IntervalSeries& series) {
    const bool stresses = !series.shear_stress.empty() && !series.normal_stress.empty();
    if (stresses && is_stated_failure(block)) return series.size() <= most_points;
    if (!stresses || !series.time.empty() || !series.angular_velocity.empty() ||
        !series.interval.empty() || has_column_of_readings(block) || block.declared_rows)
        return false;
    return loads_differ_by_row(series);
}

namespace {

using Parts = std::vector<std::string_view>;

bool begins_with_any(std::string_view word, const Parts& parts) {
    return std::ranges::any_of(parts,
                               [&](std::string_view part) { return word.starts_with(part); });
}

/// Words for wall friction that are written together, or apart with nothing between them.
bool names_wall_friction_jointly(std::string_view text) {
    constexpr std::array<std::string_view, 16> names = {
        "wallcoupon",   "wallfriction", "wallyield",    "wandreibung",
        "wandfließ",    "wandfliess",   "wandwrijving", "wandfrictie",
        "väggfriktion", "vægfriktion",  "veggfriksjon", "falisúrlódás",
        "seinäkitka",   "duvarsürtün",  "壁面摩擦",     "壁摩擦"};
    std::string joined;
    for (const std::string& word : lower_case_words(text))
        joined += word;
    return std::ranges::any_of(
        names, [&](std::string_view name) { return joined.find(name) != std::string::npos; });
}

/// Whether a word is that of a material of walls.
bool names_wall_material(std::string_view word) {
    static const Parts begins = {"steel",   "stahl",      "edelstahl", "acier", "acero", "acciaio",
                                 "staal",   "inox",       "stainless", "alu",   "ptfe",  "teflon",
                                 "pmma",    "plexiglas",  "perspex",   "beton", "béton", "concrete",
                                 "316",     "304",        "pvc",       "hdpe",  "tivar", "uhmw",
                                 "alumini", "geomembran", "polyethyl", "aço",   "hormig"};
    return begins_with_any(word, begins);
}

/// Whether a text speaks of shear along an interface with a wall: "Sand-steel interface shear".
bool names_interface(const std::vector<std::string>& words) {
    const bool interface = std::ranges::any_of(
        words, [](const std::string& word) { return word.starts_with("interfa"); });
    return interface && std::ranges::any_of(words, names_wall_material);
}

/// Whether the name of one test among others means a wall: "wall (steel)", "glass on steel wall". A
/// "smooth wall" is that of a cell.
bool names_wall_and_material(std::string_view text) {
    static const Parts walls = {"wall", "wand", "paroi", "pared", "parete", "parede"};
    static const Parts against = {"on",  "against", "auf",    "gegen",  "an",
                                  "sur", "contre",  "contro", "contra", "sobre"};
    const std::vector<std::string> words = lower_case_words(text);
    bool wall = false, opposed = false, others = false;
    for (const std::string& word : words) {
        const bool is_wall = std::ranges::find(walls, word) != walls.end();
        wall |= is_wall;
        opposed |= !wall && std::ranges::find(against, word) != against.end();
        others |= !is_wall && !names_wall_material(word);
    }
    return wall && (opposed || !others);
}

/// Whether a text speaks of the friction along a wall, in words such as "attrito con la parete": a
/// cell with "rough walls" has another friction too, and so has "internal friction, wall of steel".
bool names_wall_friction(std::string_view text) {
    static const Parts frictions = {"friction", "frottement", "attrito",  "atrito",     "fricción",
                                    "friccion", "fricção",    "friccao",  "rozamiento", "tarci",
                                    "wrijving", "frictie",    "friktion", "friksjon",   "tření",
                                    "reibung",  "sürtünme"};
    static const Parts between = {
        "a",       "à",      "al",  "alla",  "an",  "at",     "au",     "com",    "con",
        "contra",  "contre", "ai",  "alle",  "aux", "contro", "poudre", "powder", "pulver",
        "polvere", "polvo",  "da",  "de",    "del", "della",  "der",    "di",     "en",
        "il",      "in",     "l",   "la",    "le",  "met",    "mit",    "na",     "o",
        "on",      "sulla",  "sur", "tegen", "the", "une"};
    static const Parts walls = {"wall",   "wand", "paroi", "pared", "paret", "pariét",
                                "pariet", "ścia", "stěn",  "vägg",  "væg",   "vegg"};
    // ASTM and testers of powders abbreviate the wall friction test.
    const std::vector<std::string> all = lower_case_words(text);
    if (std::ranges::find(all, "wft") != all.end()) return true;
    if (names_wall_friction_jointly(text) || names_interface(all)) return true;
    bool of_friction = false;
    std::string word;
    for (const char c : lower_case(text) + " ") {
        if (std::string_view(" _-'/").find(c) == std::string_view::npos) {
            word += c;
            continue;
        }
        if (word.empty()) continue;
        if (of_friction && begins_with_any(word, walls)) return true;
        const bool ends = std::string_view(".,:;)").find(word.back()) != std::string_view::npos;
        const bool goes_on = begins_with_any(word, frictions) ||
                             (of_friction && std::ranges::find(between, word) != between.end());
        of_friction = goes_on && !ends;
        word.clear();
    }
    return false;
}

/// Parts of a text between commas and the like.
std::vector<std::string_view> clauses_of(std::string_view text) {
    std::vector<std::string_view> clauses;
    while (true) {
        const std::size_t end = std::min(text.find_first_of(",;:"), text.size());
        clauses.push_back(text.substr(0, end));
        if (end == text.size()) return clauses;
        text.remove_prefix(end + 1);
    }
}

/// Whether a text that speaks of wall friction denies that it is tested, corrects for it, states
/// its value, or refers to another file.
bool speaks_of_wall_beside_test(std::string_view text) {
    static const Parts begins = {"negl",    "vernachl", "néglig", "desprec", "trascur",
                                 "ignor",   "correct",  "korr",   "corrig",  "corrett",
                                 "compens", "kompens",  "siehe",  "voir",    "vedi",
                                 "véase",   "csv",      "xlsx",   "assumed"};
    static const Parts whole = {"not", "without", "ohne",  "kein", "keine", "sans",
                                "non", "sin",     "senza", "none", "see",   "is"};
    static const TextPattern value(
        R"((?:of|der|de|della|del)\s+(?:the\s+|la\s+)?(?:cell|zelle|celd))"
        R"(|\d\s*(?:°|deg|grad)|(?:angle|winkel|coeff?ici|koeffi|angolo|ángulo|kąt|=)\D*\d)");
    const std::vector<std::string> words = lower_case_words(text);
    for (std::size_t i = 0; i < words.size(); ++i) {
        // "Wall friction test no. 3" denies nothing.
        const bool denies = words[i] == "no" && i + 1 < words.size() &&
                            !std::isdigit(static_cast<unsigned char>(words[i + 1].front()));
        if (denies || begins_with_any(words[i], begins) ||
            std::ranges::find(whole, words[i]) != whole.end())
            return true;
    }
    return value.first(lower_case(text)).has_value();
}

/// Whether a text names a test of wall friction: its first part does so, or one that says no more
/// or has a word for a test.
bool names_wall_test(std::string_view text) {
    static const Parts tests = {"test",  "versuch", "prüf",  "pruef",  "mess",  "essai", "mesure",
                                "prova", "misura",  "ensay", "ensaio", "locus", "badan", "zkouš"};
    if (!names_wall_friction(text) || speaks_of_wall_beside_test(text)) return false;
    constexpr std::size_t no_more = 3;  // words: "friction at walls"
    const std::vector<std::string_view> clauses = clauses_of(text);
    for (const std::string_view clause : clauses) {
        if (!names_wall_friction(clause)) continue;
        const std::vector<std::string> words = lower_case_words(clause);
        if (clause.data() == clauses.front().data() || words.size() <= no_more ||
            std::ranges::any_of(
                words, [](const std::string& word) { return begins_with_any(word, tests); }))
            return true;
    }
    return false;
}

/// Whether a line above a table names it a test of wall friction. A number as its value is that of
/// the friction.
bool states_wall_test(const Fact& fact) {
    if (fact.key.starts_with("title")) return names_wall_test(fact.value);
    const bool number = !fact.value.empty() && fact.value.size() < 100 &&
                        std::isdigit(static_cast<unsigned char>(fact.value.front())) &&
                        names_wall_friction(fact.key);
    return !number && names_wall_test(fact.key + ": " + fact.value);
}

/// Whether a column of stresses has a name of a wall, by whole words: "Prepared" holds "pared".
bool is_of_wall(const BlockColumn& column) {
    constexpr std::array<std::string_view, 8> names = {"wall", "paroi",  "pared", "parete",
                                                       "tauw", "sigmaw", "τw",    "σw"};
    constexpr std::array<std::string_view, 4> symbols = {"tau", "sigma", "τ", "σ"};
    if (column.quantity != "shear_stress" && column.quantity != "normal_stress") return false;
    const std::vector<std::string> words = lower_case_words(column.name);
    for (std::size_t i = 0; i < words.size(); ++i) {
        // German joins words: "Wandschubspannung".
        if (std::ranges::find(names, words[i]) != names.end() || words[i].starts_with("wand") ||
            words[i].starts_with("pariét"))
            return true;
        if (i + 1 < words.size() && words[i + 1] == "w" &&
            std::ranges::find(symbols, words[i]) != symbols.end())
            return true;
    }
    return false;
}

/// Means over the last tenths of a column's rows, the last first; of magnitudes.
std::array<double, 3> last_tenths(const std::vector<double>& column) {
    std::array<double, 3> means = {};
    const std::size_t rows = std::max<std::size_t>(column.size() / 10, 1);
    for (std::size_t k = 0; k < means.size(); ++k) {
        for (std::size_t i = 0; i < rows; ++i)
            means[k] += std::abs(column[column.size() - (k + 1) * rows + i]);
        means[k] /= static_cast<double>(rows);
    }
    return means;
}

/// Whether the shear still rises over the last three tenths of the rows by more than noise does:
/// its rise from the first to the last of them against the standard error, which includes
/// autocorrelation, of the difference of two tenths.
bool rises_beyond_noise(const std::vector<double>& shear, double rise) {
    const std::size_t rows = 3 * std::max<std::size_t>(shear.size() / 10, 1);
    std::vector<double> end;
    for (std::size_t i = shear.size() - rows; i < shear.size(); ++i)
        end.push_back(std::abs(shear[i]));
    const Mean mean = mean_of_correlated(without_line(end));
    const double n = static_cast<double>(rows), of_line = 2;  // degrees of freedom
    // The mean of a tenth has three times the variance of that of three; the line takes its share.
    const double error = mean.standard_error * std::sqrt(2 * 3 * n / (n - of_line));
    // Correlation is in the error. Fewer degrees of freedom for it would lose a smooth rise that
    // bends, whose deviations from the line are correlated.
    return two_sided_p(rise / error, n - of_line) <= finding_significance;
}

}  // namespace

const char* shear_word(const IntervalSeries& series) {
    if (!series.shear_stress.empty()) return "shear stress";
    return series.torque.empty() ? "lever force" : "torque";
}

std::string shown_wall(const BlockFile& file) {
    for (const Block& block : file.blocks)
        for (const BlockColumn& column : block.columns)
            if (is_of_wall(column)) return fmt::format("its column '{}'", column.name);
    const auto named = std::ranges::count_if(
        file.blocks, [](const Block& block) { return !named_wall(block).empty(); });
    // Where some tests have such a name, others are none.
    if (named > 0) return named == std::ssize(file.blocks) ? named_wall(file.blocks.front()) : "";
    for (const Fact& fact : file.facts)
        if (states_wall_test(fact))
            return fmt::format("its line '{}'", fact.key.starts_with("title")
                                                    ? fact.value
                                                    : fact.key + ": " + fact.value);
    const std::string name = std::filesystem::path(file.file).filename().string();
    return names_wall_friction(name) ? fmt::format("its name '{}'", name) : "";
}

std::string named_wall(const Block& block) {
    return names_wall_test(block.test) || names_wall_and_material(block.test)
               ? fmt::format("its name '{}'", block.test)
               : "";
}

std::optional<std::string> stress_growth(const IntervalSeries& series) {
    constexpr double grows = 0.02;  // in a tenth: above it, `preshear_point` sees no plateau
    if (series.size() < shortest_step || series.shear().empty() || series.normal().empty())
        return std::nullopt;
    const auto rise = last_tenths(series.shear()), load = last_tenths(series.normal());
    const auto constant = [&](const std::array<double, 3>& means) {
        return std::abs(means[0] - means[2]) <= grows * means[0];
    };
    const auto speed = series.angular_velocity.empty() ? std::array<double, 3>{}
                                                       : last_tenths(series.angular_velocity);
    if (!constant(load) || !constant(speed) || !(rise[0] > (1 + grows) * rise[1]) ||
        !(rise[1] > (1 + grows) * rise[2]) ||
        !rises_beyond_noise(series.shear(), rise[0] - rise[2]))
        return std::nullopt;
    return fmt::format(
        "stress growth: at constant speed, the {} still rises by {:.0f} % "
        "over the last tenth of the rows: no steady shear is reached",
        shear_word(series), 100 * (rise[0] / rise[1] - 1));
}

std::optional<std::string> stick_slip(const IntervalSeries& series) {
    // Smaller drops are a fault of a recording that stays useful; the findings tell of them.
    constexpr double least_drop = 0.1;
    const std::vector<double>& shear = series.shear();
    std::vector<double> values;
    for (const double value : shear)
        if (std::isfinite(value)) values.push_back(std::abs(value));
    if (values.size() < 2 * shortest_step) return std::nullopt;
    const double mean =
        std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
    const auto found = slips(values, least_step(values));
    if (!found || found->p > finding_significance || !(found->drop > least_drop * mean))
        return std::nullopt;
    return fmt::format(
        "stick-slip: the {} drops suddenly by {:.0f} % every {:.0f} rows: "
        "no steady shear",
        shear_word(series), 100 * found->drop / mean, found->samples);
}

}  // namespace pendular
