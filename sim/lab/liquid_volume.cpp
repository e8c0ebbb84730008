#include "sim/lab/liquid_volume.h"

#include <algorithm>
#include <cmath>

#include "sim/dem/bridge_law.h"

namespace pendular {
namespace {

/// Relative error of a liquid content that needs no further simulation [1]. Chosen: the pilot runs
/// are short and small, and their coordination numbers are noisy.
constexpr double tolerance = 0.03;

bool off(double found, double wanted) {
    return std::abs(found / wanted - 1) > tolerance;
}

/// Trial: a bridge volume over a^3 with the liquid content [1] that its simulation gave.
struct Trial {
    double volume = 0;
    double content = 0;
};

/// Returns the bridge volume that gives the wanted liquid content at the coordination number of the
/// trial.
double at_same_coordination(const Trial& trial, double wanted) {
    return trial.volume * wanted / trial.content;
}

/// Returns the bridge volume where the secant through two trials, in logarithms, has the wanted
/// liquid content. The slope is limited to 0.8 to 1.25, since noise dominates it where the trials
/// are close.
double secant(const Trial& first, const Trial& second, double wanted) {
    const double slope =
        std::log(second.content / first.content) / std::log(second.volume / first.volume);
    return second.volume * std::pow(wanted / second.content, 1 / std::clamp(slope, 0.8, 1.25));
}

}  // namespace

double first_bridge_volume(double liquid_content) {
    return dem::bridge_volume(liquid_content, dem::typical_coordination);
}

std::vector<double> bridge_volumes(std::span<const double> liquid_contents,
                                   const MeasureLiquidContents& measure) {
    std::vector<std::size_t> which;
    std::vector<double> volumes;
    for (const double content : liquid_contents) {
        which.push_back(which.size());
        volumes.push_back(first_bridge_volume(content));
    }
    const std::vector<double> first_contents = measure(which, volumes);
    std::vector<Trial> first;
    for (const std::size_t k : which) {
        first.push_back({volumes[k], first_contents[k]});
        volumes[k] = at_same_coordination(first[k], liquid_contents[k]);
    }
    std::erase_if(which, [&](std::size_t k) { return !off(first[k].content, liquid_contents[k]); });
    if (which.empty()) {
        return volumes;
    }
    std::vector<double> corrected;
    for (const std::size_t k : which) {
        corrected.push_back(volumes[k]);
    }
    const std::vector<double> second_contents = measure(which, corrected);
    for (std::size_t i = 0; i < which.size(); ++i) {
        const std::size_t k = which[i];
        if (off(second_contents[i], liquid_contents[k])) {
            volumes[k] = secant(first[k], {corrected[i], second_contents[i]}, liquid_contents[k]);
        }
    }
    return volumes;
}

}  // namespace pendular
