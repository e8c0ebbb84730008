#include "data/quantities/units.h"

#include <fmt/format.h>
#include <udunits2.h>

#include <algorithm>
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
#include "data/quantities/unit_spelling.h"

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
    const std::string text = spelling_of_udunits(spelling);
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

std::string missing_unit(std::string_view number, const Unit& expected) {
    const std::string& unit = expected.spelling();
    if (unit == "rad")  // people measure angles in degrees
        return fmt::format("has no unit; write \"{0} deg\" or \"{0} rad\"", number);
    const bool scaled = unit == "m" || unit == "N m" || unit == "Pa";
    const char* const prefix = unit == "Pa" ? "k" : "m";
    return fmt::format("has no unit; write \"{} {}\"{} or another unit of the same kind", number,
                       unit, scaled ? fmt::format(", \"{} {}{}\"", number, prefix, unit) : "");
}

namespace {

/// Whether a unit begins with a number other than that of "1" and "1/s" and a power of ten such as
/// "10^3".
bool begins_with_factor(std::string_view unit) {
    constexpr std::string_view digits = "0123456789";
    if (unit.empty() || digits.find(unit.front()) == std::string_view::npos) return false;
    if (unit == "1" || unit.starts_with("1/")) return false;
    const char after = unit.starts_with("10") && unit.size() > 2 ? unit[2] : ' ';
    return after != '^' && after != '*' && static_cast<unsigned char>(after) < 0x80;
}

}  // namespace

double quantity_in_si(std::string_view text, const Unit& expected) {
    const auto [number, unit_text] = split_quantity(text);
    const auto value = parse_number(number);
    // UDUNITS multiplies two numbers: "2 650 kg" would be 1300 kg.
    if (!value || begins_with_factor(unit_text)) {
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
