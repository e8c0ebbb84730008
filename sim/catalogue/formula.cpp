#include "sim/catalogue/formula.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <muParser.h>

#include <algorithm>
#include <cctype>
#include <iterator>
#include <mutex>
#include <numbers>
#include <optional>
#include <regex>

#include "data/input_error.h"

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
    static const std::regex said("( found)? at( expression)? position [0-9]+|[.]$");
    return std::regex_replace(message, said, "");
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

}  // namespace pendular
