#include "data/quantities/units.h"

#include <fmt/format.h>
#include <udunits2.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <map>
#include <memory>
#include <mutex>
#include <numbers>
#include <stdexcept>
#include <utility>
#include <vector>

#include "data/grains.h"
#include "data/quantities/number.h"

namespace pendular {
namespace {

/// Least ratio of a unit to the SI unit; its inverse is the greatest. Refuses units
/// such as "1e308 kN m".
constexpr double smallest_factor = 1e-30;

/// Mutex to hold in every call of UDUNITS, which has global state.
std::mutex& udunits_mutex() {
    static std::mutex mutex;
    return mutex;
}

/// Unit system of UDUNITS, read in the first call. To be called with `udunits_mutex` held.
/// @throws std::runtime_error if the unit database is not installed
ut_system* unit_system() {
    static ut_system* const system = [] {
        ut_set_error_message_handler(ut_ignore);
        ut_system* const read = ut_read_xml(nullptr);
        if (!read) throw std::runtime_error("the unit database of UDUNITS-2 is not installed");
        return read;
    }();
    return system;
}

/// Characters that instruments write, with the text that UDUNITS reads. The two micro signs differ
/// in Unicode.
constexpr std::pair<std::string_view, std::string_view> characters[] = {
    {"−", "-"},
    {"µ", "u"},
    {"μ", "u"},
    {"°C", "degC"},
    {"℃", "degC"},
    {"°", "deg"},
    {"％", "%"},
    {"㎜", "mm"},
    {"㎝", "cm"},
    {"㎏", "kg"},
    {"½", "0.5"},
    {"\u00a0", " "},
    {"\u202f", " "},
    // Abbreviations whose points would be products; in French, "mn" is a minute.
    {"r.p.m.", "rpm"},
    {"Umdr.", "turn"},
    {"Sek.", "s"},
    {"sek.", "s"},
    {"seg.", "s"},
    {"Min.", "min"},
    {"tr/mn", "turn/min"},
    // Words beyond ASCII, which `normalised` does not find: Russian, Ukrainian, Czech, Japanese
    // and Chinese.
    {"об.", "turn"},
    {"об", "turn"},
    {"мин", "min"},
    {"хв", "min"},
    {"otáčky", "turn"},
    {"otáček", "turn"},
    {"回転", "turn"},
    {"分钟", "min"},
    {"分", "min"},
    {"秒", "s"}};

/// Signs of a product that have the look of "·", in Japanese texts too, and crosses.
constexpr std::string_view product_points[] = {"·", "⋅", "•", "∙", "‧", "・", "･"};
constexpr std::string_view product_crosses[] = {"×", "∗", "*"};

/// Characters of exponents with those that UDUNITS reads behind "^".
constexpr std::pair<std::string_view, char> superscripts[] = {
    {"⁰", '0'}, {"¹", '1'}, {"²", '2'}, {"³", '3'}, {"⁴", '4'}, {"⁵", '5'},
    {"⁶", '6'}, {"⁷", '7'}, {"⁸", '8'}, {"⁹", '9'}, {"⁺", '+'}, {"⁻", '-'}};

/// Spellings of units that UDUNITS does not know or misreads, with the spelling that UDUNITS reads.
const std::map<std::string, std::string, std::less<>> words = {
    {"deg", "arc_degree"}, {"rev", "turn"},
    {"revs", "turn"},      {"tr", "turn"},
    {"r", "turn"},         {"Upm", "turn/min"},
    {"tour", "turn"},      {"tours", "turn"},
    {"giri", "turn"},      {"Umdr", "turn"},
    {"RPM", "rpm"},        {"rps", "turn/s"},
    {"U", "turn"},         {"gf", "gram_force"},
    {"dyn", "dyne"},       {"cP", "cpoise"},
    {"mcm", "um"},         {"pct", "%"},
    {"percent", "%"},      {"Pas", "Pa.s"},
    {"mPas", "mPa.s"},     {"cc", "cm3"},
    {"ccm", "cm3"},        {"radians", "radian"},
    {"kgfcm", "kgf.cm"},   {"gfcm", "gram_force.cm"},
    {"kp", "kgf"},         {"ozf", "(lbf/16)"},  // UDUNITS rounds the latter
    {"vuelta", "turn"},    {"vueltas", "turn"},
    {"Sek", "s"},          {"sek", "s"},
    {"seg", "s"},          {"Min", "min"},
    {"psf", "(lbf/ft^2)"}, {"giro", "turn"},
    {"lbs", "lb"},         {"LBS", "lb"},
    {"LB", "lb"},          {"LBF", "lbf"},
    {"IN", "in"},          {"FT", "ft"},
    {"inlbf", "in.lbf"},   {"lbfin", "lbf.in"},
    {"ftlbf", "ft.lbf"},   {"lbfft", "lbf.ft"},
    {"Grad", "arc_degree"}};  // not a gigaradian

/// Words for a revolution in Polish, Czech, Dutch, Swedish, Danish, Norwegian, Portuguese,
/// Romanian, Turkish, Hungarian and Finnish, of which none is another unit, and for a minute.
/// Turkish "d/dak" is left out, since d is a day.
constexpr std::array<std::string_view, 15> revolutions = {
    "obr",    "obroty", "ot",    "omw",  "varv",     "omdr",  "omdrejninger", "rot",
    "voltas", "dev",    "devir", "ford", "fordulat", "kierr", "kierrosta"};
constexpr std::array<std::string_view, 4> minutes = {"dak", "dk", "dakika", "perc"};

/// Spellings in the wrong case that UDUNITS reads as another unit, with the unit that is meant.
const std::map<std::string, std::string, std::less<>> case_traps = {
    {"pa", "Pa"},    {"kpa", "kPa"}, {"mpa", "MPa' or 'mPa"},
    {"Mpa", "MPa"},  {"MPA", "MPa"}, {"hpa", "hPa"},
    {"KPa", "kPa"},  {"PA", "Pa"},   {"gpa", "GPa"},
    {"Gpa", "GPa"},  {"kn", "kN"},   {"mn", "mN"},
    {"KG", "kg"},    {"Kg", "kg"},   {"MM", "mm"},
    {"Mm", "mm"},    {"NM", "N m"},  {"MNm", "mN m"},
    {"MN", "mN"},    {"Ms", "ms"},   {"Mrad", "mrad"},
    {"Mbar", "mbar"}};

void replace_all(std::string& text, std::string_view from, std::string_view to) {
    for (std::size_t at = text.find(from); at != std::string::npos;
         at = text.find(from, at + to.size()))
        text.replace(at, from.size(), to);
}

/// Unit of a torque with a point between force and length, which UDUNITS needs: "mN.m" for "mNm".
/// Other words are returned unchanged.
std::string split_torque(const std::string& word) {
    for (const std::string_view length : {"mm", "cm", "m"}) {
        if (!word.ends_with(length)) continue;
        const std::string force = word.substr(0, word.size() - length.size());
        const std::string_view prefix = std::string_view(force).substr(0, force.size() - 1);
        const bool newton =
            force.ends_with('N') && (prefix.empty() || prefix == "k" || prefix == "m" ||
                                     prefix == "u" || prefix == "n" || prefix == "c");
        if (newton) return fmt::format("{}.{}", force, length);
    }
    return word;
}

/// Spelling of one word of a unit that UDUNITS reads. `spelling` is the whole unit, for the
/// message.
/// @throws std::invalid_argument if the case of the word makes it another unit than the likely one
std::string normalised_word(const std::string& word, std::string_view spelling) {
    if (const auto trap = case_traps.find(word); trap != case_traps.end())
        throw std::invalid_argument(
            fmt::format("'{}' is not a safe spelling of a unit, since upper and lower case differ "
                        "in meaning; write '{}'",
                        spelling, trap->second));
    if (const auto known = words.find(word); known != words.end()) return known->second;
    if (std::ranges::find(revolutions, word) != revolutions.end()) return "turn";
    if (std::ranges::find(minutes, word) != minutes.end()) return "min";
    return split_torque(word);
}

bool is_digit(char c) {
    return std::isdigit(static_cast<unsigned char>(c)) != 0;
}

bool is_letter(char c) {
    return std::isalpha(static_cast<unsigned char>(c)) != 0;
}

/// Text with exponents as UDUNITS reads them: "10^-3" for "10⁻³" and "10**-3". A digit in place of
/// an exponent would be one of the base, "103".
std::string with_plain_exponents(std::string_view text) {
    std::string result;
    bool within = false;
    while (!text.empty()) {
        const auto raised = std::ranges::find_if(
            superscripts, [&](const auto& each) { return text.starts_with(each.first); });
        if (raised == std::end(superscripts)) {
            result += text.front();
            text.remove_prefix(1);
            within = false;
            continue;
        }
        const bool plain_sign = !within && result.ends_with('-');  // "s-¹"
        if (plain_sign) result.pop_back();
        if (!within && !result.ends_with('^')) result += '^';
        if (plain_sign) result += '-';
        result += raised->second;
        text.remove_prefix(raised->first.size());
        within = true;
    }
    replace_all(result, "**", "^");
    return result;
}

/// Index of the first character from `at` on that is no blank.
std::size_t after_blanks(std::string_view text, std::size_t at) {
    return std::min(text.find_first_not_of(' ', at), text.size());
}

/// Whether the character at an index is the letter x in place of the sign of a product: "x10^3".
bool is_product_letter(std::string_view text, std::size_t at) {
    if ((text[at] != 'x' && text[at] != 'X') || (at > 0 && is_letter(text[at - 1]))) return false;
    const std::size_t next = after_blanks(text, at + 1);
    return next < text.size() && is_digit(text[next]);
}

/// Text with one character for each sign of a product: a point for those like "·", '*' for a cross.
std::string with_signs_of_products(std::string_view text, char point) {
    std::string result(text);
    for (const std::string_view sign : product_points)
        replace_all(result, sign, std::string_view(&point, 1));
    for (const std::string_view sign : product_crosses)
        replace_all(result, sign, "*");
    return result;
}

/// Whether a cross between two texts puts a factor behind a unit or before nothing: "N m × 1000"
/// and "×1000 N m" may say that the numbers were multiplied by it, or that they are to be.
bool multiplies_numbers(std::string_view before, bool cross, char after) {
    if (!is_digit(after)) return false;
    const bool nothing = before.empty() || before.ends_with('(');
    return nothing || (cross && before.find_first_not_of("0123456789.^-+") != before.npos);
}

/// Text with '*' for every sign of a product, without blanks around it. UDUNITS reads a point
/// before a digit as that of a decimal.
/// @throws std::invalid_argument for a factor of the numbers, `multiplies_numbers`
std::string with_plain_products(std::string_view written, std::string_view spelling) {
    constexpr char point = '\1';
    const std::string text = with_signs_of_products(written, point);
    std::string result;
    for (std::size_t i = 0; i < text.size(); ++i) {
        if (text[i] != '*' && text[i] != point && !is_product_letter(text, i)) {
            result += text[i];
            continue;
        }
        const std::size_t next = after_blanks(text, i + 1);
        result.resize(trimmed(result).empty() ? 0 : result.find_last_not_of(' ') + 1);
        if (multiplies_numbers(result, text[i] != point, next < text.size() ? text[next] : ' '))
            throw std::invalid_argument(fmt::format(
                "'{}' may say that the numbers were multiplied by the factor, or that they are to "
                "be; write their unit, as in '10^3 Pa' or 'mN m'",
                spelling));
        result += '*';
        i = next - 1;
    }
    return result;
}

/// Whether a number that is a factor of a unit may be another one: "103 Pa" and "10 3 Pa" may be
/// 10^3 Pa without the raised digits, and "10e3" may be meant as 1e3.
bool may_be_power(std::string_view factor, std::string_view rest) {
    if (!factor.starts_with("10")) return false;
    const std::string_view further = factor.substr(2);
    const std::size_t next = after_blanks(rest, 0);
    const bool another = next > 0 && next < rest.size() &&
                         (is_digit(rest[next]) || rest[next] == '-' || rest[next] == '+');
    const bool raised = !further.empty() && further.size() <= 2 &&
                        further.find_first_not_of("0123456789") == std::string_view::npos &&
                        further.find_first_not_of('0') != std::string_view::npos;
    return another || raised || further.starts_with('e') || further.starts_with('E');
}

/// @throws std::invalid_argument for a factor that may be a power of ten written in another way
/// @param text with the signs that UDUNITS reads; `spelling` is for the message
void refuse_unclear_factor(std::string_view text, std::string_view spelling) {
    for (std::size_t i = 0; i < text.size(); ++i) {
        const bool begins =
            i == 0 || std::string_view(" */(").find(text[i - 1]) != std::string::npos;
        if (!begins || !is_digit(text[i])) continue;
        std::size_t end = std::min(text.find_first_not_of("0123456789.", i), text.size());
        if (end + 1 < text.size() && (text[end] == 'e' || text[end] == 'E') &&
            !is_letter(text[end + 1]))
            ++end;
        if (may_be_power(text.substr(i, end - i), text.substr(end)))
            throw std::invalid_argument(fmt::format(
                "'{}' has a factor that may be a power of ten; write it as in '10^3 Pa'",
                spelling));
    }
}

std::string normalised(std::string_view spelling) {
    std::string text(trimmed(spelling));
    for (const auto& [from, to] : characters)
        replace_all(text, from, to);
    text = with_plain_products(with_plain_exponents(text), spelling);
    if (text.empty() || text == "-") return "1";
    if (text == "o/min") return "turn/min";  // Danish, Norwegian; an o alone may be a degree
    refuse_unclear_factor(text, spelling);
    std::string result;
    for (std::size_t i = 0; i < text.size();) {
        std::size_t end = i;
        while (end < text.size() && is_letter(text[end]))
            ++end;
        if (end > i) {
            result += normalised_word(text.substr(i, end - i), spelling);
            i = end;
            // The point of an abbreviation, "obr./min.": no product, since nothing follows.
            if (i < text.size() && text[i] == '.' && (i + 1 == text.size() || text[i + 1] == '/'))
                ++i;
        } else {
            result += text[i++];
        }
    }
    return result;
}

/// Dimension of a unit, found by the visitor of UDUNITS.
struct Parts {
    std::string dimension;          ///< product of SI base units, "kg m^2 s^-2" for example
    const ut_unit* base = nullptr;  ///< unit without factor and offset
};

ut_status visit_basic(const ut_unit* unit, void* parts) {
    const char* const symbol = ut_get_symbol(unit, UT_ASCII);
    *static_cast<Parts*>(parts) = {symbol ? symbol : "?", unit};
    return UT_SUCCESS;
}

ut_status visit_product(const ut_unit* unit, int count, const ut_unit* const* basic,
                        const int* powers, void* parts) {
    std::map<std::string, int> sorted;
    for (int i = 0; i < count; ++i)
        sorted[ut_get_symbol(basic[i], UT_ASCII)] = powers[i];
    std::vector<std::string> factors;
    for (const auto& [symbol, power] : sorted)
        factors.push_back(power == 1 ? symbol : fmt::format("{}^{}", symbol, power));
    *static_cast<Parts*>(parts) = {fmt::format("{}", fmt::join(factors, " ")), unit};
    return UT_SUCCESS;
}

ut_status visit_scaled(const ut_unit*, double, const ut_unit* underlying, double, void* parts);

ut_status refuse_timestamp(const ut_unit*, const ut_unit*, double, void*) {
    return UT_MEANINGLESS;
}

ut_status refuse_logarithm(const ut_unit*, double, const ut_unit*, void*) {
    return UT_MEANINGLESS;
}

ut_visitor parts_visitor() {
    return {visit_basic, visit_product, visit_scaled, refuse_timestamp, refuse_logarithm};
}

ut_status visit_scaled(const ut_unit*, double, const ut_unit* underlying, double, void* parts) {
    const ut_visitor visitor = parts_visitor();
    return ut_accept_visitor(underlying, &visitor, parts);
}

/// Words for masses, in small letters, with those for their weights; people write the former for
/// the latter. Torques are also written without a sign between force and length.
const std::map<std::string, std::string, std::less<>> weights = {
    {"g", "gf"},         {"kg", "kgf"},       {"lb", "lbf"},      {"lbs", "lbf"},
    {"pound", "lbf"},    {"pounds", "lbf"},   {"oz", "ozf"},      {"ounce", "ozf"},
    {"ounces", "ozf"},   {"gcm", "gf cm"},    {"kgcm", "kgf cm"}, {"kgm", "kgf m"},
    {"inlb", "in lbf"},  {"inlbs", "in lbf"}, {"lbin", "lbf in"}, {"ftlb", "ft lbf"},
    {"ftlbs", "ft lbf"}, {"lbft", "lbf ft"},  {"ozin", "ozf in"}, {"inoz", "in ozf"}};

/// Spelling with weights in place of masses; empty if it has no word for a mass.
std::string with_weights(std::string_view spelling) {
    std::string result;
    bool any = false;
    for (std::size_t i = 0; i < spelling.size();) {
        std::size_t end = i;
        while (end < spelling.size() && is_letter(spelling[end]))
            ++end;
        std::string word(spelling.substr(i, std::max<std::size_t>(end - i, 1)));
        i += word.size();
        std::string small = word;
        for (char& c : small)
            c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
        const auto found = weights.find(small);
        any |= found != weights.end();
        result += found == weights.end() ? word : found->second;
    }
    return any ? result : "";
}

std::invalid_argument not_a_unit(std::string_view spelling) {
    return std::invalid_argument(fmt::format(
        "'{}' is not a unit; write one like 'Pa', 'mN m', 'rad/s', '1/s' or 'kg/m^3'", spelling));
}

/// Whether a text is a number other than 1, which UDUNITS would accept as a unit.
bool bare_factor(const std::string& text) {
    return parse_number(text).has_value() && text != "1";
}

}  // namespace

Unit::Unit(std::string_view spelling) : spelling_(trimmed(spelling)) {
    const std::string text = normalised(spelling);
    if (!bare_factor(text) && read(text)) return;
    const std::string meant = weight_meant(spelling_);
    if (meant.empty() || meant == spelling_) throw not_a_unit(spelling_);
    throw std::invalid_argument(
        fmt::format("'{}' is not a unit; did you mean '{}'?", spelling_, meant));
}

bool Unit::read(const std::string& text) {
    const std::lock_guard lock(udunits_mutex());
    const std::unique_ptr<ut_unit, decltype(&ut_free)> unit(
        ut_parse(unit_system(), text.c_str(), UT_UTF8), ut_free);
    if (!unit) return false;
    Parts parts;
    const ut_visitor visitor = parts_visitor();
    if (ut_accept_visitor(unit.get(), &visitor, &parts) != UT_SUCCESS) return false;
    const std::unique_ptr<cv_converter, decltype(&cv_free)> converter(
        ut_get_converter(const_cast<ut_unit*>(unit.get()), const_cast<ut_unit*>(parts.base)),
        cv_free);
    dimension_ = parts.dimension;
    offset_ = cv_convert_double(converter.get(), 0);
    factor_ = cv_convert_double(converter.get(), 1) - offset_;
    return std::abs(factor_) >= smallest_factor && std::abs(factor_) <= 1 / smallest_factor &&
           std::isfinite(offset_);
}

namespace {

bool is_si(const Unit& unit) {
    return unit.to_si(1) == 1 && unit.to_si(0) == 0;
}

/// SI unit that results where SI prefixes in the spelling of `unit`, from byte `from` on, are left
/// out: "N m s/rad" for "mN m s/rad"; empty where there is none.
std::string without_prefixes(const std::string& spelling, const Unit& unit, std::size_t from = 0) {
    try {
        const Unit tried(spelling);
        if (tried.same_dimension(unit) && is_si(tried)) return spelling;
    } catch (const std::invalid_argument&) {  // a word without its first letter may be no unit
    }
    for (std::size_t at = from; at < spelling.size(); ++at) {
        const bool begins_word = at == 0 || std::string_view(" */.^-()").find(spelling[at - 1]) !=
                                                std::string_view::npos;
        for (const std::string_view prefix : {"m", "u", "\u00b5", "\u03bc", "n", "k", "M", "G"}) {
            if (!begins_word || spelling.compare(at, prefix.size(), prefix) != 0) continue;
            const std::string shorter =
                spelling.substr(0, at) + spelling.substr(at + prefix.size());
            if (auto found = without_prefixes(shorter, unit, at + 1); !found.empty()) return found;
        }
    }
    return "";
}

}  // namespace

std::string si_spelling(const Unit& unit) {
    if (unit.dimension().empty()) return "1";
    for (const char* const spelling : {"N m", "N", "Pa", "Pa s", "N/m", "m", "m^2", "m^3", "m/s",
                                       "rad", "rad/s", "s", "1/s", "kg", "kg/m^3", "K"})
        if (unit.same_dimension(Unit(spelling))) return spelling;
    const std::string own = without_prefixes(unit.spelling(), unit);
    return own.empty() ? unit.dimension() : own;
}

std::string wrong_dimension(const Unit& unit, const Unit& expected) {
    const auto shown = [](const Unit& u) { return u.dimension().empty() ? "1" : u.dimension(); };
    std::string message = fmt::format("'{}' measures {}, not {} as '{}' does", unit.spelling(),
                                      shown(unit), shown(expected), expected.spelling());
    const std::string meant = weight_meant(unit.spelling());
    if (!meant.empty() && Unit(meant).same_dimension(expected))
        message += fmt::format("; did you mean '{}'?", meant);
    return message;
}

std::string weight_meant(std::string_view spelling) {
    std::string weight = with_weights(spelling);
    if (weight.empty()) return "";
    try {
        const Unit unit(weight);
        return weight;
    } catch (const std::invalid_argument&) {
        return "";
    }
}

namespace {

/// Texts of a number and of the unit after it, without blanks around them.
struct NumberAndUnit {
    std::string_view number, unit;
};

/// Unit behind a number without the sign of a product before its power of ten: "10^3 Pa" for
/// "·10^3 Pa".
std::string_view without_product(std::string_view unit) {
    const auto behind = [&](std::string_view sign) -> std::string_view {
        const std::size_t next = after_blanks(unit, sign.size());
        const bool factor = unit.starts_with(sign) && next < unit.size() && is_digit(unit[next]);
        return factor ? unit.substr(next) : unit;
    };
    for (const std::string_view sign : product_points)
        if (unit.starts_with(sign)) return behind(sign);
    for (const std::string_view sign : product_crosses)
        if (unit.starts_with(sign)) return behind(sign);
    return !unit.empty() && is_product_letter(unit, 0) ? behind(unit.substr(0, 1)) : unit;
}

NumberAndUnit split_quantity(std::string_view text) {
    const std::string_view whole = trimmed(text);
    const std::size_t end = std::min(whole.find_first_not_of("+-.,0123456789eE"), whole.size());
    std::string_view number = whole.substr(0, end);
    if (number.ends_with('e') || number.ends_with('E')) number.remove_suffix(1);
    const std::string_view rest = whole.substr(number.size());
    // "10^3 Pa" and "10⁻³ m" have no other number than the factor of their unit.
    if (number == "10" && with_plain_exponents(rest).starts_with('^')) return {"1", whole};
    return {number, without_product(trimmed(rest))};
}

}  // namespace

std::string missing_unit(std::string_view number, const Unit& expected) {
    const std::string& unit = expected.spelling();
    if (unit == "rad")  // people measure angles in degrees
        return fmt::format("has no unit; write \"{0} deg\" or \"{0} rad\"", number);
    const bool scaled = unit == "m" || unit == "N m" || unit == "Pa";
    const char* const prefix = unit == "Pa" ? "k" : "m";
    return fmt::format("has no unit; write \"{} {}\"{} or another unit of the same kind", number,
                       unit, scaled ? fmt::format(", \"{} {}{}\"", number, prefix, unit) : "");
}

double quantity_in_si(std::string_view text, const Unit& expected) {
    const auto [number, unit_text] = split_quantity(text);
    const auto value = parse_number(number);
    if (!value) {
        const char* const hint = has_decimal_comma(number) ? "; the decimal sign is '.'" : "";
        throw std::invalid_argument(
            fmt::format("\"{}\" is not a number with a unit, like \"500 um\"{}", text, hint));
    }
    const Unit unit(unit_text);
    if (unit_text.empty() && !unit.same_dimension(expected))
        throw std::invalid_argument(fmt::format("\"{}\" {}", text, missing_unit(number, expected)));
    if (!unit.same_dimension(expected))
        throw std::invalid_argument(
            fmt::format("\"{}\": {}", text, wrong_dimension(unit, expected)));
    return unit.to_si(*value);
}

std::vector<double> quantities_in_si(std::string_view list, const Unit& expected) {
    std::vector<double> values;
    std::string unit;
    // Backwards, since a unit also applies to the numbers before it.
    for (bool more = true; more;) {
        const std::size_t comma = list.rfind(',');
        more = comma != std::string_view::npos;
        const std::string item(trimmed(more ? list.substr(comma + 1) : list));
        const std::string_view own = split_quantity(item).unit;
        if (!own.empty()) unit = own;
        values.push_back(quantity_in_si(
            own.empty() && !unit.empty() ? fmt::format("{} {}", item, unit) : item, expected));
        list = more ? list.substr(0, comma) : list;
    }
    std::ranges::reverse(values);
    return values;
}

namespace {

constexpr double turn = 2 * std::numbers::pi, degree = std::numbers::pi / 180;

/// Mix-ups of speeds; the last two are those of rates, which have no angle.
constexpr UnitMixUp speeds[] = {
    {"rpm", "rad/s", turn / 60}, {"turn/s (Hz)", "rad/s", turn},     {"deg/s", "rad/s", degree},
    {"rad/s", "rpm", 60 / turn}, {"rad/s", "turn/s (Hz)", 1 / turn}, {"rad/s", "deg/s", 1 / degree},
    {"1/s", "1/min", 60},        {"1/min", "1/s", 1.0 / 60}};

/// Mix-ups of torques; all but the last are those of forces.
constexpr UnitMixUp torques[] = {{"kilogram-force", "newton", gravity},
                                 {"gram-force", "newton", gravity / 1000},
                                 {"newton", "kilogram-force", 1 / gravity},
                                 {"gf cm", "mN m", gravity / 100}};

}  // namespace

std::string UnitMixUp::meaning() const {
    return fmt::format("numbers in {} were read as {}", unit, taken_for);
}

std::span<const UnitMixUp> unit_mix_ups(std::string_view quantity) {
    if (quantity == "angular_velocity") return speeds;
    if (quantity == "shear_rate") return std::span(speeds).last(2);
    if (quantity == "torque") return torques;
    if (quantity == "normal_force") return std::span(torques).first(3);
    return {};
}

const UnitMixUp* find_mix_up(std::string_view quantity, double factor, double tolerance) {
    const auto all = unit_mix_ups(quantity);
    const auto found = std::ranges::find_if(
        all, [&](const UnitMixUp& each) { return std::abs(factor / each.factor - 1) < tolerance; });
    return found == all.end() ? nullptr : &*found;
}

std::optional<int> power_of_ten(double factor, double tolerance) {
    const double size = std::abs(factor);
    if (!(size > 0) || std::isinf(size)) return std::nullopt;
    const double power = std::round(std::log10(size));
    if (std::abs(size / std::pow(10, power) - 1) > tolerance) return std::nullopt;
    return static_cast<int>(power);
}

}  // namespace pendular
