#include "data/recordings/checks.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>
#include <set>

#include "data/files/formats/sheets.h"
#include "data/files/sheet_path.h"
#include "data/grains.h"

namespace pendular {
namespace {

using Kind = Remark::Kind;

/// Liquid content [1] from which bridges between three touching grains merge.
/// Source: Badetti et al. (2018), table philphis: V0 = 0.008 a^3; 2 % for the last printed digit.
constexpr double merging_content = 1.02 * 0.063;

/// Smallest weight of the grains to report, over the normal stress [1]. The stress at half of the
/// height, which counts for the mean flow, is then 5 % larger than the shown one.
constexpr double heavy = 0.1;

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
    if (found.because.empty()) return {};
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
    const bool listed = std::ranges::find(study.model.effects, "grain-weight",
                                          &ListedEffect::name) != study.model.effects.end();
    if (listed || !study.cell) return {};
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
