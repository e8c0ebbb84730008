#include "analysis/diagnosis/verdict.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <stdexcept>
#include <utility>

#include "analysis/diagnosis/explanation_search.h"
#include "analysis/diagnosis/ranking.h"

namespace pendular {
namespace {

bool includes(const EffectSet& effects, std::size_t candidate) {
    return std::ranges::find(effects, candidate) != effects.end();
}

/// Applies the rules of `conclude`, one function for each.
class Rules {
  public:
    Rules(const std::vector<Candidate>& candidates, const TestResults& tests, double wanted_power,
          const Circumstances& circumstances)
        : candidates_(candidates),
          tests_(tests),
          wanted_power_(wanted_power),
          circumstances_(circumstances) {}

    Conclusion apply() {
        if (tests_.base.accepted) {
            study_model_stands();
        } else {
            gather_models_that_fit();
            if (result_.confidence_set.empty()) {
                no_model_fits();
            } else {
                some_models_fit();
            }
        }
        decide_on_candidates();
        if (!circumstances_.doubtful.empty()) {
            measurement_is_doubtful();
        } else if (!tests_.base.accepted) {
            weigh_proposals();
        }
        result_.recordings_first = circumstances_.recordings_explain_most;
        return std::move(result_);
    }

  private:
    const std::string& name(std::size_t k) const { return candidates_[k].name; }
    bool is_named(std::size_t k) const {
        return std::ranges::find(result_.effects, name(k)) != result_.effects.end();
    }

    void study_model_stands();
    void gather_models_that_fit();
    void keep_effects_that_explain_most();
    bool contains(const EffectSet& larger, const EffectSet& smaller) const;
    void some_models_fit();
    void no_model_fits();
    void decide_on_candidates();
    Decision decision_on(const Finding& finding) const;
    Decision decision_without_model(const Finding& finding) const;
    void measurement_is_doubtful();
    void weigh_proposals();
    void known_effects_are_outdone(const std::vector<FittedModel>& known);

