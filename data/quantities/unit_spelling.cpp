#include "data/quantities/unit_spelling.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <map>
#include <stdexcept>
#include <utility>

#include "data/quantities/number.h"

namespace pendular {
namespace {

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
    {" ^ ", "^"},
    {"0,1 ", "0.1 "},  // "0,1 MPa" was once written for a bar
    // Abbreviations whose points would be products; in French, "mn" is a minute.
    {"r.p.m.", "rpm"},
    {"r.p.m", "rpm"},
    {" al minuto", "/min"},
    {" por minuto", "/min"},
    {" par minute", "/min"},
    {" pro Minute", "/min"},
    {" per minute", "/min"},
    {"/1'", "/min"},
    {"degrés", "deg"},
    {"degré", "deg"},
    {"Umdr.", "turn"},
    {"Sek.", "s"},
    {"Std.", "h"},
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
    {"mm WS", "(9.80665 Pa)"},
    {"mmWS", "(9.80665 Pa)"},
    {"mm H2O", "(9.80665 Pa)"},
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
    {"deg", "arc_degree"},
    {"rev", "turn"},
    {"revs", "turn"},
    {"tr", "turn"},
    {"r", "turn"},
    {"Upm", "turn/min"},
    {"tour", "turn"},
    {"tours", "turn"},
    {"giri", "turn"},
    {"Umdr", "turn"},
    {"RPM", "rpm"},
    {"rps", "turn/s"},
    {"U", "turn"},
    {"gf", "gram_force"},
    {"dyn", "dyne"},
    {"cP", "cpoise"},
    {"mcm", "um"},
    {"pct", "%"},
    {"percent", "%"},
    {"Pas", "Pa.s"},
    {"mPas", "mPa.s"},
    {"cc", "cm3"},
    {"ccm", "cm3"},
    {"radians", "radian"},
    {"kgfcm", "kgf.cm"},
    {"gfcm", "gram_force.cm"},
    {"kp", "kgf"},
    {"ozf", "(lbf/16)"},  // UDUNITS rounds the latter
    {"vuelta", "turn"},
    {"vueltas", "turn"},
    {"Std", "h"},
    {"Stunden", "h"},
    {"Sek", "s"},
    {"sek", "s"},
    {"seg", "s"},
    {"Min", "min"},
    {"psf", "(lbf/ft^2)"},
    {"giro", "turn"},
    {"lbs", "lb"},
    {"LBS", "lb"},
    {"LB", "lb"},
    {"LBF", "lbf"},
    {"IN", "in"},
    {"FT", "ft"},
    {"inlbf", "in.lbf"},
    {"lbfin", "lbf.in"},
    {"ftlbf", "ft.lbf"},
    {"lbfft", "lbf.ft"},
    {"tf", "(1000.kgf)"},
    {"Grad", "arc_degree"},
    {"gradi", "arc_degree"},
    {"grados", "arc_degree"},
    {"grado", "arc_degree"},
    {"degres", "arc_degree"},
    {"minuto", "min"},
    {"minuti", "min"},
    {"minutos", "min"},
    {"secondo", "s"},
    {"segundo", "s"}};  // not a gigaradian

/// Words for a revolution in Polish, Czech, Dutch, Swedish, Danish, Norwegian, Portuguese,
/// Romanian, Turkish, Hungarian and Finnish, of which none is another unit, and for a minute.
/// Turkish "d/dak" is left out, since d is a day.
constexpr std::array<std::string_view, 15> revolutions = {
    "obr",    "obroty", "ot",    "omw",  "varv",     "omdr",  "omdrejninger", "rot",
    "voltas", "dev",    "devir", "ford", "fordulat", "kierr", "kierrosta"};
constexpr std::array<std::string_view, 4> minutes = {"dak", "dk", "dakika", "perc"};

/// Spellings in the wrong case that UDUNITS reads as another unit, with the unit that is meant.
const std::map<std::string, std::string, std::less<>> case_traps = {
    {"pa", "Pa"},   {"kpa", "kPa"},   {"mpa", "MPa' or 'mPa"},
    {"Mpa", "MPa"}, {"MPA", "MPa"},   {"hpa", "hPa"},
    {"KPa", "kPa"}, {"Kpa", "kPa"},   {"KPA", "kPa"},
    {"PA", "Pa"},   {"gpa", "GPa"},   {"Gpa", "GPa"},
    {"kn", "kN"},   {"mn", "mN"},     {"KG", "kg"},
    {"Kg", "kg"},   {"MM", "mm"},     {"Mm", "mm"},
    {"NM", "N m"},  {"MNm", "mN m"},  {"MN", "mN' or '10^6 N"},
    {"Ms", "ms"},   {"Mrad", "mrad"}, {"Mbar", "mbar"}};

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
    const auto is_ascii = [](char c) { return static_cast<unsigned char>(c) < 0x80; };
    if (std::ranges::all_of(text, is_ascii)) {  // as most units, of which many are read
        result = text;
        text = {};
    }
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

/// Words for masses, in small letters, with those for their weights; people write the former for
/// the latter. Torques are also written without a sign between force and length.
const std::map<std::string, std::string, std::less<>> weights = {
    {"g", "gf"},         {"kg", "kgf"},       {"lb", "lbf"},      {"lbs", "lbf"},
    {"pound", "lbf"},    {"pounds", "lbf"},   {"oz", "ozf"},      {"ounce", "ozf"},
    {"ounces", "ozf"},   {"gcm", "gf cm"},    {"kgcm", "kgf cm"}, {"kgm", "kgf m"},
    {"inlb", "in lbf"},  {"inlbs", "in lbf"}, {"lbin", "lbf in"}, {"ftlb", "ft lbf"},
    {"ftlbs", "ft lbf"}, {"lbft", "lbf ft"},  {"ozin", "ozf in"}, {"inoz", "in ozf"}};

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

}  // namespace

std::string spelling_of_udunits(std::string_view spelling) {
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
        // A "t" alone is more often a time.
        const bool tonnes = word == "t" && spelling.substr(i).starts_with('/');
        any |= tonnes || found != weights.end();
        result += tonnes ? "tf" : found == weights.end() ? word : found->second;
    }
    return any ? result : "";
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

}  // namespace pendular
