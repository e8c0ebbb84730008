#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

#include "analysis/diagnosis/explanations.h"
#include "analysis/proposals/shape.h"
#include "calib/model/study_models.h"

namespace pendular {

/// Changes of unknown cause (shapes: which quantity changes, and how the change varies between
/// readings), scored by linear estimates on the residuals of one fit.
class ScoredShapes {
  public:
    /// Score of one change of unknown cause (shape), or of two together.
    struct Score {
        /// Indices of the one or two shapes (changes of unknown cause) that are scored.
        std::vector<std::size_t> shapes;
        /// Predicted reduction of chi2 when the one or two changes are added to the model [1].
        double reduction = 0;
        /// Penalty to be added to chi2, since the changes were chosen among many [1]. For two
        /// changes it contains 2 for the additional fitted number.
        double price = 0;
        /// Estimated change of the quantity of each shape (change of unknown cause), in the unit of
        /// the change.
        std::vector<double> changes;
        /// Single changes of other quantities that change the readings in nearly the same way, at a
        /// similar score, as indices; set by `unlike`.
        std::vector<std::size_t> alike;
    };

    /// Scores all changes of unknown cause (shapes) that a study's quantities and readings allow.
    /// @param models models of the study
    /// @param base fit of the study's model without further effects
    /// @param explanations tests of that model, whose random draws give p values
    /// @param threads largest number of threads for the random draws
    ScoredShapes(const ResolvedStudy& study, const StudyModels& models,
                 const std::vector<Reading>& readings, const Explanation& base,
                 const Explanations& explanations, std::size_t threads);

    const ShapeOfChange& shape(std::size_t index) const { return shapes_[index]; }
    /// Returns the scores of all single shapes (changes of unknown cause), in decreasing order of
    /// `reduction` minus `price`.
    std::vector<Score> singles() const;
    /// Returns the scores of pairs of shapes (changes of unknown cause): each of the `most` best
    /// shapes with every shape, in decreasing order of `reduction` minus `price`.
    std::vector<Score> pairs(std::size_t most) const;
    /// Selects, in the order of `scores`, up to `count` scores no two of which change the readings
    /// in nearly the same way. A score left out for this reason is noted in `Score::alike` of the
    /// score that it resembles.
    std::vector<Score> unlike(const std::vector<Score>& scores, std::size_t count) const;
    /// Returns the estimated change and its standard error, in the unit of the change, of the shape
    /// (change of unknown cause) with index `index`.
    std::pair<double, double> estimate(std::size_t index) const;
    /// p value [1]: probability that the best of all shapes (changes of unknown cause) reduces chi2
    /// by at least `reduction` if the model lacks nothing, in a linear estimate.
    double p(double reduction) const;

  private:
    /// Quantity that may change, with the change of the readings per unit of the quantity's change.
    struct Changeable {
        ChangedQuantity quantity;
        /// Change of each measured value per unit of the quantity's change.
        Eigen::VectorXd response;
        std::vector<ReadingCoordinate> coordinates;
    };

    void add(std::size_t changeable, Profile profile);
    void add_profiles(std::size_t changeable);
    /// Adds oscillations with periods and phases near those of the oscillations with the best
    /// scores.
    void refine();
    /// Computes, for the shapes (changes of unknown cause) from index `first` on, the direction and
    /// length of the change of the readings that each makes, in units of their errors (whitened).
    /// Also computes the component of the residuals along each direction.
    void project_from(std::size_t first);
    void draw(const NullDraws& draws, std::size_t threads);
    Score score_of(std::size_t index) const;
    /// Returns the score of two shapes (changes of unknown cause) together. Empty if the two change
    /// the readings in nearly the same way, or if an estimated change exceeds its bounds.
    std::optional<Score> score_of(std::size_t one, std::size_t other) const;
    /// Returns the direction in which the shapes of a score change the readings at their estimated
    /// changes, in units of the readings' errors (whitened): a unit vector.
    Eigen::VectorXd change_by(const Score& score) const;
    /// Adds the single shape (change of unknown cause) of `other` to `alike` of `chosen`, if its
    /// score is similar and `alike` has no shape of the same quantity.
    void add_alike(Score& chosen, const Score& other) const;

    WeightedResiduals residuals_;
    std::vector<Changeable> changeables_;
    std::vector<ShapeOfChange> shapes_;
    /// For each shape, the quantity that it changes, as index into `changeables_`.
    std::vector<std::size_t> changed_by_;
    /// For each shape (change of unknown cause), the direction in which it changes the readings, as
    /// a column of length 1 or, if the calibrated parameters imitate the change, 0. The direction
    /// is P g/|P g|, with the whitened change g of the readings and the projection P of
    /// `WeightedResiduals`.
    Eigen::MatrixXd directions_;
    /// For each shape (change of unknown cause), the length |P g| of the change of the readings
    /// that it makes [1/unit of the shape's change]. g: change in units of the readings' errors
    /// (whitened); P: projection of `WeightedResiduals`.
    Eigen::VectorXd lengths_;
    /// For each shape (change of unknown cause), the component of the whitened residuals along the
    /// direction in which the shape changes the readings [1].
    Eigen::VectorXd along_;
    /// Largest reduction of chi2 by any shape (change of unknown cause), for each random draw of
    /// errors [1].
    Eigen::VectorXd drawn_;
};

}  // namespace pendular
