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

/// Changes of unknown cause (shapes), scored by their linear estimates on the residuals of one fit.
class ScoredShapes {
  public:
    /// Score of one shape, or of two together.
    struct Score {
        /// Indices of the one or two shapes (changes of unknown cause) that are scored.
        std::vector<std::size_t> shapes;
        /// Predicted reduction of chi2 when these shapes are added to the model [1].
        double reduction = 0;
        /// Penalty to be added to chi2 because these shapes were chosen among many [1].
        double price = 0;
        /// Estimated change of the quantity of each shape, in the unit of the change.
        std::vector<double> changes;
        /// Single shapes of other quantities that change the readings in nearly the same way, at a
        /// similar score; set by `unlike`.
        std::vector<std::size_t> alike;
    };

    /// Scores all shapes that a study's quantities and readings allow.
    /// @param models models of the study
    /// @param base fit of the study's model without further effects
    /// @param explanations tests of that model, whose random draws give p values
    /// @param threads largest number of threads for the random draws
    ScoredShapes(const ResolvedStudy& study, const StudyModels& models,
                 const std::vector<Reading>& readings, const Explanation& base,
                 const Explanations& explanations, std::size_t threads);

    const ShapeOfChange& shape(std::size_t index) const { return shapes_[index]; }
    /// Returns the scores of all single shapes, in decreasing `reduction` minus `price`.
    std::vector<Score> singles() const;
    /// Returns the scores of pairs of shapes, each of the `most` best shapes with every shape, in
    /// decreasing `reduction` minus `price`.
    std::vector<Score> pairs(std::size_t most) const;
    /// Returns the first `count` of `scores` such that no two of them change the readings in nearly
    /// the same way. A score left out is noted in `Score::alike` of the score that it resembles.
    std::vector<Score> unlike(const std::vector<Score>& scores, std::size_t count) const;
    /// Returns the estimated change of the shape with index `index` and its standard error, in the
    /// unit of the change.
    std::pair<double, double> estimate(std::size_t index) const;
    /// p value [1]: probability that the best of all shapes reduces chi2 by at least `reduction` if
    /// nothing is missing, in a linear estimate.
    double p(double reduction) const;

  private:
    /// Quantity that may change, with the change of the readings per unit of the quantity's change.
    struct Changeable {
        ChangedQuantity quantity;
        /// Change of each entry of the readings per unit of the quantity's change.
        Eigen::VectorXd response;
        std::vector<ReadingCoordinate> coordinates;
    };

    void add(std::size_t changeable, Profile profile);
    void add_profiles(std::size_t changeable);
    /// Adds oscillations with periods and phases near those of the best ones.
    void refine();
    /// Computes the whitened directions and lengths of the shapes from index `first` on, and the
    /// components of the residuals along them.
    void project_from(std::size_t first);
    void draw(const NullDraws& draws, std::size_t threads);
    Score score_of(std::size_t index) const;
    /// Returns the score of two shapes together; empty where they are nearly parallel, or where a
    /// change would leave its bounds.
    std::optional<Score> score_of(std::size_t one, std::size_t other) const;
    /// Returns the change of the readings, in units of their errors (whitened), by a score's shapes
    /// at the estimated changes, scaled to length 1.
    Eigen::VectorXd change_by(const Score& score) const;
    /// Adds the single shape of `other` to `alike` of `chosen`, unless its quantity is there
    /// already.
    void add_alike(Score& chosen, const Score& other) const;

    WeightedResiduals residuals_;
    std::vector<Changeable> changeables_;
    std::vector<ShapeOfChange> shapes_;
    /// For each shape, the quantity that it changes, as index into `changeables_`.
    std::vector<std::size_t> changed_by_;
    /// A unit vector for each shape (an assumed form of the missing change), as a column: the
    /// direction in which the shape changes the readings, P g/|P g|, with the whitened change g and
    /// the projection P of `WeightedResiduals`.
    Eigen::MatrixXd directions_;
    /// Length |P g| of the whitened change of the readings by each shape [1/unit of its change].
    Eigen::VectorXd lengths_;
    /// Component of the whitened residuals along the direction of each shape [1].
    Eigen::VectorXd along_;
    /// Largest reduction of chi2 by any shape, in each random draw of errors [1].
    Eigen::VectorXd drawn_;
};

}  // namespace pendular
