#include "analysis/misfit/believable.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "calib/fit/calibration_notes.h"
#include "calib/fit/inexactness.h"
#include "calib/fit/parameter_errors.h"
#include "data/remarks/wording.h"
#include "sim/catalogue/unknown_walls.h"

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

/// Errors that are more than ten times as large as the scatter count as ten times as large [1]:
/// chosen, since repetitions that agree still better are copies of one value.
constexpr double most_excess = 10;

/// "chi2 = 24.4 for 5 degrees of freedom (p < 0.001)" of a misfit that is too large.
std::string failing_chi2(const Misfit& misfit) {
    return fmt::format("chi2 = {:.4g} for {} degree{} of freedom (p < 0.001)", misfit.chi2,
                       misfit.dof, misfit.dof == 1 ? "" : "s");
}

/// Sentence on readings that the model does not describe.
std::string failure_text(const Agreement& agreement, const std::string& which) {
    return fmt::format(
        "The model does not describe {}: {}, {:.2g} times the errors. It misses the shear stress "
        "by {:.2g} % and the solid fraction by {:.2g} %.",
        which, failing_chi2(agreement.misfit), agreement.in_errors(), agreement.rms_percent[0],
        agreement.rms_percent[1]);
}

/// Sentence on a misfit that stated errors hide.
std::string hidden_text(const Agreement& fitted) {
    return fmt::format(
        "The standard errors given with the readings hide a misfit: with the scatter of repeated "
        "readings in their place, {}. Correct them, or leave them out.",
        failing_chi2(*fitted.by_scatter));
}

/// Sentence on an error that the readings would need far from 0.
std::string far_text(const InstrumentError& far) {
    // Those of walls are no shares of a value.
    const bool relative = far.unit == "1" && !is_unknown_of_walls(far.name);
    const std::string size = relative ? fmt::format(" of {:.2g} %", 100 * far.standard) : "";
    const std::string others =
        far.alike.empty()
            ? ""
            : fmt::format(", and what changes the readings alike: {}", fmt::join(far.alike, ", "));
    return fmt::format(
        "The readings fit best with an error of {} that is {:.1f} times its {}standard "
        "uncertainty{}: check it{}.",
        far.name, std::abs(far.needed), far.assumed ? "typical " : "", size, others);
}

/// Faults inside recordings that change what is averaged.
bool shifts_means(const Remark& fault) {
    using enum Remark::Kind;
    return !fault.corrected &&
           (fault.kind == stick_slip || fault.kind == drift || fault.kind == unfinished_run_in);
}

/// Sentence on steps of which most never became steady; empty if they are fewer than the readings.
std::string unsteady_text(const Measurements& measurements) {
    const auto lost = std::ranges::count_if(
        measurements.remarks, [](const Remark& remark) { return without_plateau(remark.kind); });
    if (lost <= std::ssize(measurements.readings)) return "";
    return fmt::format(
        "{} of {} steps never became steady, so that the others may not be steady either: record "
        "longer steps.",
        lost, lost + std::ssize(measurements.readings));
}

/// Readings whose errors of shear stress and solid fraction are divided by `excess`.
Measured with_smaller_errors(Measured measured, std::size_t readings,
                             const std::array<double, 2>& excess) {
    Eigen::VectorXd factor = Eigen::VectorXd::Ones(measured.value.size());
    for (std::size_t k = 0; k < 2 * readings; ++k)
        factor(static_cast<Eigen::Index>(k)) = 1 / excess[k % 2];
    measured.covariance = factor.asDiagonal() * measured.covariance * factor.asDiagonal();
    return measured;
}

/// Adds the reasons that lie in the measurement itself.
void add_doubts(Belief& belief, const Measurements& measurements) {
    const std::vector<Remark> doubts = measurements.doubts();
    for (std::size_t k = 0; k < std::min(most_doubts, doubts.size()); ++k) {
        belief.reasons.push_back(text_of(doubts[k]));
    }
    if (doubts.size() > most_doubts) {
        belief.reasons.push_back(fmt::format("{} further warnings; 'pendular import' lists them.",
                                             doubts.size() - most_doubts));
    }
    std::vector<Remark> faults = measurements.faults(true);
    std::erase_if(faults, [](const Remark& fault) { return !shifts_means(fault); });
    for (const std::string& sentence : sentences(faults))
        belief.reasons.push_back(sentence);
    if (const auto reason = common_reason(measurements)) {
        belief.reasons.push_back(*reason);
    } else if (std::string text = unsteady_text(measurements); !text.empty()) {
        belief.reasons.push_back(std::move(text));
    }
}

}  // namespace

