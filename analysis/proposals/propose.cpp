#include "analysis/proposals/propose.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <set>
#include <stdexcept>
#include <utility>

#include "analysis/diagnosis/ranking.h"
#include "analysis/diagnosis/side_by_side.h"
#include "analysis/proposals/scored_shapes.h"
#include "sim/catalogue/written_effect.h"

namespace pendular {
namespace {

/// Number of single shapes, and of pairs, that are refitted. Chosen: they are ranked by scores,
/// and a refit takes far longer than a score.
constexpr std::size_t most_singles = 8, most_pairs = 6;
/// Number of shapes with each of which all others are tried as a pair.
constexpr std::size_t most_firsts = 40;
constexpr std::size_t most_proposals = 3;  // chosen: the user has to check each by a measurement
/// Smallest share of the excess chi2 that a shape must remove to be proposed although a misfit
/// remains [1].
constexpr double most_of_it = 0.5;

using Score = ScoredShapes::Score;

/// Whether a fitted change is within two standard errors of no change.
bool needless(const FittedShape& fitted) {
    return std::abs(fitted.change) < 2 * fitted.standard_error;
}

class ShapeSearch {
  public:
    ShapeSearch(const ResolvedStudy& study, const StudyModelSpace& models, const Evidence& evidence,
                const std::vector<Reading>& readings, const Diagnosis& diagnosis,
                const DiagnosisOptions& options)
        : models_(models),
          explanations_(models, evidence, options),
          diagnosis_(diagnosis),
          options_(options),
          scored_(study, models, readings, diagnosis.base, explanations_, options.threads) {
        for (const Effect& effect : study.catalogue().all()) {
            taken_.insert(effect.name);
        }
    }

    std::vector<Proposal> run() {
        const std::vector<Score> singles = scored_.unlike(scored_.singles(), most_singles);
        if (diagnosis_.complete && !promises_more(singles)) return {};
        std::vector<Proposal> found = fitted(singles);
        if (!diagnosis_.complete && std::ranges::none_of(found, &Proposal::fits)) {
            auto pairs = fitted(scored_.unlike(scored_.pairs(most_firsts), most_pairs));
            std::erase_if(pairs, [](const Proposal& pair) {
                return std::ranges::any_of(pair.shapes, needless);
            });
            std::ranges::move(pairs, std::back_inserter(found));
        }
        return best_of(std::move(found));
    }

  private:
    bool promises_more(const std::vector<Score>& singles) const;
    /// Refits the model with the shapes of each score, and tests the best results among the known
    /// effects and the other shapes.
    std::vector<Proposal> fitted(const std::vector<Score>& scores);
    Proposal proposal_for(const Score& score);
    void refit(Proposal& proposal, const Score& score, std::size_t first,
               const Explanations& explanations) const;
    std::string free_name(const std::string& name);
    /// Tests whether the models with these proposals fit, the lowest penalised chi2 first, until
    /// the rest cannot be among the best.
    static void judge(std::vector<Proposal>& proposals, const Explanations& explanations);
    static std::vector<Proposal> best_of(std::vector<Proposal> found);

