#include "workflow/confirm_diagnosis.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <iterator>
#include <string>
#include <utility>

#include "analysis/diagnosis/ranking.h"
#include "calib/fit/sharpening_runs.h"
#include "calib/fit/stopping_rule.h"
#include "calib/model/fresh_runs.h"
#include "calib/model/run_budget.h"

namespace pendular {
namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) {
    return std::chrono::duration<double>(Clock::now() - start).count();
}

/// Largest number of models for which runs are made at a time, besides a simpler one. Chosen: the
/// time is limited, and runs for many models sharpen none.
constexpr std::size_t most_models = 3;

/// Models in the running, the best first: refitted models, or the study's model, whose criterion
/// (ranking.h) is near that of the best. The best model with fewer effects stays in the running if
/// it explains `most_of_misfit`, however much worse it fits: its remaining misfit may be an error
/// of the emulator. Only runs for this model can correct such an error.
std::vector<FittedModel> models_in_the_running(const Diagnosis& diagnosis) {
    std::vector<FittedModel> all = {diagnosis.base};
    std::ranges::copy_if(diagnosis.tried, std::back_inserter(all),
                         [](const FittedModel& each) { return !each.suspect; });
    const double variance = factor_on_variance(all);
    const auto criterion = [&](const FittedModel& each) { return akaike(each, variance); };
    std::ranges::stable_sort(all, {}, criterion);
    std::vector<FittedModel> running;
    for (const FittedModel& each : all) {
        const bool close = criterion(each) <= criterion(all.front()) + worth_simulating;
        if (close && running.size() < most_models) running.push_back(each);
    }
    const auto simplest =
        std::ranges::min(running, {}, [](const FittedModel& each) { return each.chosen.size(); });
    const auto simpler = std::ranges::find_if(all, [&](const FittedModel& each) {
        return each.chosen.size() < simplest.chosen.size() && diagnosis.excess() > 0 &&
               diagnosis.base.fit.chi2 - each.fit.chi2 >= most_of_misfit * diagnosis.excess();
    });
    if (simpler != all.end()) running.push_back(*simpler);
    return running;
}

/// Work of confirming one diagnosis, with what it has learned so far.
class Confirming {
  public:
    Confirming(const ResolvedStudy& study, const Measurements& measurements,
               const SessionOptions& session, double seconds)
        : study_(study),
          measurements_(measurements),
          session_(session),
          budget_(seconds),
          seeds_(session.seed),
          known_(runs_for_diagnosis(study, session)) {}

    StudyDiagnosis result() {
        StudyDiagnosis diagnosis = diagnosed();
        for (int round = 1; !firm(diagnosis); ++round) {
            const std::vector<dem::RunParameters> runs = next_runs(diagnosis);
            if (runs.empty()) break;
            if (round == 1) announce(runs);
            learn(diagnosis, runs, round);
            StudyDiagnosis again = diagnosed();
            same_ = same_answer(diagnosis.diagnosis, again.diagnosis);
            diagnosis = std::move(again);
            report(diagnosis.diagnosis, round);
        }
        confirmation_.seconds = seconds_since(start_);
        confirmation_.settled = firm(diagnosis);
        diagnosis.confirmed = confirmation_;
        return diagnosis;
    }

  private:
    /// Diagnosis with all runs known so far. Only the first diagnosis reports its progress; the
    /// verdicts of later ones are reported by `report`.
    StudyDiagnosis diagnosed() {
        const auto start = Clock::now();
        SessionOptions session = session_;
        if (confirmation_.runs > 0) session.listener = {};
        StudyDiagnosis diagnosis = diagnose_study(study_, measurements_, session, known_);
        constexpr double more = 1.5;  // a diagnosis with more runs may take longer
        reserved_ = more * seconds_since(start);
        return diagnosis;
    }

    void report(const Diagnosis& diagnosis, int round) const {
        tell(session_.listener,
             {.kind = Event::Kind::stage,
              .text = fmt::format(
                  "Verdict after round {}: {}{}{}", round, to_string(diagnosis.verdict),
                  diagnosis.effects.empty() ? "" : ", ", fmt::join(diagnosis.effects, ", "))});
    }