Agreement::Degree Agreement::degree() const {
    if (as_inexact.p() < incredible_p) return Degree::fails;
    return as_inexact.chi2 != misfit.chi2 ? Degree::nearly : Degree::describes;
}

double Agreement::in_errors() const {
    return misfit.dof > 0 ? std::sqrt(misfit.chi2 / misfit.dof) : 0;
}

std::string_view to_string(Agreement::Degree degree) {
    switch (degree) {
        case Agreement::Degree::describes:
            return "describes";
        case Agreement::Degree::nearly:
            return "nearly";
        case Agreement::Degree::fails:
            return "fails";
    }
    throw std::logic_error("a degree of agreement has no name");
}

Agreement agreement_of(const std::vector<Reading>& readings,
                       const std::vector<DirectMeasurement>& direct, const Prediction& prediction,
                       const std::vector<bool>& at_bound, const Misfit& misfit,
                       const ModelSettings& model, const ExcessOfErrors& excess) {
    Agreement agreement{.misfit = misfit,
                        .readings = readings.size(),
                        .rms_percent = rms_percent(readings, prediction.value),
                        .discrepancy = model.discrepancy,
                        .as_inexact = misfit};
    const Measured measured = stack(readings, direct);
    if (excess.factor != std::array{1.0, 1.0}) {
        const Measured smaller = with_smaller_errors(measured, readings.size(), excess.factor);
        const double largest = model.discrepancy_stated ? 1 : largest_inexactness;
        agreement.by_scatter = misfit;
        agreement.by_scatter->chi2 =
            likely_inexactness(smaller, prediction, at_bound, largest).chi2;
        agreement.by_scatter->freedom = std::min(misfit.freedom, excess.freedom);
    }
    if (model.discrepancy_stated) return agreement;
    const Inexactness likely = likely_inexactness(measured, prediction, at_bound);
    if (likely.factor > 1) {
        agreement.as_inexact.chi2 = likely.chi2;
        for (double& each : agreement.discrepancy)
            each *= likely.factor;
    }
    return agreement;
}

ExcessOfErrors excess_of_errors(const Measurements& measurements) {
    ExcessOfErrors excess;
    for (const Remark& note : measurements.notes()) {
        if (note.kind != Remark::Kind::errors_above_scatter) continue;
        excess.factor[note.quantity == "shear_stress" ? 0 : 1] =
            std::min(most_excess, 1 / note.relative);
        excess.freedom = std::min(excess.freedom, note.freedom);
    }
    return excess;
}

Belief belief_in(const Fit& fit, const std::vector<Parameter>& parameters, const Agreement& fitted,
                 const std::optional<Agreement>& predicted, const Measurements& measurements,
                 const std::optional<UnitMistake>& mistake) {
    Belief belief{.fitted = fitted, .predicted = predicted};
    if (mistake) belief.reasons.push_back(mistake->sentence());
    const bool undescribed = fitted.degree() == Agreement::Degree::fails;
    if (undescribed) {
        belief.misfit_reason = belief.reasons.size();
        belief.reasons.push_back(failure_text(fitted, "the fitted readings"));
    }
    if (!undescribed && fitted.by_scatter && fitted.by_scatter->p() < incredible_p)
        belief.reasons.push_back(hidden_text(fitted));
    for (std::size_t k = 0; k < parameters.size(); ++k) {
        if (!out_of_range(fit, parameters, k)) continue;
        belief.reasons.push_back(fmt::format(
            "The fitted {} is {:.3g}, at the end of its range, {}.", parameters[k].name,
            fit.parameters(static_cast<Eigen::Index>(k)), range_text(fit, parameters, k)));
    }
    if (!undescribed) belief.far = far_errors(fit);
    if (!belief.far.empty()) belief.reasons.push_back(far_text(belief.far.front()));
    add_doubts(belief, measurements);
    if (predicted && predicted->degree() == Agreement::Degree::fails) {
        belief.for_fitted_only = belief.reasons.empty();
        belief.reasons.push_back(failure_text(
            *predicted,
            fmt::format("the {} readings that were predicted, not fitted", predicted->readings)));
    }
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