    const std::vector<Candidate>& candidates_;
    const TestResults& tests_;
    double wanted_power_;
    const Circumstances& circumstances_;
    Conclusion result_;
};

void Rules::study_model_stands() {
    result_.confidence_set.push_back(tests_.base);
    bool any_seen = false;
    std::set<std::size_t> open;
    for (const Finding& finding : tests_.scan) {
        any_seen = any_seen || finding.identifiable;
        if (finding.identifiable && finding.power < wanted_power_) open.insert(finding.candidate);
    }
    for (const std::size_t k : open) {
        result_.effects.push_back(name(k));
    }
    // Where no effect can be seen at all, or errors are assumed, a model that fits shows nothing.
    const bool all_seen = any_seen && open.empty() && !tests_.errors_assumed;
    result_.verdict = all_seen ? Verdict::nothing_missing : Verdict::inconclusive;
}

void Rules::gather_models_that_fit() {
    // Beside effects that fit, a suspect measurement is a rival only if it explains the readings at
    // least as well as the best of them: with many files, an error of one of them often fits.
    double best = INFINITY;
    for (const FittedModel& each : tests_.fitting) {
        best = std::min(best, each.criterion);
    }
    for (std::size_t k = 0; k < tests_.fitting_suspects.size(); ++k) {
        if (tests_.fitting.empty() || tests_.fitting_suspects[k].criterion <= best)
            result_.suspects.push_back(tests_.suspect_names[k]);
    }
    const auto& all = tests_.fitting.empty() ? tests_.fitting_suspects : tests_.fitting;
    // Of two levels of one ladder that fit, the lower one says what is missing, unless it was kept
    // although it is improbable.
    std::ranges::copy_if(all, std::back_inserter(result_.confidence_set),
                         [&](const FittedModel& each) {
                             return std::ranges::none_of(all, [&](const FittedModel& other) {
                                 return contains(each.chosen, other.chosen) &&
                                        other.p() >= std::min(each.p(), significant_p);
                             });
                         });
    keep_effects_that_explain_most();
}

/// Adds models with one effect that remove most of the misfit where only pairs without it fit, and
/// no effect that all pairs share removes as much. A pair that removes a little more, as one of
/// many pairs always does, does not silence the effect.
void Rules::keep_effects_that_explain_most() {
    auto& set = result_.confidence_set;
    const bool pairs_only = !set.empty() && std::ranges::all_of(set, [](const auto& each) {
        return each.chosen.size() > 1;
    });
    if (!pairs_only) return;
    double by_shared = INFINITY;  // least chi2 with an effect alone that all pairs share
    std::vector<FittedModel> singles;
    for (const FittedModel& each : tests_.tried) {
        if (each.suspect || each.chosen.size() != 1 || !each.fit.converged) continue;
        const bool in_all = std::ranges::all_of(set, [&](const FittedModel& pair) {
            return includes(pair.chosen, each.chosen.front());
        });
        if (in_all) {
            by_shared = std::min(by_shared, each.fit.chi2);
        } else if (share_explained(tests_.excess(), each) >= most_of_misfit) {
            singles.push_back(each);
        }
    }
    std::erase_if(singles, [&](const FittedModel& each) { return each.fit.chi2 >= by_shared; });
    set.insert(set.end(), singles.begin(), singles.end());
}

/// Whether the model with the candidates `larger` has all that the model with `smaller` has, and
/// more: both are on the same ladder, the former on a higher level.
bool Rules::contains(const EffectSet& larger, const EffectSet& smaller) const {
    const auto split = [&](const EffectSet& chosen) {
        std::pair<int, std::set<std::size_t>> parts{0, {}};  // highest level, and the others
        for (const std::size_t k : chosen) {
            const int level = candidates_[k].level;
            parts.first = std::max(parts.first, level);
            if (level == 0) parts.second.insert(k);
        }
        return parts;
    };
    const auto [high, others] = split(larger);
    const auto [low, same] = split(smaller);
    return low > 0 && low < high && others == same;
}

/// Which models fit was decided before (`Explanations::judge`, `search_explanations`).
void Rules::some_models_fit() {
    const auto& set = result_.confidence_set;
    if (set.front().suspect) {
        result_.verdict = Verdict::suspect_measurement;
        return;
    }
    std::set<std::size_t> shared(set.front().chosen.begin(), set.front().chosen.end());
    std::set<std::size_t> any;
    for (const FittedModel& each : set) {
        std::erase_if(shared, [&](std::size_t k) { return !includes(each.chosen, k); });
        any.insert(each.chosen.begin(), each.chosen.end());
    }
    result_.verdict = shared.empty() ? Verdict::indistinguishable : Verdict::missing;
    for (const std::size_t k : shared.empty() ? any : shared) {
        result_.effects.push_back(name(k));
    }
}

void Rules::no_model_fits() {
    result_.complete = false;
    result_.leaders = tests_.leading;
    result_.proposals_stand = true;
    result_.verdict = result_.leaders ? Verdict::missing : Verdict::unknown;
    if (!result_.leaders) return;
    for (const std::size_t k : result_.leaders->model.chosen) {
        result_.effects.push_back(name(k));
    }
}

void Rules::decide_on_candidates() {
    result_.decisions.assign(candidates_.size(), Decision::not_identifiable);
    for (const Finding& finding : tests_.scan) {
        result_.decisions[finding.candidate] = decision_on(finding);
    }
}

Decision Rules::decision_on(const Finding& finding) const {
    const std::size_t k = finding.candidate;
    const auto in_set = [k](const FittedModel& each) { return includes(each.chosen, k); };
    const auto fits_alone = [k](const FittedModel& each) {
        return each.accepted && each.chosen == EffectSet{k};
    };
    if (!tests_.base.accepted) {
        if (is_named(k)) {
            if (!result_.complete) return Decision::missing_with_others;
            return result_.verdict == Verdict::missing ? Decision::missing
                                                       : Decision::may_be_missing;
        }
        if (std::ranges::any_of(result_.confidence_set, in_set)) {
            return Decision::may_be_missing_too;
        }
        if (std::ranges::any_of(tests_.tried, fits_alone)) return Decision::contains_missing;
    }
    return decision_without_model(finding);
}

/// Decision on an effect of which no model that fits makes use.
Decision Rules::decision_without_model(const Finding& finding) const {
    const auto unsettled = [&](const FittedModel& each) {
        return each.chosen == EffectSet{finding.candidate} && !each.fit.converged;
    };
    if (std::ranges::any_of(tests_.tried, unsettled)) return Decision::not_converged;
    if (!finding.identifiable && !looks_missing(finding)) return Decision::not_identifiable;
    if (tests_.base.accepted) {
        return finding.power < wanted_power_ ? Decision::not_excluded : Decision::absent;
    }
    if (!looks_missing(finding)) return Decision::no_sign;
    const bool most = finding.refitted_reduction &&
                      *finding.refitted_reduction >= most_of_misfit * tests_.excess();
    return most ? Decision::explains_most_not_all : Decision::does_not_explain;
}

void Rules::measurement_is_doubtful() {
    result_.overruled = true;
    result_.verdict = Verdict::suspect_measurement;
    result_.effects.clear();
    result_.leaders.reset();
    result_.proposals_stand = false;
    result_.complete = true;
    result_.suspects = circumstances_.doubtful;
}

/// Known effects have the benefit of the doubt, as has an error of one measurement: a change of
/// unknown cause that explains the readings must be clearly better than each of their models, with
/// as few changes as leading effects or, where known effects fit, with one: some of the many pairs
/// of changes describe chance better. The verdict is then `unknown`; else the known effects come
/// first, and the next diagnosis, with them in the model, proposes what remains.
void Rules::weigh_proposals() {
    const std::vector<FittedModel> known =
        result_.leaders ? std::vector{result_.leaders->model} : result_.confidence_set;
    if (known.empty()) return;
    const std::size_t most_changes = result_.leaders ? result_.leaders->model.chosen.size() : 1;
    const auto outdoes = [&](const Circumstances::Proposed& proposed) {
        return proposed.fits && proposed.changes <= most_changes &&
               std::ranges::all_of(known, [&](const FittedModel& each) {
                   return proposed.penalised_chi2 + clearly_better < each.fit.chi2;
               });
    };
    result_.proposals_stand = std::ranges::any_of(circumstances_.proposals, outdoes);
    if (result_.proposals_stand) known_effects_are_outdone(known);
}

void Rules::known_effects_are_outdone(const std::vector<FittedModel>& known) {
    for (const FittedModel& each : known) {
        for (const std::size_t k : each.chosen) {
            result_.decisions[k] = each.accepted ? Decision::outdone : Decision::does_not_explain;
        }
    }
    result_.verdict = Verdict::unknown;
    result_.complete = false;
    result_.confidence_set.clear();
    result_.effects.clear();
    result_.suspects.clear();
    result_.leaders.reset();
}

}  // namespace

std::string_view to_string(Verdict verdict) {
    switch (verdict) {
        case Verdict::nothing_missing:
            return "nothing-missing";
        case Verdict::inconclusive:
            return "inconclusive";
        case Verdict::missing:
            return "missing";
        case Verdict::indistinguishable:
            return "indistinguishable";
        case Verdict::unknown:
            return "unknown";
        case Verdict::suspect_measurement:
            return "suspect-measurement";
    }
    throw std::logic_error("a verdict has no name");
}

std::string_view to_string(Decision decision) {
    switch (decision) {
        case Decision::missing:
            return "missing";
        case Decision::missing_with_others:
            return "missing, with others";
        case Decision::may_be_missing:
            return "may be missing";
        case Decision::may_be_missing_too:
            return "may be missing too";
        case Decision::contains_missing:
            return "contains what is missing";
        case Decision::not_converged:
            return "refit not converged";
        case Decision::not_identifiable:
            return "cannot be seen";
        case Decision::not_excluded:
            return "cannot be excluded";
        case Decision::absent:
            return "absent";
        case Decision::no_sign:
            return "no sign of it";
        case Decision::explains_most_not_all:
            return "explains most, not all";
        case Decision::does_not_explain:
            return "does not explain it";
        case Decision::outdone:
            return "outdone by a change";
    }
    throw std::logic_error("a decision has no words");
}

bool same_answer(const Conclusion& one, const Conclusion& other) {
    return one.verdict == other.verdict && one.complete == other.complete &&
           one.effects == other.effects &&
           (one.verdict != Verdict::suspect_measurement || one.suspects == other.suspects);
}

Conclusion conclude(const std::vector<Candidate>& candidates, const TestResults& tests,
                    double wanted_power, const Circumstances& circumstances) {
    return Rules(candidates, tests, wanted_power, circumstances).apply();
}

}  // namespace pendular
