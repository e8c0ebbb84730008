#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

#include "analysis/diagnosis/explanations.h"
#include "analysis/proposals/shape.h"
#include "calib/model/study_model_space.h"

namespace pendular {

/// Shapes of changes of unknown cause, scored by linear estimates on the residuals of one fit:
/// thousands of shapes need only one derivative of the predictions for each quantity.
class ScoredShapes {
  public:
    /// Score of one shape, or of two shapes together.
    struct Score {
        std::vector<std::size_t> shapes;  ///< one or two indices
        double reduction = 0;             ///< predicted for chi2 [1]
        double penalty = 0;  ///< for the choice and, of two shapes, 2 for the second amplitude [1]
        std::vector<double> changes;  ///< estimated amplitude of each shape [unit of its change]
        /// Shapes of other quantities that change the readings in nearly the same way as a single
        /// shape and score about as well (`unlike`).
        std::vector<std::size_t> alike;
    };

    /// Scores all shapes that a study's quantities and readings allow.
    /// @param base fit of the study's model without further effects
    /// @param explanations tests of the study's model, whose random draws give p values
    /// @param threads largest number of threads for the random draws
    ScoredShapes(const ResolvedStudy& study, const StudyModelSpace& models,
                 const std::vector<Reading>& readings, const FittedModel& base,
                 const Explanations& explanations, std::size_t threads);

    const ShapeOfChange& shape(std::size_t index) const { return shapes_[index]; }
    /// Returns the scores of single shapes in decreasing order of `reduction` minus `penalty`.
    std::vector<Score> singles() const;
    /// Returns the scores of pairs in the same order. One shape of each is among the up to `most`
    /// best that `unlike` selects.
    std::vector<Score> pairs(std::size_t most) const;
    /// Returns, in the order of `scores`, up to `count` with a positive `reduction` that change the
    /// readings in different ways. A shape that is left out may be `alike` to the selected one.
    std::vector<Score> unlike(const std::vector<Score>& scores, std::size_t count) const;
    /// Returns the estimated amplitude of a shape and its standard error [unit of its change].
    std::pair<double, double> estimate(std::size_t index) const;
    /// Returns the p value [1]: probability, if the model lacks nothing, that the best of all
    /// single changes reduces chi2 as much, in a linear estimate. Of two changes, that of the less
    /// important one beside the other.
    double p(const Score& score) const;

  private:
    struct Changeable {
        ChangedQuantity quantity;
        Eigen::VectorXd response;  ///< change of each measured value [its unit] per unit of it
        std::vector<ReadingCoordinate> coordinates;
    };

    void add(std::size_t changeable, Profile profile);
    void add_profiles(std::size_t changeable);
    /// Adds oscillations with slightly different periods and phases to the best ones.
    void refine();
    /// Computes `scores_` of the shapes from index `first` on.
    void project_from(std::size_t first);
    void draw(const NullDraws& draws, std::size_t threads);
    Score score_of(std::size_t index) const;
    /// Empty if both shapes change the readings in nearly the same way, if the calibrated
    /// parameters imitate one of the changes, or if an estimated change exceeds its bounds.
    std::optional<Score> score_of(std::size_t one, std::size_t other) const;
    /// Unit vector of the whitened change of the readings by the estimated changes.
    Eigen::VectorXd change_by(const Score& score) const;
    /// Adds the single shape of `other` to `alike` of `chosen` if the scores are similar and the
    /// quantity of `other` is not there yet.
    void add_alike(Score& chosen, const Score& other) const;

    WeightedResiduals residuals_;
    std::vector<Changeable> changeables_;
    std::vector<ShapeOfChange> shapes_;
    std::vector<std::size_t> changed_by_;  ///< index into `changeables_` for each shape
    ColumnScores scores_;                  ///< of each shape, without `imitated`
    Eigen::VectorXd drawn_;  ///< largest reduction of chi2 by any shape in each draw [1]
};

}  // namespace pendular