    /// Whether the verdict is firm; if not, `Confirmation::open` is the reason.
    bool firm(const StudyDiagnosis& diagnosis) {
        Enlargement largest;
        for (const FittedModel& each : models_in_the_running(diagnosis.diagnosis)) {
            const auto model = diagnosis.models->with(each.chosen);
            const Enlargement own =
                enlargement_by_runs(each.fit, diagnosis.evidence.measured, model->parameters());
            if (own.size > largest.size) largest = own;
        }
        excess_ = largest.excess();
        using Open = Confirmation::Open;
        confirmation_.enlargement = largest;
        confirmation_.open = confirmation_.runs == 0 ? Open::no_simulation
                             : !same_                ? Open::verdict_changed
                             : p_ < disagreement     ? Open::emulator_disagrees
                             : excess_ > 1           ? Open::noise
                                                     : Open::nothing;
        return confirmation_.open == Open::nothing;
    }

    /// Runs of the next round; none where the time is over.
    std::vector<dem::RunParameters> next_runs(const StudyDiagnosis& diagnosis) {
        std::vector<FittedModel> running = models_in_the_running(diagnosis.diagnosis);
        for (FittedModel& each : running) {
            each.predictor = diagnosis.models->predictor(each.chosen);
        }
        RunChoice choice =
            sharpening_choice(diagnosis.models->simulation(), running, diagnosis.readings,
                              session_.fidelity.lowest_inertial_number);
        choice.factor = excess_;
        auto runs = seeds_.runs_at(
            most_informative(diagnosis.models->simulation().emulator(), session_.fidelity, choice),
            study_, session_.fidelity, known_.runs);
        // Wall times of runs that were made here tell more than those of the atlas.
        runs.resize(
            budget_.batch(runs, made_.empty() ? known_.runs : made_, session_.threads, reserved_));
        return runs;
    }

    void announce(const std::vector<dem::RunParameters>& runs) const {
        const auto expected = expected_seconds(runs, known_.runs, session_.threads);
        tell(session_.listener,
             {.kind = Event::Kind::stage,
              .text = fmt::format(
                  "Simulations test the verdict. They take at most {:.0f} s and end sooner if the "
                  "verdict is firm; the first {} of them take about {:.0f} s",
                  budget_.seconds_left(), runs.size(), expected.value_or(0))});
    }

    /// Carries out runs and adds them to the known ones.
    void learn(const StudyDiagnosis& diagnosis, const std::vector<dem::RunParameters>& runs,
               int round) {
        const Workers workers{session_.threads, session_.stop,
                              [&](const EnsembleProgress& progress) {
                                  tell(session_.listener,
                                       {.kind = Event::Kind::runs,
                                        .text = fmt::format("confirming, round {}", round),
                                        .runs = progress});
                              },
                              session_.store};
        std::vector<std::string> notes;
        const std::vector<dem::RunResult> done = budget_.run(runs, workers, reserved_);
        const std::vector<dem::RunResult> fresh = usable_of(done, notes);
        for (const std::string& note : notes) {
            tell(session_.listener, {.text = note});
        }
        p_ = agreement(diagnosis.models->simulation().emulator(), fresh);
        made_.insert(made_.end(), done.begin(), done.end());
        known_.runs.insert(known_.runs.end(), fresh.begin(), fresh.end());
        confirmation_.runs += done.size();
    }

    const Clock::time_point start_ = Clock::now();
    const ResolvedStudy& study_;
    const Measurements& measurements_;
    const SessionOptions& session_;
    const RunBudget budget_;
    FreshSeeds seeds_;
    KnownRuns known_;
    std::vector<dem::RunResult> made_;  ///< runs made so far
    double reserved_ = 0;               ///< time to reserve for the last diagnosis [s]
    bool same_ = false;                 ///< whether the verdict stayed the same with the last runs
    double p_ = 1;                      ///< p-value of the agreement of the last runs
    double excess_ = 1;  ///< factor by which the variance from the noise of the runs is too large
    Confirmation confirmation_;
};

}  // namespace

StudyDiagnosis confirm_diagnosis(const ResolvedStudy& study, const Measurements& measurements,
                                 const SessionOptions& session, double seconds) {
    try {
        return Confirming(study, measurements, session, seconds).result();
    } catch (const dem::Interrupted&) {
        throw interrupted_with(session.store);
    }
}

}  // namespace pendular
