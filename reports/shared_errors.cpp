#include "reports/shared_errors.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "calib/fit/parameter_errors.h"
#include "reports/with_error.h"
#include "reports/words.h"
#include "sim/catalogue/unknown_walls.h"

namespace pendular {
namespace {

/// Error of a shared quantity as text, such as "torque-gain 2 % (assumed)".
std::string uncertainty_text(const InstrumentError& error) {
    if (error.name == unknown_wall_friction)
        return fmt::format("{} (unknown, 0 to {})", error.name, largest_unknown_wall_friction);
    if (error.name == "wall-layers") return error.name + " (not in the model)";
    const std::string size = error.unit == "1" ? fmt::format("{:.2g} %", 100 * error.standard)
                                               : with_unit(error.standard, error.unit);
    return fmt::format("{} {}{}", error.name, size,
                       error.assumed && error.counts ? " (assumed)" : "");
}

/// Names of the errors that act alike with the largest one of a cause, and their contribution
/// together: " (0.047 together with height-offset and bead_mass, which act alike)".
std::string alike_text(const SharedCause& cause, const std::string& unit) {
    const std::vector<std::string>& alike = cause.largest.alike;
    if (alike.empty()) return "";
    const std::string names = joined(alike, "and"),
                      alone = with_unit(std::abs(cause.largest.shift(0)), unit),
                      together = with_unit(cause.together, unit),
                      verb = alike.size() == 1 ? "acts" : "act";
    return alone == together
               ? fmt::format(" ({} {} alike)", names, verb)
               : fmt::format(" ({} together with {}, which {} alike)", together, names, verb);
}

/// The three largest causes among the errors that count (or do not), with their parts of the error
/// of the first parameter: "torque-gain 2 % (assumed) gives 0.0080 (normal-force-gain acts alike),
/// ...".
std::string largest_parts(const Calibration& c, bool counts) {
    const std::string& unit = c.parameters[0].unit;
    std::vector<std::string> parts;
    for (const SharedCause& each : largest_causes(c.fit, 0, counts, 3))
        parts.push_back(fmt::format("{} gives {}{}", uncertainty_text(each.largest),
                                    with_unit(std::abs(each.largest.shift(0)), unit),
                                    alike_text(each, unit)));
    return fmt::format("{}", fmt::join(parts, ", "));
}

/// How much too large walls of unknown friction may make the first parameter, with its unit; empty
/// if nothing is unknown of them.
std::string error_by_walls(const Calibration& c) {
    const auto walls =
        std::ranges::find(c.fit.instrument, unknown_wall_friction, &InstrumentError::name);
    if (walls == c.fit.instrument.end() || !c.fit.determines(0)) return "";
    // They raise the torque; where that lowers a parameter, there is no such sentence on it.
    return walls->shift(0) > 0 ? with_unit(walls->shift(0), c.parameters[0].unit) : "";
}

}  // namespace

void add_shared_errors(Output& output, const Calibration& c) {
    if (!c.fit.determines(0)) return;
    if (const std::string parts = largest_parts(c, true); !parts.empty())
        output.line(fmt::format("Largest parts of what all readings share: {}.", parts));
    const bool of_walls =
        std::ranges::any_of(c.fit.instrument, is_unknown_of_walls, &InstrumentError::name);
    if (const std::string parts = largest_parts(c, false); !parts.empty())
        output.line(fmt::format(
            "Largest parts of the typical systematic error, {}: {}. State {} in [instrument] of "
            "study.toml, and the fit weighs the readings by them.",
            with_unit(c.fit.instrument_error(0, false), c.parameters[0].unit), parts,
            of_walls ? "those of your instrument" : "yours"));
    if (const std::string walls = error_by_walls(c); !walls.empty())
        output.line(fmt::format(
            "The side walls are close, and nothing says what friction they have: as they raise the "
            "torque, the fitted {} may be too large by {}. State wall_friction in [cell] of "
            "study.toml; import then says what the walls do, and the effect to add.",
            parameter_in_words(c.parameters[0].name), walls));
    if (std::ranges::find(c.fit.instrument, "wall-layers", &InstrumentError::name) !=
        c.fit.instrument.end())
        output.line(
            "Along flat side walls, beads lie in layers that shear easily: add the effect "
            "wall-layers, which takes this part away.");
}

std::string systematic_text(const Calibration& c) {
    const double error = c.fit.instrument_error(0, false);
    if (!c.fit.determines(0) || !(error > 0)) return "";
    const std::string walls = error_by_walls(c);
    return fmt::format(" +- {} (systematic: typical errors of {}{})",
                       with_unit(error, c.parameters[0].unit),
                       c.fit.instrument_error(0) > 0 ? "what [instrument] does not state"
                                                     : "an instrument, as study.toml states none",
                       walls.empty() ? "" : ", and walls of unknown friction, " + walls);
}

}  // namespace pendular
