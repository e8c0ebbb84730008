#pragma once

#include <cstddef>
#include <vector>

#include "analysis/diagnosis/diagnosis.h"
#include "analysis/proposals/shape.h"
#include "calib/model/study_models.h"

namespace pendular {

/// Change of the model's predictions by an unknown cause, fitted to the readings. The shape of the
/// change states which quantity changes, and how the change varies between readings.
struct FittedShape {
    ShapeOfChange shape;
    /// The change, defined by formulas as an effect that can be copied to study.toml.
    WrittenEffect effect;
    /// Fitted amplitude of the change [unit of the quantity that changes, or 1 for a factor]: the
    /// change at a reading where the profile of the shape equals 1.
    double change = 0;
    double standard_error = 0;  ///< standard error of `change` [unit of `change`]
};

/// Proposal for a misfit that no known effect explains: one or two changes of unknown cause which,
/// added to the model, explain the misfit or at least half of the misfit.
struct Proposal {
    /// The one or two changes of unknown cause that are proposed, fitted to the readings.
    std::vector<FittedShape> shapes;
    /// Other changes of unknown cause that would change the readings in nearly the same way as the
    /// single proposed change, estimated in the linear approximation. The member `effect` of each
    /// element is empty. The list is empty if two changes are proposed.
    std::vector<FittedShape> alike;
    /// Study's model with the proposed changes added and refitted to the readings, with its chi2
    /// and its tests. The indices in the member `chosen` have no meaning outside of `propose`.
    Explanation explanation;
    /// p value [1]: probability that the best of all single changes that were tried reduces chi2 by
    /// chance at least as much as the proposed change, if the model lacks nothing. For two changes,
    /// the p value of the less important change when it is added to the more important one.
    double p = 1;
    /// Share [1] of the excess chi2 - dof (chi2 minus degrees of freedom) of the study's model that
    /// the proposed changes remove.
    double explained = 0;
    /// Penalty [1] to be added to chi2, since the proposed changes were chosen among many changes.
    double penalty = 0;

    /// Returns the penalised chi2 [1]: chi2 of the refitted model plus the member `penalty` for the
    /// choice among many changes. The proposal with the lowest value is best.
    double penalised_chi2() const { return explanation.chi2 + penalty; }

    /// Whether the model with the proposed changes fits the readings: neither lack of fit nor a
    /// further effect is significant.
    bool fits() const { return explanation.accepted; }
};

/// Searches for changes of unknown cause that would explain a misfit that no known effect explains.
/// The search combines each quantity that a formula can set with each profile (dependence of the
/// size of the change on a quantity of the readings). The score of a combination is a linear
/// estimate of the reduction of chi2, minus a penalty for the choice,
///     score = (g'Pr)^2/(g'Pg) - 2 ln(number of profiles of the kind),
/// with the residuals r and the change g of the readings, both in units of the readings' errors,
/// and the projection P (`WeightedResiduals`). The model is refitted with the best combinations and
/// tested for lack of fit and for further effects. Pairs of combinations are tried if no single
/// combination fits.
///
/// Returns the best proposals that fit, the lowest Proposal::penalised_chi2() first. If no proposal
/// fits, returns the best proposal if it removes at least half of the excess chi2 - dof (chi2 minus
/// degrees of freedom) of the study's model, else nothing.
/// @param evidence readings with their errors and with parts of the measurement that may be wrong
/// @param diagnosis diagnosis of the study's model, which does not fit
std::vector<Proposal> propose(const ResolvedStudy& study, const StudyModels& models,
                              const Evidence& evidence, const std::vector<Reading>& readings,
                              const Diagnosis& diagnosis, const DiagnosisOptions& options);

}  // namespace pendular