    const StudyModelSpace& models_;
    const Explanations explanations_;
    const Diagnosis& diagnosis_;
    const DiagnosisOptions& options_;
    ScoredShapes scored_;
    std::set<std::string> taken_;  ///< names that existing effects have
};

/// Whether a single shape, by its linear estimate, may describe the readings clearly better than
/// all models that fit.
bool ShapeSearch::promises_more(const std::vector<Score>& singles) const {
    double least = INFINITY;  // chi2
    for (const FittedModel& each : diagnosis_.confidence_set) {
        least = std::min(least, each.fit.chi2);
    }
    // A refit finds about what its linear estimate foretells: half of what is asked is margin.
    return std::ranges::any_of(singles, [&](const Score& score) {
        return diagnosis_.base.fit.chi2 - score.reduction + score.penalty + clearly_better / 2 <
               least;
    });
}

std::string ShapeSearch::free_name(const std::string& name) {
    std::string free = name;
    for (int number = 2; !taken_.insert(free).second; ++number) {
        free = fmt::format("{}-{}", name, number);
    }
    return free;
}

Proposal ShapeSearch::proposal_for(const Score& score) {
    Proposal proposal{.p = scored_.p(score), .penalty = score.penalty};
    for (const std::size_t k : score.shapes) {
        const ShapeOfChange& shape = scored_.shape(k);
        proposal.shapes.push_back(
            {.shape = shape, .effect = shape.written(free_name(shape.name()))});
    }
    for (const std::size_t k : score.alike) {
        const auto [change, error] = scored_.estimate(k);
        proposal.alike.push_back({scored_.shape(k), {}, change, error});
    }
    return proposal;
}

void ShapeSearch::refit(Proposal& proposal, const Score& score, std::size_t first,
                        const Explanations& explanations) const {
    const auto added = static_cast<Eigen::Index>(proposal.shapes.size());
    EffectSet chosen;
    Eigen::VectorXd start(diagnosis_.base.fit.parameters.size() + added);
    start.head(diagnosis_.base.fit.parameters.size()) = diagnosis_.base.fit.parameters;
    for (std::size_t k = 0; k < proposal.shapes.size(); ++k) {
        chosen.push_back(first + k);
        start(diagnosis_.base.fit.parameters.size() + static_cast<Eigen::Index>(k)) =
            score.changes[k];
    }
    proposal.model = explanations.refit(chosen, {}, start);
    const Fit& fit = proposal.model.fit;
    for (std::size_t k = 0; k < proposal.shapes.size(); ++k) {
        const auto at = diagnosis_.base.fit.parameters.size() + static_cast<Eigen::Index>(k);
        proposal.shapes[k].change = fit.parameters(at);
        proposal.shapes[k].standard_error = fit.standard_error(at);
    }
    proposal.explained = share_explained(diagnosis_.excess(), proposal.model);
}

std::vector<Proposal> ShapeSearch::fitted(const std::vector<Score>& scores) {
    std::vector<Proposal> proposals;
    std::vector<Effect> effects;
    for (const Score& score : scores) {
        proposals.push_back(proposal_for(score));
        for (const FittedShape& each : proposals.back().shapes) {
            effects.push_back(effect_from(each.effect));
        }
    }
    const StudyModelSpace space = models_.offering(effects);
    Explanations explanations(space, explanations_);
    std::vector<std::size_t> firsts;
    std::size_t next = models_.candidates().size();
    for (const Score& score : scores) {
        firsts.push_back(next);
        next += score.shapes.size();
    }
    const auto say = [&](std::size_t k) {
        if (options_.progress) options_.progress("shapes", k, scores.size());
    };
    std::vector<char> possible(scores.size(), 1);
    side_by_side(scores.size(), options_.threads, say, [&](std::size_t k) {
        try {
            refit(proposals[k], scores[k], firsts[k], explanations);
        } catch (const std::domain_error&) {
            possible[k] = 0;  // the readings are impossible with this shape
        }
    });
    std::vector<Proposal> refitted;
    for (std::size_t k = 0; k < proposals.size(); ++k) {
        if (possible[k]) refitted.push_back(std::move(proposals[k]));
    }
    explanations.errors = diagnosis_.change_errors;
    const std::size_t known = models_.candidates().size();
    explanations.errors.resize(space.candidates().size());
    side_by_side(explanations.errors.size() - known, options_.threads, {}, [&](std::size_t k) {
        explanations.errors[known + k] =
            explanations.addition(diagnosis_.base, known + k).signature(true).errors;
    });
    judge(refitted, explanations);
    return refitted;
}

void ShapeSearch::judge(std::vector<Proposal>& proposals, const Explanations& explanations) {
    std::ranges::stable_sort(proposals, {}, &Proposal::penalised_chi2);
    std::size_t standing = 0;
    double limit = INFINITY;
    for (Proposal& each : proposals) {
        if (standing == most_proposals || each.penalised_chi2() > limit) return;
        explanations.judge(each.model);
        if (!each.fits()) continue;
        if (standing++ == 0) limit = each.penalised_chi2() + clearly_better;
    }
}

std::vector<Proposal> ShapeSearch::best_of(std::vector<Proposal> found) {
    std::ranges::stable_sort(found, {}, [](const Proposal& each) {
        return std::pair(!each.fits(), each.penalised_chi2());
    });
    if (found.empty()) return found;
    if (!found.front().fits()) {
        found.resize(found.front().explained < most_of_it ? 0 : 1);
        return found;
    }
    std::set<std::string> named;  // a shape that differs only in its constant is not proposed again
    std::erase_if(found, [&](const Proposal& each) {
        std::string names;
        for (const FittedShape& fitted : each.shapes) {
            names += fitted.shape.name() + " ";
        }
        return !each.fits() || !named.insert(names).second;
    });
    found.resize(std::min(found.size(), most_proposals));
    return found;
}

}  // namespace

std::vector<Proposal> propose(const ResolvedStudy& study, const StudyModelSpace& models,
                              const Evidence& evidence, const std::vector<Reading>& readings,
                              const Diagnosis& diagnosis, const DiagnosisOptions& options) {
    return ShapeSearch(study, models, evidence, readings, diagnosis, options).run();
}

}  // namespace pendular
