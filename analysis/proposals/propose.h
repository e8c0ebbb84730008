#pragma once

#include <cstddef>
#include <vector>

#include "analysis/diagnosis/diagnosis.h"
#include "analysis/proposals/shape.h"
#include "calib/model/study_models.h"

namespace pendular {

/// Change of the model's predictions by an unknown cause, of a shape that was fitted to the
/// readings.
struct FittedShape {
    ShapeOfChange shape;
    WrittenEffect effect;       ///< the change as an effect that study.toml can define
    double change = 0;          ///< fitted change where the size of its profile is 1 [its unit]
    double standard_error = 0;  ///< standard error of `change` [its unit]
};

/// Proposal where no known effect explains a misfit: one or two changes of unknown cause that, in
/// the model, explain the readings or most of the misfit.
struct Proposal {
    std::vector<FittedShape> shapes;
    /// Changes of other quantities, with estimates in the linear approximation, that would change
    /// the readings in nearly the same way as the single shape in `shapes`; empty if there are two.
    std::vector<FittedShape> alike;
    Explanation explanation;  ///< refitted model; `chosen` is without meaning here
    /// Probability that the best of all shapes that were tried would reduce chi2 as much by chance,
    /// if nothing were missing [1].
    double p = 1;
    double explained = 0;  ///< share of the excess chi2 - dof that the shapes remove [1]
    double price = 0;      ///< price of the choice of the shapes, to be added to chi2 [1]

    /// Score by which proposals are compared, the lower the better [1]: chi2 plus `price`.
    double description() const { return explanation.chi2 + price; }

    /// Whether the model with the shapes describes the readings: neither lack of fit nor a further
    /// effect is significant.
    bool fits() const { return explanation.accepted; }
};

/// Searches for the change of a quantity that would explain a misfit that no known effect explains.
/// Every quantity that a formula can set is varied along every quantity of the readings, by every
/// profile; the linear estimate scores all of these shapes,
///     chi2 reduction (g'Pr)^2/(g'Pg) - 2 ln(number of profiles of the kind),
/// with whitened residuals r, change g and projection P (`WeightedResiduals`), and the best shapes
/// are refitted and tested like other explanations, with the known effects and each other as
/// further effects. Pairs of shapes are tried where no single shape fits. Returns at most three
/// proposals that fit, the shortest description first. Where none fits, returns the one with the
/// shortest description if it removes at least half of the misfit.
/// @param diagnosis diagnosis of the study's model, which does not fit
std::vector<Proposal> propose(const ResolvedStudy& study, const StudyModels& models,
                              const Evidence& evidence, const std::vector<Reading>& readings,
                              const Diagnosis& diagnosis, const DiagnosisOptions& options);

}  // namespace pendular
