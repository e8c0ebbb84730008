#include "calib/fit/calibration_notes.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <iterator>
#include <limits>
#include <optional>
#include <utility>

#include "calib/emulator/known_range.h"
#include "calib/fit/measured.h"
#include "calib/fit/stopping_rule.h"
#include "data/input_error.h"

namespace pendular {
namespace {

/// Reduced pressure P* [1] below which Badetti et al. (2018) observed that the flow localises.
constexpr double uniform_reduced_pressure = 0.5;
/// Advice on lowering the model's errors where the training runs are too few near the readings.
std::string remedy(const Calibration& c) {
    return c.simulated.empty() ? "more simulations at these states, by 'calibrate' or "
                                 "'add --confirm', reduce the error"
                               : "a higher fidelity reduces the error";
}

/// Note that names the readings whose predictions the earlier runs do not support; empty if there
/// are none.
std::optional<std::string> unsupported_note(const Calibration& c, const RunPlanner& planner) {
    constexpr std::size_t most_named = 5;  // chosen: enough to see what the readings share
    const KnownRange known(planner.simulation()->emulator());
    std::vector<std::string> readings;
    for (const Reading& reading : c.readings) {
        const FlowState state =
            planner.simulation()->flow_state_at(c.fit.parameters(0), reading.condition);
        if (const std::string why = known.why_unsupported(state); !why.empty()) {
            const auto file = std::filesystem::path(reading.origin.file).filename().string();
            const std::string place = reading.step > 0
                                          ? fmt::format("{} step {}", file, reading.step)
                                          : fmt::format("{}:{}", file, reading.origin.line);
            readings.push_back(fmt::format("{} ({})", place, why));
        }
    }
    if (readings.empty()) {
        return std::nullopt;
    }
    const std::size_t count = readings.size(), named = std::min(count, most_named);
    readings.resize(named);
    return fmt::format(
        "The simulations in atlas and store do not cover {} of {} readings: {}{}. {}.", count,
        c.readings.size(), fmt::join(readings, "; "),
        count > named ? fmt::format("; and {} more", count - named) : "",
        planner.may_simulate()
            ? "Simulate these states with 'pendular campaign', or leave these readings out"
            : "'pendular calibrate' without --no-confirm simulates these states");
}

/// Note on an observable for which the noise of the runs exceeds the errors of the fitted readings;
/// empty if there is none.
std::optional<std::string> unsure_note(const Calibration& c) {
    const Measured readings = stack(part(c.readings, 0, c.fitted));
    const auto rms_percent = [&](const Eigen::MatrixXd& covariance, int first) {
        const Eigen::ArrayXd relative = covariance.diagonal().head(readings.value.size()).array() /
                                        readings.value.array().square();
        return 100 * std::sqrt(relative(Eigen::seq(first, Eigen::last, 2)).mean());
    };
    for (const auto& [first, observable] : {std::pair(0, "shear stress"), {1, "solid fraction"}}) {
        const double simulated = rms_percent(c.fit.prediction.run_noise, first),
                     measured = rms_percent(readings.covariance, first);
        if (simulated > measured) {
            return fmt::format(
                "The model predicts the {} with an error of {:.2g} %, more than the error of the "
                "readings, {:.2g} %; {}",
                observable, simulated, measured, remedy(c));
        }
    }
    return std::nullopt;
}

/// Note where the time for simulations ended before their noise was small; empty otherwise.
std::optional<std::string> exhausted_note(const Calibration& c, const RunPlanner& planner) {
    const Enlargement enlarged =
        enlargement_by_runs(c.fit, stack(part(c.readings, 0, c.fitted), c.direct), c.parameters);
    if (!planner.exhausted()) return std::nullopt;
    if (planner.simulated().empty()) {
        return "The fit is not confirmed by simulations: none of them ended within the time given. "
               "'pendular calibrate --confirm MINUTES' gives more time";
    }
    if (enlarged.excess() <= 1) return std::nullopt;
    return fmt::format(
        "The time for simulations ended while the noise of the simulations still enlarged {}. "
        "'pendular calibrate --confirm' continues from the stored simulations",
        text_of(enlarged));
}

/// Note on a parameter whose fit ended at a bound. A bound at the neutral value means that the
/// effect is not needed; any other bound means that the best fit lies beyond the range.
std::string bound_note(const Calibration& c, std::size_t k, const ResolvedStudy& resolved) {
    const Parameter& parameter = c.parameters[k];
    const double value = c.fit.parameters(static_cast<Eigen::Index>(k));
    const Study& study = resolved;
    const auto dot = parameter.name.rfind('.');
    const double close = 1e-6 * (parameter.upper - parameter.lower);
    if (dot != std::string::npos) {
        const std::string name = parameter.name.substr(0, dot);
        const Effect& effect = resolved.catalogue().find(name);
        const double neutral =
            effect.parameters[effect.parameter(parameter.name.substr(dot + 1))].neutral;
        // Without being listed, the effect stays on at the value that the study gives.
        const bool stays_on = effect.given_by_liquid && study.liquid;
        if (!stays_on && std::abs(value - neutral) <= close) {
            const auto folder = study.file.parent_path();
            return fmt::format(
                "The readings show no sign of {0}: the fit gives {1} = {2:.3g}, where the effect "
                "vanishes. To remove the effect: pendular drop {3} {0}",
                name, parameter.name, neutral, folder.empty() ? "." : folder.string());
        }
    }
    return fmt::format(
        "The fitted {} ended at a bound of its range, {}: the best fit lies beyond the range, and "
        "the standard error holds on one side only, if at all.",
        parameter.name, range_text(c.fit, c.parameters, k));
}

std::vector<std::string> warnings(const Calibration& c, const ResolvedStudy& study) {
    std::vector<std::string> notes;
    if (const auto note = unsure_note(c)) {
        notes.push_back(*note);
    }
    const double corrections = std::pow(c.fit.simulation_error(0), 2) - c.fit.run_part(0, 0);
    // Chosen: less shortens the standard error by a sixth at most if it vanishes.
    if (corrections > 0.3 * c.fit.covariance(0, 0)) {
        notes.push_back(fmt::format(
            "{:.0f} % of the variance comes from the corrections to the study's stiffness and to "
            "the quasi-static limit; a stiffer and slower fidelity reduces it.",
            100 * corrections / c.fit.covariance(0, 0)));
    }
    const auto localised = std::ranges::count_if(c.readings, [&](const Reading& r) {
        return !r.condition.dry() && reduced_pressure(r.condition.normal_stress, c.grains,
                                                      *c.liquid) < uniform_reduced_pressure;
    });
    if (localised > 0) {
        notes.push_back(fmt::format(
            "{} readings have a reduced pressure below {}, where wet grains tend to shear in "
            "bands: shear may not be uniform in the cell and in the simulation.",
            localised, uniform_reduced_pressure));
    }
    for (std::size_t k = 0; k < c.parameters.size(); ++k) {
        if (c.fit.at_bound[k]) {
            notes.push_back(bound_note(c, k, study));
        }
    }
    return notes;
}

}  // namespace

std::vector<std::string> undetermined(const Fit& fit, const std::vector<Parameter>& parameters) {
    /// Smallest component of a parameter, relative to the largest, that counts as part of a
    /// combination [1]. Chosen: where one parameter crosses its range, another one that moves by a
    /// hundredth of its own stays.
    constexpr double smallest_of_interest = 0.01;
    const auto n = static_cast<Eigen::Index>(parameters.size());
    Eigen::VectorXd ranges(n);
    for (Eigen::Index k = 0; k < n; ++k) {
        const Parameter& p = parameters[static_cast<std::size_t>(k)];
        const double width = fit.width(k);  // unknown in a fit that an earlier version wrote
        ranges(k) = std::isfinite(width) ? width : p.upper - p.lower;
    }
    std::vector<std::string> sentences;
    if (n == 0 || !fit.covariance.allFinite() || !(ranges.minCoeff() > 0)) {
        return sentences;
    }
    const Eigen::MatrixXd scaled = ranges.cwiseInverse().asDiagonal() * fit.total_covariance() *
                                   ranges.cwiseInverse().asDiagonal();
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> axes(scaled);
    for (Eigen::Index axis = n - 1; axis >= 0 && axes.eigenvalues()(axis) > 1; --axis) {
        const Eigen::VectorXd direction = axes.eigenvectors().col(axis);
        const double largest = direction.cwiseAbs().maxCoeff();
        std::vector<std::string> names, steps;
        double first = 0;
        for (Eigen::Index k = 0; k < n; ++k) {
            if (std::abs(direction(k)) < smallest_of_interest * largest) {
                continue;
            }
            const Parameter& p = parameters[static_cast<std::size_t>(k)];
            const double step = direction(k) * ranges(k);
            first = first == 0 ? step : first;
            names.push_back(p.name);
            steps.push_back(
                fmt::format("{:.3g}{}", step / first, p.unit == "1" ? "" : " " + p.unit));
        }
        sentences.push_back(
            names.size() == 1
                ? fmt::format("The readings do not determine {}: drop it, or measure where it "
                              "changes the readings.",
                              names.front())
                : fmt::format(
                      "The readings do not tell {} apart: changed together in the proportion {} "
                      "they fit equally well. Drop one, or measure where they differ.",
                      fmt::join(names, " and "), fmt::join(steps, " : ")));
    }
    return sentences;
}

std::vector<std::string> notes_on(const Calibration& c, const ResolvedStudy& study,
                                  const RunPlanner& planner, bool wet_known) {
    std::vector<std::string> notes;
    if (const auto note = unsupported_note(c, planner)) {
        notes.push_back(*note);
    }
    if (!wet_known) {
        notes.push_back(
            "The errors of the wet predictions are not small compared with the errors of the wet "
            "readings: " +
            remedy(c));
    }
    if (const auto note = exhausted_note(c, planner)) {
        notes.push_back(*note);
    }
    std::ranges::copy(planner.notes(), std::back_inserter(notes));
    std::ranges::copy(warnings(c, study), std::back_inserter(notes));
    std::ranges::copy(undetermined(c.fit, c.parameters), std::back_inserter(notes));
    return notes;
}

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
