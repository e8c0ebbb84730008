#include "sim/catalogue/homogeneity.h"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <regex>
#include <sstream>

#include "data/quantities/units.h"

namespace pendular {
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
    static const std::regex number(R"((^|\^[-(]*|[^A-Za-z_0-9.])(\d+\.?\d*([eE][-+]?\d+)?|\.\d+))");
    for (std::sregex_iterator at(text.begin(), text.end(), number), end; at != end; ++at) {
        const double value = std::stod((*at)[2]);
        const bool is_power = (*at)[1].str().starts_with('^');
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
