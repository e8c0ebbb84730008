#pragma once

#include <algorithm>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "analysis/diagnosis/evidence.h"
#include "analysis/diagnosis/explanations.h"

// How a diagnosis decides. Tests, refits, proposals and doubts about the measurement come in; the
// verdict, a decision on each effect, and what is said first go out. Which models fit is found in
// explanations.cpp (the tests of one model) and explanation_search.cpp (which models are tried, and
// when one effect is preferred to a pair); what follows from that is decided here: `conclude` is a
// pure function.
//
// In order of precedence:
//   1. A measurement that is doubtful in itself overrules all tests: implausible readings, or a
//      wrong unit that explains the readings better than any known effect.
//   2. The study's model fits: `nothing_missing`, or `inconclusive` if effects of interest could
//      have gone undetected, if no effect could have been seen, or if errors are assumed.
//   3. Models with further effects fit: `missing` names what they share; `indistinguishable` if
//      they share nothing; `suspect_measurement` if only an error of measurement fits. Where only
//      pairs fit, an effect that removes most of the misfit alone is a rival of theirs.
//   4. No model fits: `missing` with the leading effects (`complete` is false), or `unknown`.
//   5. `unknown` in place of 3 and 4 where a proposed change of unknown cause describes the
//      readings clearly better than each model with known effects or an error of measurement: a
//      single change in place of 3, as few changes as there are leading effects in place of 4.
namespace pendular {

enum class Verdict {
    nothing_missing,
    inconclusive,
    missing,
    indistinguishable,
    unknown,
    suspect_measurement
};
/// Returns the name for output, such as "nothing-missing".
std::string_view to_string(Verdict verdict);
/// Whether the study's model describes the readings, so that nothing is named.
constexpr bool is_of_fitting_model(Verdict verdict) {
    return verdict == Verdict::nothing_missing || verdict == Verdict::inconclusive;
}

/// Decision on one candidate effect.
enum class Decision {
    missing,
    missing_with_others,    ///< a leading effect: explains most of the misfit, not all
    may_be_missing,         ///< named by an `indistinguishable` verdict
    may_be_missing_too,     ///< in a model that fits, but not named by the verdict
    contains_missing,       ///< fits, but so does a lower level of the same ladder
    not_converged,          ///< the fit with the effect did not converge
    not_identifiable,       ///< the readings cannot reveal the effect at any size
    not_excluded,           ///< the readings might not reveal the effect at its size of interest
    absent,                 ///< the readings would have revealed the effect
    no_sign,                ///< the model does not fit, and the effect is not significant
    explains_most_not_all,  ///< removes most of the misfit; a model with it does not fit
    does_not_explain,       ///< significant, but a model with it does not fit
    outdone  ///< fits, but a change of unknown cause describes the readings clearly better
};
/// Returns the words in tables and JSON, such as "cannot be excluded".
std::string_view to_string(Decision decision);

/// Tests of a study's model and of models with further effects.
struct TestResults {
    /// Study's model, without further effects. Its `further_p` is that of the most significant
    /// candidate or suspect measurement; it is `accepted` if it passes both tests.
    FittedModel base;
    int dof = 0;  ///< of `base`: measured values minus fitted parameters and constant cohesions
    /// Tests of each candidate, sorted by the reduction of chi2 in a refit with it alone or,
    /// without one, the predicted reduction, the largest first.
    std::vector<Finding> scan;
    /// p value [1] of each suspect measurement, corrected for the number of tests.
    std::vector<double> suspect_p;
    std::vector<FittedModel> tried;    ///< all refitted models, whether they fit or not
    std::vector<FittedModel> fitting;  ///< models among `tried` with further effects that fit
    /// Models among `tried` that fit with an error of a suspect measurement, and the names of
    /// these.
    std::vector<FittedModel> fitting_suspects;
    std::vector<std::string> suspect_names;
    std::optional<Leaders> leading;  ///< if no model fits
    bool errors_assumed = false;     ///< whether some errors are assumed, not measured

    /// Returns chi2 - dof of the study's model [1], the misfit to explain.
    double excess() const { return base.fit.chi2 - dof; }
};

/// Further evidence that has a say in a verdict beside the tests.
struct Circumstances {
    std::vector<std::string> doubtful = {};  ///< such as "the unit of the torque"
    /// Part of a `Proposal` of changes of unknown cause that decides.
    struct Proposed {
        bool fits;              ///< whether the model with the changes fits
        std::size_t changes;    ///< number of changes
        double penalised_chi2;  ///< `Proposal::penalised_chi2` [1]
    };
    std::vector<Proposed> proposals = {};
    bool recordings_explain_most = false;  ///< RecordingEvidence::explains_most() of a fault
};

/// Answer of a diagnosis, as it follows from the tests.
struct Conclusion {
    Verdict verdict = Verdict::inconclusive;
    /// Names of the effects that are missing or may be missing; of an `inconclusive` verdict, those
    /// that the readings cannot exclude at their smallest sizes of interest.
    std::vector<std::string> effects;
    /// Whether any model, the study's or a refitted one, fits, and no change of unknown cause
    /// describes the readings clearly better.
    bool complete = true;
    std::optional<Leaders> leaders;  ///< empty unless `missing` and not `complete`
    /// Names of the suspect measurements whose error alone would explain the misfit, such as "the
    /// readings of dry_1.csv". Beside effects that fit, only those that explain the readings at
    /// least as well (FittedModel::criterion).
    std::vector<std::string> suspects;
    /// Models between which the readings cannot decide: the study's model alone if it fits;
    /// otherwise models with further effects that fit or explain most, or else with an error of
    /// measurement.
    std::vector<FittedModel> confidence_set;
    std::vector<Decision> decisions;  ///< on each candidate, in their order
    bool overruled = false;           ///< whether a doubtful measurement decides
    bool proposals_stand = false;     ///< whether the proposals are part of the answer
    bool recordings_first = false;    ///< whether the fault of the recordings is said first

    Decision decision_on(const Finding& finding) const { return decisions.at(finding.candidate); }
    /// Whether a change of unknown cause takes the place of known effects that fit.
    bool outdone() const {
        return std::ranges::find(decisions, Decision::outdone) != decisions.end();
    }
};

/// Whether two diagnoses give the same answer: one verdict on the same effects or, if a measurement
/// is suspect, on the same measurements, and either both or neither with a model that fits.
bool same_answer(const Conclusion& one, const Conclusion& other);

/// Returns what follows from the tests of a study's model.
/// @param candidates effects that were tested; Finding::candidate is an index into them
/// @param wanted_power smallest power [1] at which an effect that was not found counts as excluded
Conclusion conclude(const std::vector<Candidate>& candidates, const TestResults& tests,
                    double wanted_power, const Circumstances& circumstances = {});

}  // namespace pendular
