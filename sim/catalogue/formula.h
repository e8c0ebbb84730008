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
    /// Compiles a formula of these variables.
    /// @throws FormulaError for a syntax error or an unknown variable, naming the nearest
    ///         known variable
    CompiledFormula(const std::string& text, const std::vector<std::string>& variables);

    /// Returns the value of the formula, which may be infinite or NaN. `values`: values of the
    /// variables, in the order of the constructor's list. Safe to call from several threads.
    double operator()(std::span<const double> values) const;

    /// Names of the variables that occur in the formula, sorted.
    const std::vector<std::string>& used() const;
    /// Whether a variable occurs in the formula.
    bool uses(const std::string& variable) const;

    /// Names of functions and constants, which no variable can have.
    static std::vector<std::string> reserved_words();

  private:
    struct Compiled;
    std::shared_ptr<Compiled> compiled_;
};

}  // namespace pendular
