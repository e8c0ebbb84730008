#include "data/recordings/stated_cell.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string_view>

#include "data/files/folded_name.h"

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
         {"inner radius", "inside radius", "internal radius", "cup inner radius", "inner r", "ri",
          "r in", "r int", "rayon intérieur", "rayon interne", "rayon int", "Innenradius",
          "innerer Radius", "radio interior", "radio interno", "radio int", "raggio interno",
          "raggio int", "R1"}},
        {&StatedCell::outer_radius,
         "m",
         1,
         {"outer radius",
          "outside radius",
          "external radius",
          "cup outer radius",
          "outer r",
          "re",
          "ro",
          "ra",
          "r out",
          "r ext",
          "rayon extérieur",
          "rayon externe",
          "rayon ext",
          "Außenradius",
          "Aussenradius",
          "äußerer Radius",
          "radio exterior",
          "radio externo",
          "radio ext",
          "raggio esterno",
          "raggio est",
          "R2"}},
        {&StatedCell::inner_radius,
         "m",
         0.5,
         {"inner diameter",
          "ID",
          "inside diameter",
          "internal diameter",
          "di",
          "ø int",
          "ø intérieur",
          "ø interno",
          "ø interior",
          "ø innen",
          "øi",
          "diamètre intérieur",
          "diamètre interne",
          "diamètre int",
          "diam int",
          "Innendurchmesser",
          "diámetro interior",
          "diámetro interno",
          "diámetro int",
          "diametro interno",
          "diametro int"}},
        {&StatedCell::outer_radius,
         "m",
         0.5,
         {"outer diameter",
          "OD",
          "outside diameter",
          "external diameter",
          "de",
          "do",
          "da",
          "ø ext",
          "ø extérieur",
          "ø esterno",
          "ø exterior",
          "ø est",
          "ø außen",
          "øe",
          "øo",
          "diamètre extérieur",
          "diamètre externe",
          "diamètre ext",
          "diam ext",
          "Außendurchmesser",
          "Aussendurchmesser",
          "diámetro exterior",
          "diámetro externo",
          "diámetro ext",
          "diametro esterno",
          "diametro est"}},
        {&StatedCell::stress_per_torque, "Pa/(N m)", 1, {"stress constant"}},
        {&StatedCell::stress_per_force, "Pa/N", 1, {"normal stress constant"}}};
    return all;
}

/// A folded name without the word for the cell before or behind it: "Cell inner diameter".
std::string_view without_cell(std::string_view name) {
    for (const std::string_view cell :
         {"shearcell", "ringcell", "ringshearcell", "cell", "cup", "annulus", "scherzelle",
          "ringscherzelle", "messzelle", "zelle", "cellule", "cella", "celda"})
        if (name.starts_with(cell)) return name.substr(cell.size());
    for (const std::string_view cell :
         {"ofthecell", "ofcell", "ofthecup", "oftheannulus", "derzelle", "derscherzelle",
          "delacellule", "dellacella", "delacelda"})
        if (name.ends_with(cell)) return name.substr(0, name.size() - cell.size());
    return name;
}

/// Radii from those of the smallest rheometers to those of the largest ring shear testers, and ten
/// times beyond: of the readings of "10,500 mm", 10.5 m is none.
PossibleValues possible_values(const CellFact& fact) {
    return std::string_view(fact.unit) == "m" ? PossibleValues{1e-4, 3} : PossibleValues{};
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
        if (!own || own->doubt != StatedDoubt::none || value == 0) continue;
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
    for (const StatedFact& fact : stated_facts(file)) {
        for (const CellFact& each : cell_facts()) {
            if (cell.*each.member || (!is_among_names(fact.name, each.names) &&
                                      !is_among_names(without_cell(fact.name), each.names)))
                continue;
            auto stated = positive_value(fact, each.unit, possible_values(each), file.numbers);
            if (!stated || stated->doubt == StatedDoubt::range) continue;
            stated->value *= each.factor;
            cell.*each.member = stated;
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
