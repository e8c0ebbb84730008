#include <cmath>

#include "sim/catalogue/effect.h"

namespace pendular {
namespace {

/// Sets the diameters to evenly spaced quantiles of a uniform distribution over
/// [1 - sqrt(3) deviation, 1 + sqrt(3) deviation]. Only the order of the diameters is random, so
/// that every sample has the same sizes.
void spread(std::span<double> diameters, std::mt19937_64& random, const Values& v) {
    const double half_range = std::sqrt(3.0) * v["deviation"];
    const auto count = static_cast<double>(diameters.size());
    for (std::size_t k = 0; k < diameters.size(); ++k) {
        diameters[k] = 1 + half_range * ((2 * static_cast<double>(k) + 1) / count - 1);
    }
    for (std::size_t k = diameters.size(); k > 1; --k) {  // the same on every platform
        std::swap(diameters[k - 1], diameters[random() % k]);
    }
}

}  // namespace

/// Beads of several sizes pack more densely at nearly the same stress ratio, so that the effect
/// resembles a loss of beads or a wrong gap. By symmetry the response of the readings grows with
/// the square of the deviation.
Effect polydispersity() {
    return {.summary = "the grains differ in size",
            .equation = "diameters uniform over a (1 +- sqrt(3) deviation)",
            .parameters = {{.name = "deviation",
                            .unit = "1",
                            .lower = 0,
                            .upper = 0.3,
                            .neutral = 0,
                            // Chosen: by the square, a ninth of the change at the bound.
                            .smallest_of_interest = 0.1,
                            .meaning =
                                "standard deviation of the grain diameters, divided by their mean",
                            .amplitude = [](double deviation) { return deviation * deviation; }}},
            .change = dem::ChangeSample{.diameters = spread},
            .touches = Touches::all,
            .acts_through = {"solid_fraction"},
            .directly = "sieving",
            .references = {
                "Voivret, Radjai, Delenne, El Youssoufi, Phys. Rev. Lett. 102 (2009) 178001: "
                "strength does not depend on the span of sizes",
                "Desmond, Weeks, Phys. Rev. E 90 (2014) 022204: density does"}};
}

}  // namespace pendular
