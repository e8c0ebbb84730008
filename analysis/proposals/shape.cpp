#include "analysis/proposals/shape.h"

#include <fmt/format.h>

#include <algorithm>

#include "data/annular_cell.h"
#include "sim/catalogue/effect_catalogue.h"
#include "sim/catalogue/written_effect.h"

namespace pendular {
namespace {

/// Quantity with a factor 1 + change on it; the change is at most `largest` and at least -0.9,
/// so that the factor stays positive.
ChangedQuantity factor_on(const std::string& target, double smallest, double largest) {
    return {.target = target,
            .unit = "1",
            .smallest = smallest,
            .lower = -std::min(0.9, largest),
            .upper = largest};
}

/// Quantity to which up to `largest` [unit] is added.
ChangedQuantity addition_to(const std::string& target, const std::string& unit, double largest) {
    return {.target = target,
            .relative = false,
            .unit = unit,
            .smallest = 0.01 * largest,
            .lower = -largest,
            .upper = largest};
}

/// Largest torque [N m] and normal force [N] that readings show.
struct Largest {
    double torque = 0, normal_force = 0;
};

Largest largest_of(const std::vector<Reading>& readings, const AnnularCell& cell) {
    Largest largest;
    for (const Reading& reading : readings) {
        largest.torque = std::max(largest.torque, torque(reading.value(0), cell));
        largest.normal_force =
            std::max(largest.normal_force, normal_force(reading.condition.normal_stress, cell));
    }
    return largest;
}

const char* word_for(Dependence dependence) {
    switch (dependence) {
        case Dependence::none:
            return "everywhere";
        case Dependence::power:
            return "with";
        case Dependence::logarithm:
            return "with-logarithm-of";
        case Dependence::above:
            return "above";
        case Dependence::below:
            return "below";
        case Dependence::beyond:
            return "growing-above";
        case Dependence::short_of:
            return "growing-below";
        case Dependence::decay:
            return "decaying-in";
        default:
            return "oscillating-in";
    }
}

std::string with_hyphens(std::string text) {
    std::ranges::replace(text, '_', '-');
    return text;
}

}  // namespace

WrittenEffect::Kind ChangedQuantity::kind() const {
    WrittenEffect effect;
    effect.formulas.push_back({target, {}, {}});
    return effect.kind();
}

std::string ShapeOfChange::name() const {
    const std::string start = with_hyphens(quantity.target) + "-" + word_for(profile.dependence);
    return profile.variable.empty() ? start : start + "-" + with_hyphens(profile.variable);
}

WrittenEffect ShapeOfChange::written(const std::string& name) const {
    const std::string size = profile.formula();
    const std::string change = size == "1" ? "change" : "change*" + size;
    return {.name = name,
            .parameter = "change",
            .unit = quantity.unit,
            .lower = quantity.lower,
            .upper = quantity.upper,
            .smallest_of_interest = quantity.smallest,
            .formulas = {{quantity.target,
                          quantity.relative ? fmt::format("{}*(1 + {})", quantity.target, change)
                                            : fmt::format("{} + {}", quantity.target, change),
                          {}}},
            .position = {}};
}

std::vector<ChangedQuantity> quantities_that_may_change(const ResolvedStudy& study,
                                                        const std::vector<Reading>& readings) {
    // Smallest changes of interest are chosen: 1 % of stresses and forces, 0.2 % of the solid
    // fraction and the height, which scatter as much less.
    constexpr double most = 3;  // a factor of 4 on what an instrument shows is a wrong unit
    std::vector<ChangedQuantity> all = {
        factor_on("stress_ratio", 0.01, most), factor_on("solid_fraction", 0.002, 0.2),
        addition_to("friction_difference", "1", 0.5), factor_on("surface_tension", 0.01, most)};
    if (const auto& cell = study.study().cell) {
        const Largest largest = largest_of(readings, *cell);
        const std::vector<ChangedQuantity> shown = {
            factor_on("torque", 0.01, most), addition_to("torque", "N m", largest.torque),
            factor_on("normal_force", 0.01, most),
            addition_to("normal_force", "N", largest.normal_force),
            factor_on("height", 0.002, 0.2)};
        all.insert(all.begin(), shown.begin(), shown.end());
    }
    std::erase_if(all, [&](const ChangedQuantity& quantity) {
        const ShapeOfChange shape{quantity, same_everywhere(readings.size())};
        return why_not(effect_from(shape.written("shape")), study).has_value();
    });
    return all;
}

}  // namespace pendular
