#include "analysis/proposals/scored_shapes.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <utility>

#include "analysis/diagnosis/side_by_side.h"
#include "sim/catalogue/written_effect.h"

namespace pendular {
namespace {

/// Smallest cosine between the changes of the readings by two shapes at which the shapes count as
/// alike [1]: one gives 99 % of the reduction of chi2 by the other.
constexpr double alike = 0.995;
/// Smallest cosine between two shapes at which they are not tried as a pair [1]: their amplitudes
/// would have 25 times the variances of single ones.
constexpr double nearly_parallel = 0.98;
/// Smallest share of the length of a change that must remain after the calibrated parameters
/// imitate it [1]; a smaller remainder is rounding error.
constexpr double least_left = 1e-3;
/// Largest amount by which the penalised chi2 with a shape that counts as alike may be higher [1].
constexpr double largest_difference_alike = 4;
/// Number of oscillations, the best of all, whose period and phase are refined. Chosen: each takes
/// 17 x 16 further shapes.
constexpr std::size_t most_refined = 3;
/// Number of shapes whose random draws are computed at once.
constexpr Eigen::Index drawn_at_once = 256;

void put_lowest_first(std::vector<ScoredShapes::Score>& scores) {
    std::ranges::stable_sort(scores, std::greater<>(), [](const ScoredShapes::Score& score) {
        return score.reduction - score.penalty;
    });
}

/// Whether oscillations of a quantity are tried: only for quantities that the (rotating) instrument
/// shows.
bool may_oscillate(const ChangedQuantity& quantity) {
    return quantity.relative && quantity.kind() != WrittenEffect::Kind::condition;
}

}  // namespace

ScoredShapes::ScoredShapes(const ResolvedStudy& study, const StudyModelSpace& models,
                           const std::vector<Reading>& readings, const FittedModel& base,
                           const Explanations& explanations, std::size_t threads)
    : residuals_(explanations.residuals_of(base)) {
    const auto quantities = quantities_that_may_change(study, readings);
    std::vector<Effect> uniform;
    for (const ChangedQuantity& quantity : quantities) {
        const ShapeOfChange shape{quantity, same_everywhere(readings.size())};
        uniform.push_back(effect_from(shape.written(shape.name())));
    }
    const StudyModelSpace offering = models.offering(uniform);
    for (std::size_t q = 0; q < quantities.size(); ++q) {
        const Addition addition(offering, {}, models.candidates().size() + q, base.fit.parameters,
                                base.fit.prediction.value);
        const Eigen::MatrixXd change = addition.signature(false).change;
        if (!change.allFinite()) continue;
        const bool of_instrument = quantities[q].kind() == WrittenEffect::Kind::instrument;
        changeables_.push_back({quantities[q], change.col(0) / quantities[q].smallest,
                                coordinates_of(readings, study, of_instrument)});
        add(changeables_.size() - 1, same_everywhere(readings.size()));
        add_profiles(changeables_.size() - 1);
    }
    project_from(0);
    refine();
    draw(explanations.draws(), threads);
}

void ScoredShapes::add(std::size_t changeable, Profile profile) {
    shapes_.push_back({changeables_[changeable].quantity, std::move(profile)});
    changed_by_.push_back(changeable);
}

void ScoredShapes::add_profiles(std::size_t changeable) {
    const bool oscillations = may_oscillate(changeables_[changeable].quantity);
    for (const ReadingCoordinate& coordinate : changeables_[changeable].coordinates) {
        for (Profile& profile : profiles_along(coordinate, oscillations)) {
            add(changeable, std::move(profile));
        }
    }
}

void ScoredShapes::refine() {
    std::vector<std::size_t> best;
    for (const Score& score : singles()) {
        const std::size_t k = score.shapes.front();
        if (shapes_[k].profile.dependence == Dependence::oscillation && best.size() < most_refined)
            best.push_back(k);
    }
    const std::size_t before = shapes_.size();
    for (const std::size_t k : best) {
        const std::size_t changeable = changed_by_[k];
        const auto& coordinates = changeables_[changeable].coordinates;
        const auto coordinate = std::ranges::find(coordinates, shapes_[k].profile.variable,
                                                  &ReadingCoordinate::variable);
        for (Profile& finer : finer_profiles(shapes_[k].profile, *coordinate)) {
            add(changeable, std::move(finer));
        }
    }
    project_from(before);
}

void ScoredShapes::project_from(std::size_t first) {
    const auto begin = static_cast<Eigen::Index>(first);
    const auto more = static_cast<Eigen::Index>(shapes_.size()) - begin;
    Eigen::MatrixXd columns(residuals_.size(), more);
    for (Eigen::Index k = 0; k < more; ++k) {
        const std::size_t shape = first + static_cast<std::size_t>(k);
        columns.col(k) = changeables_[changed_by_[shape]].response;
        const Eigen::VectorXd& at = shapes_[shape].profile.at;
        for (Eigen::Index reading = 0; reading < at.size(); ++reading) {
            columns.col(k).segment<2>(2 * reading) *= at(reading);
        }
        columns.col(k).tail(residuals_.size() - 2 * at.size()).setZero();  // direct measurements
    }
    const ColumnScores scores = score_columns(residuals_, columns, least_left);
    scores_.directions.conservativeResize(residuals_.size(), begin + more);
    scores_.directions.rightCols(more) = scores.directions;
    scores_.lengths.conservativeResize(begin + more);
    scores_.lengths.tail(more) = scores.lengths;
    scores_.along.conservativeResize(begin + more);
    scores_.along.tail(more) = scores.along;
}

void ScoredShapes::draw(const NullDraws& draws, std::size_t threads) {
    const auto parts =
        static_cast<std::size_t>((scores_.directions.cols() + drawn_at_once - 1) / drawn_at_once);
    Eigen::MatrixXd largest(draws.count(), static_cast<Eigen::Index>(parts));
    side_by_side(parts, threads, {}, [&](std::size_t part) {
        const Eigen::Index from = static_cast<Eigen::Index>(part) * drawn_at_once,
                           count = std::min(drawn_at_once, scores_.directions.cols() - from);
        const Eigen::MatrixXd along =
            draws.along(residuals_, scores_.directions.middleCols(from, count));
        largest.col(static_cast<Eigen::Index>(part)) =
            along.cwiseAbs2().colwise().maxCoeff().transpose();
    });
    drawn_ = largest.rowwise().maxCoeff();
}

double ScoredShapes::p(const Score& score) const {
    double least = score.reduction;
    if (score.shapes.size() == 2) {
        for (const std::size_t other : score.shapes) {
            least = std::min(least, score.reduction - score_of(other).reduction);
        }
    }
    return NullDraws::p(least, drawn_);
}

ScoredShapes::Score ScoredShapes::score_of(std::size_t index) const {
    const auto k = static_cast<Eigen::Index>(index);
    const ChangedQuantity& quantity = shapes_[index].quantity;
    Score score{.shapes = {index}, .penalty = shapes_[index].profile.penalty, .changes = {0}};
    if (scores_.lengths(k) == 0) return score;
    const double change =
        std::clamp(scores_.along(k) / scores_.lengths(k), quantity.lower, quantity.upper);
    const double component = change * scores_.lengths(k);
    score.reduction = component * (2 * scores_.along(k) - component);
    score.changes = {change};
    return score;
}

std::optional<ScoredShapes::Score> ScoredShapes::score_of(std::size_t one,
                                                          std::size_t other) const {
    const auto i = static_cast<Eigen::Index>(one), j = static_cast<Eigen::Index>(other);
    if (scores_.lengths(i) == 0 || scores_.lengths(j) == 0) return {};
    const double cosine = scores_.directions.col(i).dot(scores_.directions.col(j));
    if (std::abs(cosine) > nearly_parallel) return {};
    const double share = 1 - cosine * cosine;
    const double a = (scores_.along(i) - cosine * scores_.along(j)) / share,
                 b = (scores_.along(j) - cosine * scores_.along(i)) / share;
    Score score{.shapes = {one, other},
                .reduction = a * scores_.along(i) + b * scores_.along(j),
                .penalty = shapes_[one].profile.penalty + shapes_[other].profile.penalty + 2,
                .changes = {a / scores_.lengths(i), b / scores_.lengths(j)}};
    for (std::size_t k = 0; k < 2; ++k) {
        const ChangedQuantity& quantity = shapes_[score.shapes[k]].quantity;
        if (score.changes[k] < quantity.lower || score.changes[k] > quantity.upper) return {};
    }
    return score;
}

std::vector<ScoredShapes::Score> ScoredShapes::singles() const {
    std::vector<Score> scores;
    for (std::size_t k = 0; k < shapes_.size(); ++k) {
        scores.push_back(score_of(k));
    }
    put_lowest_first(scores);
    return scores;
}

std::vector<ScoredShapes::Score> ScoredShapes::pairs(std::size_t most) const {
    const std::vector<Score> firsts = unlike(singles(), most);
    std::vector<Score> scores;
    for (const Score& first : firsts) {
        for (std::size_t other = 0; other < shapes_.size(); ++other) {
            if (auto score = score_of(first.shapes.front(), other)) {
                scores.push_back(std::move(*score));
            }
        }
    }
    put_lowest_first(scores);
    return scores;
}

Eigen::VectorXd ScoredShapes::change_by(const Score& score) const {
    Eigen::VectorXd change = Eigen::VectorXd::Zero(residuals_.size());
    for (std::size_t k = 0; k < score.shapes.size(); ++k) {
        const auto shape = static_cast<Eigen::Index>(score.shapes[k]);
        change += score.changes[k] * scores_.lengths(shape) * scores_.directions.col(shape);
    }
    return change.normalized();
}

void ScoredShapes::add_alike(Score& chosen, const Score& other) const {
    if (chosen.shapes.size() != 1 || other.shapes.size() != 1 ||
        chosen.reduction - chosen.penalty >
            other.reduction - other.penalty + largest_difference_alike) {
        return;
    }
    const auto target = [&](std::size_t k) { return shapes_[k].quantity.target; };
    const std::string& named = target(other.shapes.front());
    if (named != target(chosen.shapes.front()) &&
        std::ranges::find(chosen.alike, named, target) == chosen.alike.end()) {
        chosen.alike.push_back(other.shapes.front());
    }
}

std::vector<ScoredShapes::Score> ScoredShapes::unlike(const std::vector<Score>& scores,
                                                      std::size_t count) const {
    std::vector<Score> chosen;
    std::vector<Eigen::VectorXd> changes;
    for (const Score& score : scores) {
        if (score.reduction <= 0) break;
        const Eigen::VectorXd change = change_by(score);
        const auto same = std::ranges::find_if(changes, [&](const Eigen::VectorXd& other) {
            return std::abs(change.dot(other)) > alike;
        });
        if (same != changes.end()) {
            add_alike(chosen[static_cast<std::size_t>(same - changes.begin())], score);
        } else if (chosen.size() < count) {
            changes.push_back(change);
            chosen.push_back(score);
        }
    }
    return chosen;
}

std::pair<double, double> ScoredShapes::estimate(std::size_t index) const {
    return {score_of(index).changes.front(), 1 / scores_.lengths(static_cast<Eigen::Index>(index))};
}

}  // namespace pendular
