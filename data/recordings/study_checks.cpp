#include "data/recordings/checks.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>
#include <numeric>
#include <set>

#include "data/files/formats/sheets.h"
#include "data/files/sheet_path.h"
#include "data/grains.h"
#include "data/sheared_layer.h"
#include "data/wall_layers.h"

namespace pendular {
namespace {

using Kind = Remark::Kind;

/// Liquid content [1] from which bridges between three touching grains merge.
/// Source: Badetti et al. (2018), table philphis: V0 = 0.008 a^3; 2 % for the last printed digit.
constexpr double merging_content = 1.02 * 0.063;

/// Smallest weight of the grains to report, over the normal stress [1]. The stress at half of the
/// height, which counts for the mean flow, is then 5 % larger than the shown one.
constexpr double heavy = 0.1;

/// Least share of the height of a bed that is sheared, where the bed counts as sheared evenly [1]:
/// 0.94 and more in the cells without wall friction of bench/real_cell, 0.91 and less in those of
/// wall friction 0.15. The stress ratio at the lid then is less than 8 % above that of even shear.
constexpr double evenly_sheared = 0.92;

/// Sets the stress ratio of a bed to that of even shear at which the lid would show the ratio
/// `at_lid`. An iteration is exact for what weight adds, a factor, and closer by the share that the
/// walls add, 0.2 as a rule.
WalledBed with_ratio_at_lid(WalledBed bed, double at_lid) {
    bed.stress_ratio = at_lid;
    if (!(at_lid > 0)) return bed;
    for (int k = 0; k < 8; ++k)
        bed.stress_ratio *= at_lid / sheared_layer(bed).stress_ratio;
    return bed;
}

bool is_even(const WalledBed& bed) {
    return sheared_layer(bed).height >= evenly_sheared * bed.height;
}

bool lists(const Study& study, const char* effect) {
    return std::ranges::find(study.model.effects, effect, &ListedEffect::name) !=
           study.model.effects.end();
}

/// Bed of a dry reading between walls of a friction; empty if its height or its grains are not
/// known.
std::optional<WalledBed> walled_bed(const Reading& reading, const Study& study,
                                    double wall_friction) {
    const Condition& condition = reading.condition;
    // Of wet grains the strength is not in proportion to the normal stress.
    const bool judged = condition.dry() && !condition.at_failure;
    if (!judged || !condition.height || !condition.bead_volume) return std::nullopt;
    const AnnularCell& cell = *study.cell;
    const double diameter = study.grains.diameter;
    const double weight = *condition.bead_volume * study.grains.density * gravity / cell.area();
    const WalledBed bed{.height = *condition.height / diameter,
                        .width = (cell.outer_radius - cell.inner_radius) / diameter,
                        .wall_friction = mobilised(wall_friction),
                        .weight = weight / condition.normal_stress,
                        .inertial_number = condition.inertial_number};
    return with_ratio_at_lid(bed, reading.stress_ratio());
}

/// Wall friction up to which the beds of all readings are sheared evenly, where none is stated [1];
/// infinite if no bed is known, or if walls rougher than most leave all of them even.
double most_for_even_shear(const Study& study, const std::vector<Reading>& readings) {
    // Metal, glass and plastics against beads: 0.1 to 0.4.
    constexpr double rough = 0.5;
    if (study.cell->wall_friction || lists(study, "shear-localisation")) return INFINITY;
    const auto all_even = [&](double friction) {
        return std::ranges::all_of(readings, [&](const Reading& reading) {
            const auto bed = walled_bed(reading, study, friction);
            return !bed || is_even(*bed);
        });
    };
    if (all_even(rough)) return INFINITY;
    if (!all_even(0)) return 0;
    double even = 0, uneven = rough;
    while (uneven > 0.001 && uneven - even > 0.03 * uneven) {  // said with two digits
        const double middle = std::midpoint(even, uneven);
        (all_even(middle) ? even : uneven) = middle;
    }
    return uneven;
}

}  // namespace

std::vector<Remark> patterns_without_file(const Study& study) {
    std::vector<Remark> found;
    for (const Source& source : study.sources) {
        if (!source.files.empty()) continue;
        found.push_back({.kind = Kind::pattern_without_file, .names = {source.pattern}});
        found.back().add(source.position);
    }
    return found;
}

std::vector<Remark> unread_sheets(const Study& study) {
    std::map<std::filesystem::path, std::set<std::string>> read;
    for (const Source& source : study.sources)
        for (const std::filesystem::path& file : source.files)
            if (const auto sheet = as_sheet(file)) read[sheet->book].insert(sheet->sheet);
    std::vector<Remark> found;
    for (const auto& [book, names] : read) {
        Remark remark{.kind = Kind::unread_sheets, .files = {book.string()}};
        for (const std::string& sheet : sheets_in(book))
            if (!names.contains(sheet)) remark.names.push_back(sheet);
        if (!remark.names.empty()) found.push_back(std::move(remark));
    }
    return found;
}

std::vector<Remark> merging_bridges(const std::vector<Reading>& readings) {
    Remark found{.kind = Kind::merging_bridges, .count = 0};
    for (const Reading& reading : readings) {
        const double own = reading.condition.liquid_content, fraction = reading.value(1);
        if (!(own > merging_content)) continue;
        ++found.count;
        found.size = std::max(found.size, own);
        if (fraction > 0 && fraction < 1)
            found.relative = std::max(found.relative, own * fraction / (1 - fraction));
    }
    if (found.count == 0) return {};
    return {found};
}

std::vector<Remark> few_beads(const Study& study, const std::vector<Reading>& readings) {
    // Walls order the beads over some diameters: the model, a flow without walls, holds between
    // them. Source: GDR MiDi, Eur. Phys. J. E 14 (2004) 341: shear bands of 5 to 10 diameters.
    constexpr double enough = 10;
    if (!study.cell) return {};
    double height = INFINITY;
    for (const Reading& reading : readings)
        height = std::min(height, reading.condition.height.value_or(INFINITY));
    Remark found{.kind = Kind::few_beads};
    const auto check = [&](const char* side, double size) {
        const double beads = size / study.grains.diameter;
        if (size < enough * study.grains.diameter)
            found.because.push_back({.quantity = side, .size = size, .relative = beads});
    };
    check("width", study.cell->outer_radius - study.cell->inner_radius);
    check("height", height);
    const double width =
        (study.cell->outer_radius - study.cell->inner_radius) / study.grains.diameter;
    if (walls_are_close(width) && !readings.empty() && !lists(study, "wall-layers")) {
        found.size = width;
        found.relative = strength_lost_beside_walls(width);
        found.limit = most_for_even_shear(study, readings);
    }
    if (found.because.empty() && found.relative == 0) return {};
    return {found};
}

std::vector<Remark> creeping_gaps(const std::vector<Reading>& readings) {
    Remark found{
        .kind = Kind::creeping_gap, .quantity = "height", .count = 0, .of = readings.size()};
    for (const Reading& reading : readings) {
        if (reading.condition.gap_creep == 0) continue;
        const double creep = reading.condition.gap_creep;
        found.size = found.count == 0 ? creep : std::min(found.size, creep);
        found.size_to = found.count == 0 ? creep : std::max(found.size_to, creep);
        ++found.count;
        found.add(reading.origin);
    }
    if (found.count == 0) return {};
    return {found};
}

std::vector<Remark> uneven_shear(const Study& study, const std::vector<Reading>& readings) {
    if (!study.cell || !study.cell->wall_friction) return {};
    const bool described = lists(study, "shear-localisation");
    Remark found{.kind = Kind::uneven_shear, .count = 0, .of = 0, .limit = INFINITY};
    for (const Reading& reading : readings) {
        const auto bed = walled_bed(reading, study, *study.cell->wall_friction);
        if (!bed) continue;
        ++found.of;
        const ShearedLayer layer = sheared_layer(*bed);
        const double share = layer.height / bed->height;
        if (share >= evenly_sheared) continue;
        if (share < found.limit) {  // the reading with the thinnest layer
            WalledBed weightless = *bed, frictionless = *bed;
            weightless.weight = frictionless.wall_friction = 0;
            found.of_weight = is_even(weightless) && !is_even(frictionless);
            found.limit = share;
            found.size = layer.height * study.grains.diameter;
            found.size_to = *reading.condition.height;
            found.relative = layer.stress_ratio / bed->stress_ratio - 1;
        }
        ++found.count;
        found.add(reading.origin);
    }
    if (found.count == 0 || (described && !found.of_weight)) return {};
    return {found};
}

std::vector<Remark> points_of_failure(const std::vector<Reading>& readings) {
    const auto count = std::ranges::count_if(
        readings, [](const Reading& reading) { return reading.condition.at_failure; });
    if (count == 0) return {};
    return {{.kind = Kind::points_of_failure,
             .count = static_cast<std::size_t>(count),
             .of = readings.size()}};
}

std::vector<Remark> grain_weight(const Study& study, const std::vector<Reading>& readings) {
    if (lists(study, "grain-weight") || !study.cell) return {};
    Remark found{.kind = Kind::grain_weight, .count = 0, .of = readings.size(), .limit = INFINITY};
    for (const Reading& reading : readings) {
        const double own = reading.condition.bead_volume.value_or(0) * study.grains.density *
                           gravity / study.cell->area();
        const double stress = reading.condition.normal_stress;
        if (reading.step == 0 || own <= heavy * stress) continue;
        found.size = std::max(found.size, own);
        found.limit = std::min(found.limit, stress);
        found.size_to = std::max(found.size_to, stress);
        ++found.count;
    }
    if (found.count == 0) return {};
    return {found};
}

}  // namespace pendular
