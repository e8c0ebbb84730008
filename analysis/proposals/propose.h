#pragma once

#include <cstddef>
#include <vector>

#include "analysis/diagnosis/diagnosis.h"
#include "analysis/proposals/shape.h"
#include "calib/model/study_model_space.h"

namespace pendular {

/// Change of the model's predictions by an unknown cause, fitted to the readings.
struct FittedShape {
    ShapeOfChange shape;
    WrittenEffect effect;  ///< by formulas, for study.toml
    double change = 0;     ///< where the profile has the size 1 [unit of the quantity; factor: 1]
    double standard_error = 0;  ///< [unit of `change`]
};

/// One or two changes of unknown cause that explain a misfit which no known effect explains as
/// well, or at least half of it.
struct Proposal {
    std::vector<FittedShape> shapes;
    /// Changes that would change the readings in nearly the same way as a single proposed one, by
    /// linear estimates, without an `effect`.
    std::vector<FittedShape> alike;
    /// Study's model with the changes added, refitted and tested. The indices in `chosen` have no
    /// meaning outside of `propose`.
    FittedModel model;
    /// p value [1]: probability, if the model lacks nothing, that the best of all single changes
    /// that were tried reduces chi2 as much. Of two changes, that of the less important one beside
    /// the other.
    double p = 1;
    double explained = 0;  ///< share of the excess chi2 - dof that the changes remove [1]
    double penalty = 0;    ///< for the choice among many changes, added to chi2 [1]

    /// Returns chi2 plus `penalty` [1], which is lowest for the best proposal.
    double penalised_chi2() const { return model.fit.chi2 + penalty; }

    /// Whether neither lack of fit nor a further effect of the model is significant.
    bool fits() const { return model.accepted; }
};

/// Searches for changes of unknown cause that explain a misfit. Each quantity that a formula can
/// set is combined with each profile. The score of a combination is a linear estimate of the
/// reduction of chi2, minus a penalty for the choice,
///     score = (g'Pr)^2/(g'Pg) - 2 ln(number of profiles of the kind),
/// with the whitened residuals r and change g of the readings and the projection P
/// (`WeightedResiduals`). The model is refitted with the best combinations and tested like other
/// explanations; pairs of combinations are tried if no single one fits.
///
/// Returns the best proposals that fit, the lowest Proposal::penalised_chi2() first. If none fits,
/// returns the best one if it removes at least half of the excess chi2 - dof, else nothing. Returns
/// nothing where models with known effects fit and no single combination, by its score, comes near
/// to being clearly better (ranking.h).
/// @param diagnosis that of the study's model, which does not fit
std::vector<Proposal> propose(const ResolvedStudy& study, const StudyModelSpace& models,
                              const Evidence& evidence, const std::vector<Reading>& readings,
                              const Diagnosis& diagnosis, const DiagnosisOptions& options);

}  // namespace pendular
