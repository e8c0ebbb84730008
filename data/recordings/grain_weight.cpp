#include "data/recordings/grain_weight.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "data/grains.h"

namespace pendular {
namespace {

constexpr double heavy = 0.1;  // smallest weight to report, over the normal stress

std::string range_of(double least, double greatest) {
    const std::string from = fmt::format("{:.4g}", least), to = fmt::format("{:.4g}", greatest);
    return from == to ? from + " Pa" : from + " to " + to + " Pa";
}

}  // namespace

std::optional<std::string> grain_weight_note(const Study& study,
                                             const std::vector<Reading>& readings) {
    const bool listed = std::ranges::find(study.model.effects, "grain-weight",
                                          &ListedEffect::name) != study.model.effects.end();
    if (listed || !study.cell) return std::nullopt;
    double weight = 0, least = INFINITY, greatest = 0;
    std::size_t count = 0;
    for (const Reading& reading : readings) {
        const double own = reading.condition.bead_volume.value_or(0) * study.grains.density *
                           gravity / study.cell->area();
        const double stress = reading.condition.normal_stress;
        if (reading.step == 0 || own <= heavy * stress) continue;
        weight = std::max(weight, own);
        least = std::min(least, stress), greatest = std::max(greatest, stress);
        ++count;
    }
    if (count == 0) return std::nullopt;
    return fmt::format(
        "The model neglects the weight of the beads, which raises the normal stress at the base by "
        "up to {:.0f} Pa. The increase exceeds 10 % of the applied normal stress in {} of {} "
        "readings, those at {}. 'pendular diagnose' tests the effect grain-weight.",
        weight, count, readings.size(), range_of(least, greatest));
}

}  // namespace pendular
