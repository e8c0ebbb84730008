#pragma once

#include <memory>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

namespace pendular {

/// Error of a formula that cannot be read. The message names the mistake, its place in the text and
/// a remedy.
class FormulaError : public std::runtime_error {
    using runtime_error::runtime_error;
};

/// A formula of variables, such as "torque + drag*angular_velocity", compiled once: + - * / ^, ( ),
/// comparisons, && ||, CONDITION ? A : B, the constant pi and functions such as sin, exp, ln, sqrt,
/// abs and min. Copies share the compiled formula.
class CompiledFormula {
  public:
    /// Compiles `text`, a formula that may contain the variables named in `variables`.
    /// @throws FormulaError for a syntax error, an assignment, or a variable that is not among
    ///         `variables`, naming the nearest one
    CompiledFormula(const std::string& text, const std::vector<std::string>& variables);

    /// Returns the value of the formula, which may be infinite or NaN. `values`: values of the
    /// variables, in the order of the constructor's list. Safe to call from several threads.
    double operator()(std::span<const double> values) const;

    /// Names of the constructor's variables that occur in the formula, sorted alphabetically.
    const std::vector<std::string>& used() const;
    /// Whether the variable with this name occurs in the formula.
    bool uses(const std::string& variable) const;

    /// Names of the functions and constants that formulas can contain, such as "sin" and "pi"; a
    /// variable must not have one of these names.
    static std::vector<std::string> reserved_words();

  private:
    struct Compiled;
    std::shared_ptr<Compiled> compiled_;
};

}  // namespace pendular
