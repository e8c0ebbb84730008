#include "calib/fit/range_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

namespace pendular {

/// Friction coefficients between beads that are believed [1]. Measured in collisions of single
/// beads: 0.09 for soda lime glass and 0.25 for cellulose acetate (Foerster, Louge, Chang and
/// Allia, Phys. Fluids 6, 1108, 1994); Badetti et al. (2018) find 0.09 for polystyrene. Half of the
/// lowest leaves room for polished and lubricated beads. Sliding of unlubricated steel and polymers
/// reaches 0.6 to 0.8 in tables for engineers; what is above is interlocking of grains that are no
/// beads.
constexpr double least_plausible = 0.05, greatest_plausible = 0.8;

std::string range_text(const Fit& fit, const std::vector<Parameter>& parameters, std::size_t k) {
    const auto i = static_cast<Eigen::Index>(k);
    const Parameter& p = parameters[k];
    if (i >= fit.range.upper.size()) return fmt::format("{:.3g} to {:.3g}", p.lower, p.upper);
    const double lower = fit.range.lower(i), upper = fit.range.upper(i), at = fit.parameters(i);
    const bool below = at - lower < upper - at;
    const double end = below ? lower : upper;
    return fmt::format("{:.3g} to {:.3g}{}", lower, upper,
                       end == (below ? p.lower : p.upper)
                           ? ""
                           : fmt::format(" ({:.3g} is the end of the simulations)", end));
}

std::optional<std::string> implausible_friction(double friction) {
    if (friction >= least_plausible && friction <= greatest_plausible) return std::nullopt;
    return fmt::format(
        "A friction coefficient of {:.3g} is implausible: beads of glass, steel and polymers have "
        "{} to {}. The usual cause is {}, or an effect that is missing.",
        friction, least_plausible, greatest_plausible,
        friction < least_plausible
            ? "a torque that is shown too small, a normal force that is shown too large, a lid "
              "that "
              "slips"
            : "a torque that is shown too large, by the drag of a seal for example, a normal force "
              "that is shown too small, or grains that are not spheres");
}

std::optional<std::string> extrapolation_note(const std::vector<dem::RunResult>& runs,
                                              const std::vector<Reading>& readings) {
    double lowest = std::numeric_limits<double>::infinity();
    for (const dem::RunResult& run : runs)
        lowest = std::min(lowest, run.parameters.inertial_number);
    const auto slower = std::ranges::count_if(readings, [&](const Reading& reading) {
        return reading.condition.inertial_number < lowest;
    });
    if (runs.empty() || slower == 0) return std::nullopt;
    return fmt::format(
        "The predictions of {} of {} readings are extrapolated: their inertial numbers are below "
        "{:.2g}, the lowest that was simulated.",
        slower, readings.size(), lowest);
}

}  // namespace pendular
