#include "sim/catalogue/formula.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <muParser.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <iterator>
#include <mutex>
#include <numbers>
#include <optional>
#include <sstream>

#include "data/files/text_pattern.h"
#include "data/input_error.h"
#include "data/quantities/units.h"

namespace pendular {
namespace {

bool begins_a_name(const std::string& token) {
    return !token.empty() &&
           (std::isalpha(static_cast<unsigned char>(token.front())) || token.front() == '_');
}

/// Returns the place of a byte as text, as in "at character 10", counted from 1.
std::string place(const std::string& text, std::size_t byte) {
    const auto before = text.substr(0, byte);
    const auto characters = std::ranges::count_if(
        before, [](char c) { return (static_cast<unsigned char>(c) & 0xC0) != 0x80; });
    return fmt::format("at character {}", characters + 1);
}

/// Returns a message of muParser without its positions, which count from 0.
std::string without_places(const std::string& message) {
    static const TextPattern said("( found)? at( expression)? position [0-9]+|[.]$");
    std::string rest;
    std::size_t from = 0;
    for (const PatternMatch& each : said.all(message)) {
        rest.append(message, from, each.begin - from);
        from = each.end;
    }
    return rest.append(message, from);
}

/// Returns an error message for the user from an error of muParser, whose own message names only
/// tokens.
std::string explained(const mu::ParserError& error, const std::string& text,
                      const std::vector<std::string>& variables) {
    if (error.GetCode() == mu::ecEMPTY_EXPRESSION) {
        return "the formula is empty";
    }
    const std::string& token = error.GetToken();
    const std::string where =
        error.GetPos() < 0
            ? ""
            : fmt::format(" {}", place(text, static_cast<std::size_t>(error.GetPos())));
    if (error.GetCode() == mu::ecUNASSIGNABLE_TOKEN && begins_a_name(token)) {
        const auto meant = nearest(token, variables);
        return fmt::format("unknown variable '{}'{}{}; known are {}", token, where,
                           meant ? fmt::format("; did you mean '{}'?", *meant) : "",
                           fmt::join(variables, ", "));
    }
    return fmt::format("{}{}; correct the formula", without_places(error.GetMsg()), where);
}

/// Returns the position of an assignment in a formula, which would change a variable: a '=' that is
/// not part of == <= >= !=.
std::optional<std::size_t> assignment_in(const std::string& text) {
    for (std::size_t k = 0; k < text.size(); ++k) {
        if (text[k] != '=') continue;
        if (k > 0 && std::string_view("<>!=").find(text[k - 1]) != std::string_view::npos) continue;
        if (k + 1 < text.size() && text[k + 1] == '=') continue;
        return k;
    }
    return std::nullopt;
}

/// Refuses mistakes in a formula that muParser would accept.
/// @throws FormulaError for an assignment or a zero byte
void refuse_traps(const std::string& text) {
    if (const auto at = text.find('\0'); at != std::string::npos)
        throw FormulaError(fmt::format("a zero byte {}; remove it", place(text, at)));
    if (const auto at = assignment_in(text))
        throw FormulaError(
            fmt::format("'=' {}: a formula gives the value alone; leave out the "
                        "left side, or write == to compare",
                        place(text, *at)));
}

}  // namespace

/// A parser with the variables that it reads. muParser evaluates on a stack of the parser and reads
/// variables through pointers, so that only one thread at a time can use a parser. One parser per
/// thread would require compiling again, and an evaluation takes less than a microsecond.
struct CompiledFormula::Compiled {
    mu::Parser parser;
    std::vector<double> variables;
    std::vector<std::string> used;
    std::mutex mutex;
};

CompiledFormula::CompiledFormula(const std::string& text, const std::vector<std::string>& variables)
    : compiled_(std::make_shared<Compiled>()) {
    mu::Parser& parser = compiled_->parser;
    compiled_->variables.assign(variables.size(), 1.0);
    refuse_traps(text);
    try {
        parser.DefineConst("pi", std::numbers::pi);
        for (std::size_t k = 0; k < variables.size(); ++k)
            parser.DefineVar(variables[k], &compiled_->variables[k]);
        parser.SetExpr(text);
        parser.Eval();
        if (parser.GetNumResults() != 1)
            throw FormulaError(
                "a ',' outside of a function: the decimal sign is '.', and a "
                "formula gives one value");
        std::ranges::transform(parser.GetUsedVar(), std::back_inserter(compiled_->used),
                               [](const auto& variable) { return variable.first; });
    } catch (const mu::ParserError& error) {
        throw FormulaError(explained(error, text, variables));
    }
}

double CompiledFormula::operator()(std::span<const double> values) const {
    const std::lock_guard lock(compiled_->mutex);
    std::ranges::copy(values, compiled_->variables.begin());
    return compiled_->parser.Eval();
}

const std::vector<std::string>& CompiledFormula::used() const {
    return compiled_->used;
}

bool CompiledFormula::uses(const std::string& variable) const {
    return std::ranges::find(used(), variable) != used().end();
}

std::vector<std::string> CompiledFormula::reserved_words() {
    std::vector<std::string> words = {"pi", "_pi", "_e"};
    const mu::Parser parser;
    std::ranges::transform(parser.GetFunDef(), std::back_inserter(words),
                           [](const auto& function) { return function.first; });
    return words;
}

namespace {

constexpr std::array base_units = {"kg", "m", "s"};

/// Exponent of a base unit in a dimension such as "kg m^2 s^-2".
int exponent_of(const std::string& base, const std::string& dimension) {
    std::istringstream words(dimension);
    for (std::string word; words >> word;) {
        const std::size_t hat = word.find('^');
        if (word.substr(0, hat) == base) {
            return hat == std::string::npos ? 1 : std::stoi(word.substr(hat + 1));
        }
    }
    return 0;
}

/// Whether a formula may contain numbers that have a dimension: limits in comparisons, and numbers
/// other than 0, 1 and powers.
bool may_have_units_in_it(const std::string& text) {
    if (text.find_first_of("<>?") != std::string::npos) return true;
    static const TextPattern number(
        R"((^|\^[-(]*|[^A-Za-z_0-9.])(\d+\.?\d*([eE][-+]?\d+)?|\.\d+))");
    for (const PatternMatch& at : number.all(text)) {
        const double value = std::stod(at.parts[2]);
        const bool is_power = at.parts[1].starts_with('^');
        if (value != 0 && value != 1 && !is_power) return true;
    }
    return false;
}

/// Whether the value of a formula is multiplied by scale^(exponent of the target) where each
/// variable is multiplied by scale^(its exponent).
bool scales(const CompiledFormula& formula, const std::vector<double>& values,
            const std::vector<int>& exponents, int target) {
    // Any scale but 1 tells exponents apart.
    constexpr double scale = 1.7, rounding = 1e-9;
    std::vector<double> scaled = values;
    for (std::size_t k = 0; k < scaled.size(); ++k) {
        scaled[k] *= std::pow(scale, exponents[k]);
    }
    const double before = formula(values) * std::pow(scale, target), after = formula(scaled);
    return !std::isfinite(before) || std::abs(after - before) <= rounding * std::abs(before);
}

/// Exponent that the last variable must have; no value where none is right.
std::optional<int> right_exponent(const CompiledFormula& formula,
                                  const std::vector<std::vector<double>>& values,
                                  std::vector<int> exponents, int target) {
    for (const int tried : {exponents.back(), 0, 1, -1, 2, -2, 3, -3, 4, -4}) {
        exponents.back() = tried;
        bool right = true;
        for (const auto& state : values) {
            right = right && scales(formula, state, exponents, target);
        }
        if (right) return tried;
    }
    return {};
}

}  // namespace

std::optional<std::string> better_unit(const CompiledFormula& formula, const std::string& text,
                                       const FormulaUnits& units,
                                       const std::vector<std::vector<double>>& values) {
    if (may_have_units_in_it(text)) return {};
    std::string wanted;
    bool right = true;
    for (const std::string base : base_units) {
        std::vector<int> exponents;
        for (const std::string& unit : units.variables) {
            exponents.push_back(exponent_of(base, Unit(unit).dimension()));
        }
        const int target = exponent_of(base, Unit(units.target).dimension());
        const auto exponent = right_exponent(formula, values, exponents, target);
        if (!exponent) return "";
        right = right && *exponent == exponents.back();
        if (*exponent == 1) wanted += base + " ";
        if (*exponent != 0 && *exponent != 1) wanted += fmt::format("{}^{} ", base, *exponent);
    }
    if (right) return {};
    return si_spelling(Unit(wanted.empty() ? "1" : wanted));
}

}  // namespace pendular
