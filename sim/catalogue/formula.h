#pragma once

#include <memory>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

namespace pendular {

/// Error of a formula that cannot be read: the mistake, its place, the remedy.
class FormulaError : public std::runtime_error {
    using runtime_error::runtime_error;
};

/// A formula of variables, such as "torque + drag*angular_velocity", compiled once: + - * / ^, ( ),
/// comparisons, && ||, CONDITION ? A : B, the functions sin, exp, ln, sqrt, abs, min, ..., and pi.
/// Copies share what is compiled.
class CompiledFormula {
  public:
    /// @throws FormulaError for what is no formula of these variables, with the nearest known name
    CompiledFormula(const std::string& text, const std::vector<std::string>& variables);

    /// Value where the variables have these values, in their order; may be infinite or no number.
    /// Any number of threads may call it.
    double operator()(std::span<const double> values) const;

    /// The variables it mentions, by name.
    const std::vector<std::string>& used() const;
    bool uses(const std::string& variable) const;

    /// Words that no variable can be called: functions and constants.
    static std::vector<std::string> reserved_words();

  private:
    struct Compiled;
    std::shared_ptr<Compiled> compiled_;
};

}  // namespace pendular
