#include "data/files/header_cell.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <stdexcept>
#include <string>
#include <unordered_map>
#include <utility>

#include "data/files/column_names.h"
#include "data/files/folded_name.h"
#include "data/files/text_pattern.h"
#include "data/quantities/number.h"
#include "data/quantities/quantity.h"
#include "data/quantities/units.h"

namespace pendular {
namespace {

/// Index of the bracket that opens the pair which the last character of a text closes; npos if the
/// text does not end with such a pair.
std::size_t opening_bracket(std::string_view text) {
    if (text.empty()) return std::string_view::npos;
    // Braces and angles are rarer, and enclose other texts than units too.
    if (const char open = text.back() == '}' ? '{' : text.back() == '>' ? '<' : '\0') {
        const std::size_t at = text.rfind(open);
        const bool unit =
            at != std::string_view::npos && is_unit(text.substr(at + 1, text.size() - at - 2));
        return unit ? at : std::string_view::npos;
    }
    if (text.back() != ']' && text.back() != ')') return std::string_view::npos;
    int depth = 0;
    for (std::size_t i = text.size(); i-- > 0;) {
        if (text[i] == ']' || text[i] == ')') ++depth;
        if (text[i] == '[' || text[i] == '(') --depth;
        if (depth == 0) return i;
    }
    return std::string_view::npos;
}

struct Spelling {
    std::string_view text;  ///< in lower case
    ErrorMark mark;
};
// A spelling stands before those with which it ends.
constexpr std::array spellings = {Spelling{"standard deviation", ErrorMark::standard_deviation},
                                  Spelling{"standardabweichung", ErrorMark::standard_deviation},
                                  Spelling{"écart-type", ErrorMark::standard_deviation},
                                  Spelling{"ecart-type", ErrorMark::standard_deviation},
                                  Spelling{"desviación estándar", ErrorMark::standard_deviation},
                                  Spelling{"desviacion estandar", ErrorMark::standard_deviation},
                                  Spelling{"deviazione standard", ErrorMark::standard_deviation},
                                  Spelling{"std dev", ErrorMark::standard_deviation},
                                  Spelling{"std. dev.", ErrorMark::standard_deviation},
                                  Spelling{"st. dev.", ErrorMark::standard_deviation},
                                  Spelling{"stddev", ErrorMark::standard_deviation},
                                  Spelling{"stdev", ErrorMark::standard_deviation},
                                  Spelling{"expanded uncertainty", ErrorMark::half_width},
                                  Spelling{"erweiterte unsicherheit", ErrorMark::half_width},
                                  Spelling{"incertitude élargie", ErrorMark::half_width},
                                  Spelling{"incertezza estesa", ErrorMark::half_width},
                                  Spelling{"incertidumbre expandida", ErrorMark::half_width},
                                  Spelling{"95 % ci", ErrorMark::half_width},
                                  Spelling{"95% ci", ErrorMark::half_width},
                                  Spelling{"ci 95 %", ErrorMark::half_width},
                                  Spelling{"ci95", ErrorMark::half_width},
                                  Spelling{"standard error", ErrorMark::standard_error},
                                  Spelling{"standardfehler", ErrorMark::standard_error},
                                  Spelling{"standardunsicherheit", ErrorMark::standard_error},
                                  Spelling{"standard uncertainty", ErrorMark::standard_error},
                                  Spelling{"uncertainty", ErrorMark::standard_error},
                                  Spelling{"messunsicherheit", ErrorMark::standard_error},
                                  Spelling{"unsicherheit", ErrorMark::standard_error},
                                  Spelling{"incertitude-type", ErrorMark::standard_error},
                                  Spelling{"incertitude", ErrorMark::standard_error},
                                  Spelling{"incertidumbre", ErrorMark::standard_error},
                                  Spelling{"incertezza", ErrorMark::standard_error},
                                  Spelling{"stderr", ErrorMark::standard_error},
                                  Spelling{"error", ErrorMark::standard_error},
                                  Spelling{"err", ErrorMark::standard_error},
                                  Spelling{"fehler", ErrorMark::standard_error},
                                  Spelling{"erreur", ErrorMark::standard_error},
                                  Spelling{"errore", ErrorMark::standard_error},
                                  Spelling{"std", ErrorMark::standard_deviation},
                                  Spelling{"u95", ErrorMark::half_width},
                                  Spelling{"2σ", ErrorMark::half_width},
                                  Spelling{"2 sd", ErrorMark::half_width},
                                  Spelling{"cv", ErrorMark::standard_deviation},
                                  Spelling{"sd", ErrorMark::standard_deviation},
                                  Spelling{"se", ErrorMark::standard_error},
                                  Spelling{"±", ErrorMark::standard_error},
                                  Spelling{"+/-", ErrorMark::standard_error},
                                  Spelling{"+-", ErrorMark::standard_error}};

/// Takes a mark of errors such as "_sd" off the end of a name, with its separator.
ErrorMark take_mark(std::string_view& name) {
    const std::string lower = lower_case(name);
    // "Standard error" alone has no values named "Standard".
    if (std::ranges::find(spellings, lower, &Spelling::text) != spellings.end())
        return ErrorMark::none;
    for (const auto& [text, mark] : spellings) {
        if (!lower.ends_with(text) || lower.size() <= text.size()) continue;
        const char separator = lower[lower.size() - text.size() - 1];
        if (separator != '_' && separator != ' ') continue;
        name.remove_suffix(text.size() + 1);
        return mark;
    }
    return ErrorMark::none;
}

/// A header cell that begins with a mark of errors, taken apart.
struct Marked {
    ErrorMark mark = ErrorMark::none;
    std::string rest;  ///< without the mark, and without brackets around the name
};

/// Takes the brackets off that follow a mark at once: "(tau) [Pa]" is "tau [Pa]". Empty if there
/// are none.
std::string without_brackets(std::string_view text) {
    if (!text.starts_with('(')) return "";
    int depth = 0;
    for (std::size_t i = 0; i < text.size(); ++i) {
        depth += text[i] == '(';
        depth -= text[i] == ')';
        if (depth == 0) return fmt::format("{}{}", text.substr(1, i - 1), text.substr(i + 1));
    }
    return "";
}

/// Takes off the words between a mark and a name: "of the", "der".
std::string_view without_article(std::string_view text) {
    const std::string lower = lower_case(text);
    for (const std::string_view word :
         {"of the ", "of ", "in the ", "in ", "der ", "des ", "de la ", "de l'", "del ", "de ",
          "du ", "della ", "dello ", "di "})
        if (lower.starts_with(word)) return text.substr(word.size());
    return text;
}

/// The parts of a cell with a mark of errors at its beginning.
Marked leading_mark(std::string_view text) {
    const std::string lower = lower_case(text);
    // "u(tau)" is how the GUM writes a standard uncertainty; "u" alone may be a velocity.
    if (lower.starts_with("u("))
        return {ErrorMark::standard_error, without_brackets(text.substr(1))};
    for (const auto& [word, mark] : spellings) {
        if (!lower.starts_with(word)) continue;
        const std::string_view rest = text.substr(word.size());
        if (rest.starts_with('(')) return {mark, without_brackets(rest)};
        if (rest.starts_with(' ') || rest.starts_with('_'))
            return {mark, std::string(without_article(trimmed(rest.substr(1))))};
    }
    return {};
}

}  // namespace

bool names_factor_of_numbers(std::string_view name) {
    static const TextPattern before(
        R"(^\s*\d[\d.,]*(?:[eE^][-+]?\d+)?\s*(?:×|x|X|\*|·|⋅|∙|•)\s*[^\d\s])");
    static const TextPattern behind(R"((?:×|\*|·|⋅|/|÷|\sx|\sX)\s*\d[\d.,]*\s*$)");
    constexpr std::size_t longest = 200;  // bytes; longer texts are no names
    return name.size() <= longest && (before.first(name) || behind.first(name));
}

bool is_unit(std::string_view text) {
    if (text.empty()) return false;
    try {
        const Unit unit(text);
        return true;
    } catch (const std::invalid_argument&) {
        return false;
    }
}

namespace {

/// Whether a name, with or without a mark of errors, is that of a quantity in this unit; any unit
/// fits if it is empty.
bool is_quantity(std::string_view name, std::string_view unit = "") {
    take_mark(name);
    return !meaning_of_column(trimmed(name), unit).quantity.empty();
}

/// Parts of a header cell before and after a separator; both are empty if it has none.
struct Halves {
    std::string_view name, unit;
};

Halves divided(std::string_view text, std::string_view separator, std::size_t at) {
    if (at == std::string_view::npos) return {};
    return {trimmed(text.substr(0, at)), trimmed(text.substr(at + separator.size()))};
}

/// Name and unit of a header cell without brackets: "Torque in mNm", "Torque / mNm" (ISO 80000),
/// "Torque/mNm", "Couple, mNm". Only " in " and " / " are taken for certain. Other separators occur
/// in names ("phi_L/phi_S", "Time, sequence"), so that they count only where the unit is one of the
/// named quantity.
Halves name_and_unit(std::string_view text) {
    if (const std::size_t in = text.rfind(" in "); in != std::string_view::npos)
        return divided(text, " in ", in);
    if (find_quantity(text)) return {text, ""};
    const Halves apart = divided(text, " / ", text.find(" / "));
    if (!apart.unit.empty() &&
        (is_quantity(apart.name, apart.unit) ||
         (!find_quantity(apart.unit) && (is_quantity(apart.name) || is_unit(apart.unit)))))
        return apart;
    for (const std::string_view separator : {"/", ", ", ": ", " en "}) {
        const bool first = separator == "/";  // "Angular velocity/rad/s"
        const Halves parts =
            divided(text, separator, first ? text.find(separator) : text.rfind(separator));
        if (parts.unit.empty() || !is_quantity(parts.name)) continue;
        // "Torque, in-lb" has a unit, though a wrong one.
        if (is_quantity(parts.name, parts.unit) || !weight_meant(parts.unit).empty()) return parts;
    }
    return {text, ""};
}

/// Takes a unit off the end of a name that programs write without brackets: "torque_mNm",
/// "Gap mm", "omega_rad_s", "speed_rad_per_s". It counts only where it is one of the named
/// quantity.
std::string take_unit(std::string_view& name) {
    if (find_quantity(name)) return "";
    std::string_view unmarked = name;
    if (take_mark(unmarked) != ErrorMark::none) {
        if (!name.ends_with("Std") || !is_quantity(unmarked, "Std")) return "";
        name = unmarked;
        return "Std";  // German for hours; that of a torque is its standard deviation
    }
    for (std::size_t at = name.find_first_of("_ ", 1); at != std::string_view::npos;
         at = name.find_first_of("_ ", at + 1)) {
        const std::string_view begin = trimmed(name.substr(0, at)), end = name.substr(at + 1);
        if (end.empty() || !is_quantity(begin)) continue;
        for (const std::string_view between : {"_per_", "_"}) {
            for (const char* const written : {" ", "/"}) {
                std::string unit(trimmed(end));
                for (std::size_t found = unit.find(between); found != std::string::npos;
                     found = unit.find(between))
                    unit.replace(found, between.size(), written);
                if (!is_unit(unit) || !is_quantity(begin, unit)) continue;
                name = begin;
                return unit;
            }
        }
    }
    return "";
}

}  // namespace

namespace {

/// Text with the brackets of East Asian typesetting as those of other texts.
std::string with_plain_brackets(std::string_view text) {
    std::string plain(text);
    for (const auto& [wide, narrow] : {std::pair("（", "("), std::pair("）", ")")})
        for (std::size_t at = plain.find(wide); at != std::string::npos; at = plain.find(wide, at))
            plain.replace(at, std::string_view(wide).size(), narrow);
    return plain;
}

}  // namespace

std::string_view suffix_of(ErrorMark mark) {
    switch (mark) {
        case ErrorMark::standard_deviation:
            return "_sd";
        case ErrorMark::standard_error:
            return "_se";
        case ErrorMark::half_width:
            return "_u95";
        case ErrorMark::none:
            break;
    }
    return "";
}

ErrorMark bare_mark(const HeaderCell& cell) {
    const std::string lower = lower_case(cell.name);
    const auto found = std::ranges::find(spellings, lower, &Spelling::text);
    if (cell.mark != ErrorMark::none || found == spellings.end()) return ErrorMark::none;
    constexpr std::array faults = {"error", "fehler", "erreur", "errore"};
    const bool code_of_fault =
        cell.unit.empty() && std::ranges::find(faults, lower) != faults.end();
    const bool ratio = lower == "cv" && cell.unit != "%";
    return code_of_fault || ratio ? ErrorMark::none : found->mark;
}

namespace {

/// Parts of a cell that is not known yet.
HeaderCell taken_apart(std::string_view written) {
    const std::string plain = with_plain_brackets(trimmed(written));
    std::string_view text = plain;
    if (text.ends_with("]:") || text.ends_with("):")) text.remove_suffix(1);
    if (const Marked marked = leading_mark(text); !marked.rest.empty()) {
        HeaderCell rest = parse_header_cell(marked.rest);
        const bool relative = rest.unit == "%" && is_quantity(rest.name);
        if (!rest.deviation() && (relative || is_quantity(rest.name, rest.unit))) {
            rest.mark = marked.mark;
            return rest;
        }
    }
    HeaderCell cell;
    std::string_view name = text;
    if (const std::size_t bracket = opening_bracket(text); bracket != std::string_view::npos) {
        name = text.substr(0, bracket);
        cell.unit = trimmed(text.substr(bracket + 1, text.size() - bracket - 2));
        name = trimmed(name);  // ISO 80000: "ρ/(kg/m³)"
        if (name.ends_with('/') && name.size() > 1) name.remove_suffix(1);
    } else {
        const Halves parts = name_and_unit(text);
        name = parts.name;
        cell.unit = parts.unit;
        if (cell.unit.empty()) cell.unit = take_unit(name);
    }
    name = trimmed(name);
    cell.mark = take_mark(name);
    cell.name = trimmed(name);
    return cell;
}

}  // namespace

HeaderCell parse_header_cell(std::string_view written) {
    // One layout after the other asks for the names in a file, of which each takes microseconds.
    // Longer ones are rare, and what fills 100 kB is no name.
    constexpr std::size_t most_known = 1000, longest = 200, longest_name = 100'000;
    if (written.size() > longest_name) return {std::string(written), ""};
    if (written.size() > longest) return taken_apart(written);
    thread_local std::unordered_map<std::string, HeaderCell> known;
    const std::string text(written);
    if (const auto found = known.find(text); found != known.end()) return found->second;
    if (known.size() == most_known) known.clear();
    return known.try_emplace(text, taken_apart(text)).first->second;
}

}  // namespace pendular
