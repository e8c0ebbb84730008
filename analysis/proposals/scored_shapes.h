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

/// Changes of unknown cause, scored by linear estimates on the residuals of one fit. A change is
/// described by a shape, which states which quantity changes and how the change varies between
/// readings.
class ScoredShapes {
  public:
    /// Score of one shape (change of unknown cause), or of two shapes together.
    struct Score {
        /// Indices of the one or two scored shapes (changes of unknown cause), as arguments of the
        /// function `shape`.
        std::vector<std::size_t> shapes;
        /// Predicted reduction of chi2 [1] when the one or two changes are added to the model.
        double reduction = 0;
        /// Penalty [1] to be added to chi2, since the changes were chosen among many changes. For
        /// two changes, the penalty includes 2 for the second fitted amplitude.
        double penalty = 0;
        /// Estimated amplitude of each shape (change of unknown cause) in `shapes`, in the unit of
        /// the change.
        std::vector<double> changes;
        /// Indices of shapes (changes of unknown cause) of other quantities that change the
        /// readings in nearly the same way as the scored shape, and whose scores are similar. The
        /// function `unlike` fills the list. Empty if the score is of two shapes.
        std::vector<std::size_t> alike;
    };

    /// Scores all shapes (changes of unknown cause) that a study's quantities and readings allow.
    /// @param models models of the study
    /// @param base fit of the study's model without further effects
    /// @param explanations tests of the study's model, whose random draws give p values
    /// @param threads largest number of threads for the random draws
    ScoredShapes(const ResolvedStudy& study, const StudyModels& models,
                 const std::vector<Reading>& readings, const Explanation& base,
                 const Explanations& explanations, std::size_t threads);

    const ShapeOfChange& shape(std::size_t index) const { return shapes_[index]; }
    /// Returns the scores of all single shapes (changes of unknown cause), in decreasing order of
    /// `reduction` minus `penalty`.
    std::vector<Score> singles() const;
    /// Returns the scores of pairs of shapes (changes of unknown cause), in decreasing order of
    /// `reduction` minus `penalty`. Each pair contains one of the up to `most` best shapes, which
    /// `unlike` selects, and any other shape.
    std::vector<Score> pairs(std::size_t most) const;
    /// Selects, in the order of `scores`, up to `count` scores with a positive `reduction` whose
    /// shapes change the readings in different ways. A score is left out if its shapes change the
    /// readings in nearly the same way as the shapes of a selected score. `Score::alike` of the
    /// selected score may then name the shape that was left out.
    std::vector<Score> unlike(const std::vector<Score>& scores, std::size_t count) const;
    /// Returns the estimated amplitude of the shape (change of unknown cause) with index `index`,
    /// and the standard error of the amplitude, in the unit of the quantity that the shape changes.
    std::pair<double, double> estimate(std::size_t index) const;
    /// Returns the p value [1] of one or two changes: probability that the best of all single
    /// changes reduces chi2 at least as much if the model lacks nothing, in a linear estimate. For
    /// two changes, the result is the p value of the less important change when it is added to the
    /// other change.
    double p(const Score& score) const;

  private:
    /// Quantity that may change, with the change of the readings per unit of the quantity's change.
    struct Changeable {
        ChangedQuantity quantity;
        /// Change of each measured value [its unit] per unit of the quantity's change.
        Eigen::VectorXd response;
        std::vector<ReadingCoordinate> coordinates;
    };

    void add(std::size_t changeable, Profile profile);
    void add_profiles(std::size_t changeable);
    /// For each of the oscillations with the best scores, adds oscillations with slightly different
    /// periods and phases.
    void refine();
    /// Computes the direction and the length of the change of the readings by each shape (change of
    /// unknown cause) from index `first` on, in units of the readings' errors (whitened). Also
    /// computes the component of the residuals along each direction.
    void project_from(std::size_t first);
    void draw(const NullDraws& draws, std::size_t threads);
    Score score_of(std::size_t index) const;
    /// Returns the score of two shapes (changes of unknown cause) together. Empty if both shapes
    /// change the readings in nearly the same way, if the calibrated parameters imitate one of the
    /// changes, or if an estimated change exceeds its bounds.
    std::optional<Score> score_of(std::size_t one, std::size_t other) const;
    /// Returns, as a unit vector, the direction in which the shapes of a score change the readings
    /// at their estimated changes, in units of the readings' errors (whitened).
    Eigen::VectorXd change_by(const Score& score) const;
    /// Adds the single shape (change of unknown cause) of `other` to `alike` of `chosen` if the
    /// scores are similar and if neither `chosen` nor its `alike` contains a shape that changes the
    /// quantity of `other`.
    void add_alike(Score& chosen, const Score& other) const;

    WeightedResiduals residuals_;
    std::vector<Changeable> changeables_;
    std::vector<ShapeOfChange> shapes_;
    /// Quantity that each shape (change of unknown cause) changes, as index into `changeables_`.
    std::vector<std::size_t> changed_by_;
    /// Directions in which the shapes (changes of unknown cause) change the readings: a column for
    /// each shape. The column is the unit vector P g/|P g|, with the change g of the readings in
    /// units of their errors (whitened) and the projection P of `WeightedResiduals`. The column is
    /// zero if the calibrated parameters imitate the change.
    Eigen::MatrixXd directions_;
    /// Length |P g| of the change of the readings by each shape (change of unknown cause) [1/unit
    /// of the shape's change]. g is the change in units of the readings' errors (whitened), and P
    /// the projection of `WeightedResiduals`.
    Eigen::VectorXd lengths_;
    /// Component of the whitened residuals along the direction in which each shape (change of
    /// unknown cause) changes the readings [1].
    Eigen::VectorXd along_;
    /// Largest reduction of chi2 by any shape (change of unknown cause) in each random draw of
    /// errors [1].
    Eigen::VectorXd drawn_;
};

}  // namespace pendular
