#include "analysis/misfit/believable.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "calib/fit/calibration_notes.h"
#include "data/remarks/wording.h"

namespace pendular {
namespace {

/// Largest number of doubts that become reasons of their own; further doubts are only counted, and
/// `pendular import` lists all.
constexpr std::size_t most_doubts = 5;

/// Whether parameter k ended at a bound of its range. A lower bound of zero does not count, except
/// for the friction (k = 0), since a parameter of zero is only an effect that is absent.
bool out_of_range(const Fit& fit, const std::vector<Parameter>& parameters, std::size_t k) {
    const Parameter& p = parameters[k];
    const bool friction = k == 0;
    const double at = fit.parameters(static_cast<Eigen::Index>(k));
    const bool lower = std::abs(at - p.lower) < std::abs(at - p.upper);
    return fit.at_bound[k] && (friction || !lower || p.lower != 0);
}

}  // namespace

Belief belief_in(const Fit& fit, const std::vector<Parameter>& parameters, const Misfit& misfit,
                 const Measurements& measurements, const std::optional<UnitMistake>& mistake) {
    Belief belief;
    if (mistake) belief.reasons.push_back(mistake->sentence());
    const bool undescribed = misfit.p() < incredible_p;
    if (undescribed) {
        belief.misfit_reason = belief.reasons.size();
        belief.reasons.push_back(
            fmt::format("The model does not describe the fitted readings: chi2 = {:.4g} for {} "
                        "degrees of freedom (p < 0.001).",
                        misfit.chi2, misfit.dof));
    }
    for (std::size_t k = 0; k < parameters.size(); ++k) {
        if (!out_of_range(fit, parameters, k)) continue;
        belief.reasons.push_back(fmt::format(
            "The fitted {} is {:.3g}, at the end of its range, {}.", parameters[k].name,
            fit.parameters(static_cast<Eigen::Index>(k)), range_text(fit, parameters, k)));
    }
    const std::vector<Remark> doubts = measurements.doubts();
    for (std::size_t k = 0; k < std::min(most_doubts, doubts.size()); ++k) {
        belief.reasons.push_back(text_of(doubts[k]));
    }
    if (doubts.size() > most_doubts) {
        belief.reasons.push_back(fmt::format("{} further warnings; 'pendular import' lists them.",
                                             doubts.size() - most_doubts));
    }
    if (const auto reason = common_reason(measurements)) belief.reasons.push_back(*reason);
    belief.meaningless =
        (undescribed && !fit.at_bound.empty() && fit.at_bound[0]) || mostly_set_aside(measurements);
    return belief;
}

std::size_t doubts_that_set_aside(const Measurements& measurements) {
    return measurements.with(Remark::Outcome::set_aside).size();
}

namespace {

std::string assumed_text(const Measurements& measurements, std::ptrdiff_t assumed) {
    const std::vector<Remark> notes = measurements.notes();
    const auto note = std::ranges::find(notes, Remark::Kind::assumed_errors, &Remark::kind);
    const bool of_one = note != notes.end() && !note->quantity.empty();
    return fmt::format(
        "Standard errors of 2 %{} are assumed for {} of {} readings, since no error was stated and "
        "no reading was repeated.",
        of_one ? " of " + words_for_quantity(note->quantity) : "", assumed,
        measurements.readings.size());
}

/// Sentence on stated errors that are too large for the scatter of replicates; empty if none are.
std::string too_large_text(const Measurements& measurements, std::ptrdiff_t repeated) {
    std::vector<std::string> parts;
    for (const Remark& note : measurements.notes())
        if (note.kind == Remark::Kind::errors_above_scatter)
            parts.push_back(fmt::format("those of {} are {} times",
                                        words_for_quantity(note.quantity),
                                        factor_above_scatter(note)));
    if (parts.empty()) return "";
    return fmt::format(
        " They are too large: {} as large as the scatter of {} repeated readings (see the notes of "
        "'pendular import').",
        fmt::join(parts, " and "), repeated);
}

}  // namespace

std::string error_basis(const Measurements& measurements) {
    const auto assumed = std::ranges::count_if(measurements.readings, &Reading::error_assumed);
    if (assumed > 0) return assumed_text(measurements, assumed);
    if (measurements.scatter.stated)
        return "Standard errors are those stated in [scatter] of study.toml.";
    const auto repeated = std::ranges::count_if(measurements.readings,
                                                [](const Reading& r) { return r.replicates > 1; });
    const bool known = std::ranges::all_of(measurements.readings, [](const Reading& r) {
        return r.scatter_freedom.array().isInf().all();
    });
    const std::string too_large = too_large_text(measurements, repeated);
    if (repeated > 0 && known) {
        if (!too_large.empty())
            return "Standard errors are those given with the readings." + too_large;
        return fmt::format(
            "Standard errors are those given with the readings; {} repeated readings agree with "
            "them.",
            repeated);
    }
    return repeated > 0 ? fmt::format(
                              "The standard errors of the readings are estimated from the scatter "
                              "of {} repeated readings.",
                              repeated)
                        : "Standard errors are those given with the readings.";
}

}  // namespace pendular
