#include "data/recordings/stated_cell.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <stdexcept>

#include "data/files/header_cell.h"
#include "data/quantities/number.h"
#include "data/quantities/units.h"

namespace pendular {
namespace {

/// Number of the cell with the names that headers give it.
struct CellFact {
    std::optional<StatedValue> StatedCell::*member;
    const char* unit;
    double factor;  ///< from the stated number to the member
    std::vector<std::string_view> names;
};

const std::vector<CellFact>& cell_facts() {
    static const std::vector<CellFact> all = {
        {&StatedCell::inner_radius,
         "m",
         1,
         {"inner radius", "inside radius", "internal radius", "cup inner radius", "ri",
          "rayon interieur", "rayon intérieur", "rayon interne", "innenradius", "innerer radius"}},
        {&StatedCell::outer_radius,
         "m",
         1,
         {"outer radius", "outside radius", "external radius", "cup outer radius", "re", "ro",
          "rayon exterieur", "rayon extérieur", "rayon externe", "außenradius", "aussenradius",
          "äußerer radius", "Äußerer radius"}},
        {&StatedCell::inner_radius,
         "m",
         0.5,
         {"inner diameter", "inside diameter", "internal diameter", "di", "diametre interieur",
          "diamètre intérieur", "diamètre interne", "innendurchmesser"}},
        {&StatedCell::outer_radius,
         "m",
         0.5,
         {"outer diameter", "outside diameter", "external diameter", "de", "do",
          "diametre exterieur", "diamètre extérieur", "diamètre externe", "außendurchmesser",
          "aussendurchmesser"}},
        {&StatedCell::stress_per_torque, "Pa/(N m)", 1, {"stress constant"}},
        {&StatedCell::stress_per_force, "Pa/N", 1, {"normal stress constant"}}};
    return all;
}

std::string lower(std::string_view text) {
    std::string result(text);
    for (char& c : result)
        c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    return result;
}

/// Value of a fact in SI units; empty if it is no positive number with a unit.
std::optional<double> value_of(std::string text, const std::string& unit_of_key, const char* unit,
                               const NumberStyle& style) {
    // TRIOS writes a stress per torque as "Pa/N.m", which reads as (Pa/N) m elsewhere.
    if (const std::size_t at = text.find("Pa/N.m"); at != std::string::npos)
        text.replace(at, 6, "Pa/(N m)");
    // The number comes first, whether a unit follows or not.
    const std::size_t end = std::min(text.find(' '), text.size());
    text = rewritten(text.substr(0, end), style) + text.substr(end);
    if (parse_number(text) && !unit_of_key.empty()) text += " " + unit_of_key;
    try {
        const double value = quantity_in_si(text, Unit(unit));
        return value > 0 && std::isfinite(value) ? std::optional(value) : std::nullopt;
    } catch (const std::invalid_argument&) {
        return std::nullopt;
    }
}

/// Constants of a cell with their names.
struct Constant {
    std::optional<StatedValue> StatedCell::*member;
    const char *name, *unit;
    double value;  ///< in `unit`; 0: unknown
    double scale;  ///< of the unit in SI units
};

/// Returns a fault for each constant in a header that differs from a known one by more than
/// `tolerance`.
std::vector<Remark> compare(const BlockFile& file, const StatedCell& stated,
                            const std::vector<Constant>& constants, double tolerance,
                            Remark::Kind kind) {
    std::vector<Remark> faults;
    for (const auto& [member, name, unit, value, scale] : constants) {
        const std::optional<StatedValue>& own = stated.*member;
        if (!own || value == 0) continue;
        const double ratio = own->value / std::abs(value);
        if (std::abs(ratio - 1) <= tolerance) continue;
        faults.push_back({.kind = kind,
                          .files = {file.file},
                          .lines = {{own->line, own->line}},
                          .size = own->value / scale,
                          .limit = std::abs(value) / scale,
                          .relative = ratio - 1,
                          .names = {own->key, own->text, name, unit}});
    }
    return faults;
}

}  // namespace

StatedCell stated_cell(const BlockFile& file) {
    StatedCell cell;
    for (const Fact& fact : file.facts) {
        const HeaderCell key = parse_header_cell(fact.key);
        const std::string name = lower(key.name);
        for (const CellFact& each : cell_facts()) {
            if (cell.*each.member || std::ranges::find(each.names, name) == each.names.end())
                continue;
            if (const auto value = value_of(fact.value, key.unit, each.unit, file.numbers))
                cell.*each.member = {each.factor * *value, fact.line, fact.key, fact.value};
        }
    }
    return cell;
}

std::vector<Remark> header_against_columns(const BlockFile& file, double stress_per_torque,
                                           double stress_per_force) {
    StatedCell all = stated_cell(file);
    if (all.inner_radius && all.outer_radius && all.inner_radius->value < all.outer_radius->value) {
        const AnnularCell annulus{.inner_radius = all.inner_radius->value,
                                  .outer_radius = all.outer_radius->value};
        const int line = all.outer_radius->line;
        const std::string text =
            fmt::format("{} and {}", all.inner_radius->text, all.outer_radius->text);
        if (!all.stress_per_torque)
            all.stress_per_torque = {shear_stress(1, annulus), line, "the radii", text};
        if (!all.stress_per_force)
            all.stress_per_force = {normal_stress(1, annulus), line, "the radii", text};
    }
    // Ratios of columns are known to 5 % (`cell_from_columns`).
    return compare(
        file, all,
        {{&StatedCell::stress_per_torque, "shear stress per torque", "Pa/(N m)", stress_per_torque,
          1},
         {&StatedCell::stress_per_force, "normal stress per force", "Pa/N", stress_per_force, 1}},
        0.05, Remark::Kind::header_constant);
}

std::vector<Remark> header_against_study(const BlockFile& file, const AnnularCell& cell) {
    return compare(file, stated_cell(file),
                   {{&StatedCell::inner_radius, "inner radius", "mm", cell.inner_radius, 1e-3},
                    {&StatedCell::outer_radius, "outer radius", "mm", cell.outer_radius, 1e-3},
                    {&StatedCell::stress_per_torque, "shear stress per torque", "Pa/(N m)",
                     shear_stress(1, cell), 1},
                    {&StatedCell::stress_per_force, "normal stress per force", "Pa/N",
                     normal_stress(1, cell), 1}},
                   0.01, Remark::Kind::header_cell);
}

}  // namespace pendular
