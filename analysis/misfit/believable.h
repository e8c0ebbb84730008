#pragma once

#include <array>
#include <cmath>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "analysis/misfit/compare.h"
#include "analysis/misfit/unit_mistakes.h"
#include "calib/fit/fit.h"
#include "data/reading.h"
#include "data/study/study.h"

namespace pendular {

/// How much larger stated errors are than the scatter of replicates.
struct ExcessOfErrors {
    std::array<double, 2> factor = {1, 1};  ///< of shear stress and solid fraction [1]
    double freedom = INFINITY;              ///< degrees of freedom of the scatter [1]
};

/// How well a fitted model describes a set of readings.
struct Agreement {
    enum class Degree {
        describes,  ///< within the errors, with the discrepancy that is expected of a model
        nearly,     ///< with a larger discrepancy, of at most `largest_inexactness`
        fails       ///< not even so
    };
    Misfit misfit = {};                   ///< with the expected discrepancy
    std::size_t readings = 0;             ///< number of readings
    std::array<double, 2> rms_percent{};  ///< of the predictions (`rms_percent`) [%]
    /// Relative standard errors [1] of stress ratio and solid fraction that the model would have to
    /// have, those that are expected or `Inexactness::factor` times as much.
    std::array<double, 2> discrepancy{};
    Misfit as_inexact = {};  ///< with this discrepancy
    /// As `as_inexact`, with the scatter of replicates in place of stated errors that are larger.
    std::optional<Misfit> by_scatter = {};
    Degree degree() const;
    /// Returns the size of the misfits [1] in units of the errors, sqrt(chi2/dof).
    double in_errors() const;
};
std::string_view to_string(Agreement::Degree degree);

/// Returns the agreement of readings with their prediction.
/// @param direct direct measurements that were fitted together with the readings
/// @param at_bound as for `likely_inexactness`
/// @param misfit of the readings and the direct measurements
/// @param model states the discrepancy, which is enlarged unless study.toml states it
Agreement agreement_of(const std::vector<Reading>& readings,
                       const std::vector<DirectMeasurement>& direct, const Prediction& prediction,
                       const std::vector<bool>& at_bound, const Misfit& misfit,
                       const ModelSettings& model, const ExcessOfErrors& excess = {});

/// Returns by how much stated errors exceed the scatter, as the notes of the import say.
ExcessOfErrors excess_of_errors(const Measurements& measurements);

/// Judgement on whether the fit of a study's model can be believed.
struct Belief {
    Agreement fitted = {};                    ///< of the fitted readings
    std::optional<Agreement> predicted = {};  ///< of readings that were predicted, not fitted
    /// Sentences for the user with the reasons not to believe the fit, the most serious first.
    std::vector<std::string> reasons;
    /// Errors that all readings share and that these would need far from 0, the farthest first,
    /// where they are a reason.
    std::vector<InstrumentError> far = {};
    /// Whether the fitted values are meaningless: the model does not describe the readings and the
    /// friction coefficient is at the end of its range, or the import excluded more readings than
    /// it kept.
    bool meaningless = false;
    std::optional<std::size_t> misfit_reason = {};  ///< index in `reasons` of the sentence on chi2
    /// Whether the only reason is that the model fails where it predicts readings that were not
    /// fitted.
    bool for_fitted_only = false;

    bool believable() const { return reasons.empty(); }
};

/// Smallest p value of chi2 [1] at which a model counts as describing the readings: the smallest
/// that is printed. The p value allows for errors that few replicates determine, so that at most
/// 1 of 1000 fits of a right model is refused.
constexpr double incredible_p = 1e-3;

/// Returns the reasons not to believe a fit: a wrong unit, a large misfit of fitted or predicted
/// readings, errors so large that they hide a misfit, a shared error that the readings would need,
/// parameters at the end of their range, doubts and faults of the import, and steps of which most
/// gave no reading.
/// @param parameters the first is the friction coefficient
Belief belief_in(const Fit& fit, const std::vector<Parameter>& parameters, const Agreement& fitted,
                 const std::optional<Agreement>& predicted, const Measurements& measurements,
                 const std::optional<UnitMistake>& mistake);

/// Returns the number of doubts because of which the import excluded readings or data points.
std::size_t doubts_that_set_aside(const Measurements& measurements);

/// Returns a sentence on the source of the readings' standard errors, such as "The standard errors
/// of the readings are estimated from the scatter of 22 repeated readings."
std::string error_basis(const Measurements& measurements);

}  // namespace pendular
