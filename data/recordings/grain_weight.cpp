#include "data/recordings/grain_weight.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <set>

#include "data/grains.h"

namespace pendular {
namespace {

constexpr double heavy = 0.1;          // smallest weight to report, over the normal stress
constexpr std::size_t most_named = 3;  // largest number of files to name

/// Names of the first files and the number of the others: "a.csv, b.csv, c.csv and 3 more".
std::string named(const std::set<std::string>& files) {
    std::string text;
    std::size_t count = 0;
    for (const std::string& file : files) {
        if (++count > most_named) break;
        text += (text.empty() ? "" : ", ") + file;
    }
    const std::size_t rest = files.size() - std::min(files.size(), most_named);
    return rest == 0 ? text : fmt::format("{} and {} more", text, rest);
}

std::string range_of(double least, double greatest) {
    return least == greatest ? fmt::format("{:.4g} Pa", least)
                             : fmt::format("{:.4g} to {:.4g} Pa", least, greatest);
}

}  // namespace

std::optional<std::string> grain_weight_note(const Study& study,
                                             const std::vector<Reading>& readings) {
    const bool listed = std::ranges::find(study.model.effects, "grain-weight",
                                          &ListedEffect::name) != study.model.effects.end();
    if (listed || !study.cell) return std::nullopt;
    double weight = 0, least = INFINITY, greatest = 0;
    std::size_t count = 0;
    std::set<std::string> files;
    for (const Reading& reading : readings) {
        const double own = reading.condition.bead_volume.value_or(0) * study.grains.density *
                           gravity / study.cell->area();
        const double stress = reading.condition.normal_stress;
        if (reading.step == 0 || own <= heavy * stress) continue;
        weight = std::max(weight, own);
        least = std::min(least, stress), greatest = std::max(greatest, stress);
        files.insert(std::filesystem::path(reading.origin.file).filename().string());
        ++count;
    }
    if (count == 0) return std::nullopt;
    return fmt::format(
        "The weight of the grains adds {:.0f} Pa over the depth, more than 10 % of the normal "
        "stress in {} of {} readings ({}; {}): shear may concentrate under the lid, and the normal "
        "stress at mid-height is higher than shown. 'pendular diagnose' tests the effect "
        "grain-weight.",
        weight, count, readings.size(), named(files), range_of(least, greatest));
}

}  // namespace pendular
