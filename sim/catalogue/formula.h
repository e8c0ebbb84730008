#pragma once

#include <memory>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

namespace pendular {

/// Error of a formula that cannot be read. The message states the mistake, its position and a
/// remedy.
class FormulaError : public std::runtime_error {
    using runtime_error::runtime_error;
};

/// Formula with named variables, such as "torque + drag*angular_velocity", compiled once. It may
/// contain + - * / ^, ( ), comparisons, && ||, CONDITION ? A : B, the constant pi and functions
/// such as sin, exp, ln, sqrt, abs and min. Copies share the compiled formula.
class CompiledFormula {
  public:
    /// Compiles a formula that may contain the given variables.
    /// @throws FormulaError for a syntax error, an assignment, or an unknown variable (the message
    ///         suggests the nearest known variable)
    CompiledFormula(const std::string& text, const std::vector<std::string>& variables);

    /// Returns the value of the formula, which may be infinite or NaN. Thread-safe.
    /// @param values of the variables, in the order of the constructor's list
    double operator()(std::span<const double> values) const;

    /// Returns the variables that occur in the formula, in alphabetical order.
    const std::vector<std::string>& used() const;
    bool uses(const std::string& variable) const;

    /// Returns the names of functions and constants, such as "sin" and "pi", which no variable may
    /// have.
    static std::vector<std::string> reserved_words();

  private:
    struct Compiled;
    std::shared_ptr<Compiled> compiled_;
};

/// SI units in a formula: of the result and of each variable. The last variable is the parameter of
/// an effect, whose unit is to be checked.
struct FormulaUnits {
    std::string target;
    std::vector<std::string> variables;
};

/// Returns the SI unit of the last variable that makes a formula dimensionally homogeneous, or an
/// empty text if no unit does; empty optional if the stated unit is right or cannot be checked.
/// Angles count as dimensionless. A formula with comparisons, or with numbers other than 0, 1 and
/// exponents, cannot be checked, since such numbers may have a dimension.
/// @param values of the variables in SI units, one list for each of several typical states
std::optional<std::string> better_unit(const CompiledFormula& formula, const std::string& text,
                                       const FormulaUnits& units,
                                       const std::vector<std::vector<double>>& values);

}  // namespace pendular
