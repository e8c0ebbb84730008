#include "reports/change_report.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "reports/fit_report.h"
#include "reports/other_causes.h"
#include "reports/tables.h"
#include "reports/with_error.h"

namespace pendular {
namespace {

constexpr std::array<const char*, 2> observable_words = {"shear stress", "solid fraction"};

std::string number(double value) {
    return std::abs(value) < 1000 ? fmt::format("{:.3g}", value) : fmt::format("{:.0f}", value);
}

/// Text of chi2 per degree of freedom: "15.98", "0.99".
std::string per_dof(const LadderStep& step) {
    const double value = step.chi2_per_dof();
    return value < 100 ? fmt::format("{:.2f}", value) : number(value);
}

std::string estimate(const LadderParameter* parameter) {
    return parameter ? estimate_text(parameter->value, parameter->standard_error, parameter->unit,
                                     parameter->width, parameter->at_bound)
                     : "-";
}

/// Size of the change of a parameter over the larger of its standard errors before and after the
/// change [1].
double drift(const LadderParameter& before, const LadderParameter& after) {
    return std::abs(after.value - before.value) /
           std::max(before.standard_error, after.standard_error);
}

std::string parameter_line(const std::string& name, const LadderParameter* before,
                           const LadderParameter* after) {
    const auto change = [&] {  // of an error larger than the range no digits follow
        const bool known = before->standard_error < before->width;
        return change_text(after->value - before->value, before->value,
                           known ? before->standard_error : 0, before->unit);
    };
    const std::string moved = before && after ? change() : after ? "new" : "removed";
    return fmt::format("  {:<36} {:>24} {:>24} {:>12}", name, estimate(before), estimate(after),
                       moved);
}

/// Product of the factors on the RMS errors at left-out conditions that counts as worse [1]: less
/// is within the scatter of a few conditions.
constexpr double noticeable_rise = 1.05;

/// Whether an effect makes the predictions of conditions left out of the fit worse: the product of
/// the factors by which it changes the two RMS errors is above 1. One error that rises a little
/// while the other halves, as the table then shows, makes the model better.
bool left_out_worse(const LadderStep& without, const LadderStep& with) {
    if (!without.left_out_percent || !with.left_out_percent) return false;
    double product = 1;
    for (std::size_t o = 0; o < observable_words.size(); ++o)
        product *= (*with.left_out_percent)[o] / (*without.left_out_percent)[o];
    return product > noticeable_rise;
}

/// Text of a change of a number: "falls from 15.98 to 0.99", "stays at 16.3".
std::string moved(const std::string& from, const std::string& to, bool falls) {
    if (from == to) return "stays at " + to;
    return fmt::format("{} from {} to {}", falls ? "falls" : "rises", from, to);
}

/// The RMS errors at left-out conditions with an effect beside those without it: "the error of
/// shear stress rises from 1.2 % to 1.9 %, that of solid fraction falls from 0.3 % to 0.2 %".
std::string left_out_text(const LadderStep& without, const LadderStep& with) {
    std::string text;
    for (std::size_t o = 0; o < observable_words.size(); ++o) {
        const double before = (*without.left_out_percent)[o], after = (*with.left_out_percent)[o];
        const auto percent = [](double rms) { return fmt::format("{:.3g} %", rms); };
        text += fmt::format("{} {} {}", o == 0 ? "the error of" : ", that of", observable_words[o],
                            moved(percent(before), percent(after), after < before));
    }
    return text;
}

/// Judgement on an effect by the fits of the model without it and with it.
enum class Outcome {
    better,  ///< chi2 falls by more than chance, and left-out conditions are predicted as well
    left_out_worse,  ///< chi2 falls, but left-out conditions are predicted worse
    by_chance,       ///< chi2 falls by no more than chance
    beside_misfit,   ///< chi2 falls by little compared with the misfit that remains
    worse            ///< chi2 does not fall
};

Outcome outcome_of(const LadderStep& without, const LadderStep& with) {
    if (with.chi2 >= without.chi2) return Outcome::worse;
    const Reduction reduction = reduction_of(without, with);
    if (reduction == Reduction::by_chance) return Outcome::by_chance;
    if (reduction == Reduction::beside_misfit) return Outcome::beside_misfit;
    return left_out_worse(without, with) ? Outcome::left_out_worse : Outcome::better;
}

const LadderStep& without(const StudyChange& change, const LadderStep& before,
                          const LadderStep& after) {
    return change.change == Action::add ? before : after;
}

const LadderStep& with(const StudyChange& change, const LadderStep& before,
                       const LadderStep& after) {
    return change.change == Action::add ? after : before;
}

Outcome outcome_of(const StudyChange& change, const LadderStep& before, const LadderStep& after) {
    return outcome_of(without(change, before, after), with(change, before, after));
}

/// Beginning of the sentence on a change: "torque-offset added, but the readings do not need it".
std::string beginning(const StudyChange& change, Outcome outcome) {
    const std::string& effect = change.effect;
    const bool adds = change.change == Action::add;
    switch (outcome) {
        case Outcome::better:
            return adds ? effect + " added"
                        : effect + " dropped, but the model needs it or a similar effect";
        case Outcome::left_out_worse:
            return adds ? effect + " added, but left-out conditions are predicted worse with it"
                        : effect + " dropped; left-out conditions are predicted better without it";
        case Outcome::by_chance:
            return effect + (adds ? " added, but the readings do not need it"
                                  : " dropped; the readings do not need it");
        case Outcome::beside_misfit:
            return effect + (adds ? " added, but it leaves the misfit as it is"
                                  : " dropped; the misfit is as with it");
        default:
            return effect + (adds ? " added, but it does not improve the model"
                                  : " dropped; it did not improve the model");
    }
}

/// Reason for the judgement on an effect, as a sentence; empty where chi2 states it.
std::string reason_for(Outcome outcome, const std::string& effect, const LadderStep& without,
                       const LadderStep& with) {
    if (outcome == Outcome::by_chance || outcome == Outcome::beside_misfit) {
        return fmt::format(
            "{} adds a parameter but lowers chi2 by only {:.1f} (from {} to {}): {}.", effect,
            without.chi2 - with.chi2, number(without.chi2), number(with.chi2),
            outcome == Outcome::by_chance ? "chance explains such a reduction"
                                          : "that is little beside the misfit that remains");
    }
    if (outcome == Outcome::left_out_worse) {
        return fmt::format(
            "With {}, chi2 is lower, but at conditions left out of the fit {}: measure at further "
            "conditions before you use it.",
            effect, left_out_text(without, with));
    }
    return "";
}

}  // namespace

std::string verdict_of(const StudyChange& change, const LadderStep& before,
                       const LadderStep& after) {
    const auto percent = [](double rms) { return fmt::format("{:.2f} %", rms); };
    return fmt::format(
        "{}: chi2/dof {}, the relative RMS error of shear stress {}.",
        beginning(change, outcome_of(change, before, after)),
        moved(per_dof(before), per_dof(after), after.chi2_per_dof() < before.chi2_per_dof()),
        moved(percent(before.rms_percent[0]), percent(after.rms_percent[0]),
              after.rms_percent[0] < before.rms_percent[0]));
}

std::string next_after(const StudyChange& change, const LadderStep& before, const LadderStep& after,
                       bool believable, const std::string& study) {
    const Outcome outcome = outcome_of(change, before, after);
    const bool undecided = outcome == Outcome::better || outcome == Outcome::beside_misfit;
    if (change.change == Action::add && !undecided)
        return fmt::format("pendular drop {} {}", study, change.effect);
    return fmt::format("pendular {} {}", believable ? "compare" : "diagnose", study);
}

std::vector<std::string> error_changes(const LadderStep& before, const LadderStep& after) {
    const auto row = [](const std::string& name, double first, double second) {
        return fmt::format("  {:<62} {:>12.3f} {:>12.3f}", name, first, second);
    };
    std::vector<std::string> lines = {
        fmt::format("  {:<62} {:>12} {:>12}", "misfit", "before", "after"),
        row("chi2/dof [1]", before.chi2_per_dof(), after.chi2_per_dof())};
    for (std::size_t o = 0; o < observable_words.size(); ++o) {
        lines.push_back(row(fmt::format("relative RMS error of {} [%]", observable_words[o]),
                            before.rms_percent[o], after.rms_percent[o]));
    }
    if (before.left_out_percent && after.left_out_percent) {
        for (std::size_t o = 0; o < observable_words.size(); ++o) {
            lines.push_back(row(fmt::format("relative RMS error of {}, left-out conditions [%]",
                                            observable_words[o]),
                                (*before.left_out_percent)[o], (*after.left_out_percent)[o]));
        }
    }
    return lines;
}

std::vector<std::string> parameter_changes(const LadderStep& before, const LadderStep& after) {
    std::vector<std::string> lines = {
        fmt::format("  {:<36} {:>24} {:>24} {:>12}", "parameter", "before", "after", "change")};
    for (const LadderParameter& p : before.parameters) {
        lines.push_back(parameter_line(p.name, &p, after.find(p.name)));
    }
    for (const LadderParameter& p : after.parameters) {
        if (!before.find(p.name)) {
            lines.push_back(parameter_line(p.name, nullptr, &p));
        }
    }
    return lines;
}

std::vector<std::string> advice_on(const StudyChange& change, const LadderStep& before,
                                   const LadderStep& after) {
    std::vector<std::string> lines;
    const Outcome outcome = outcome_of(change, before, after);
    std::string reason = reason_for(outcome, change.effect, without(change, before, after),
                                    with(change, before, after));
    if (!reason.empty()) lines.push_back(std::move(reason));
    for (const LadderParameter& p : before.parameters) {
        const LadderParameter* const later = after.find(p.name);
        if (!later || drift(p, *later) <= 3) continue;
        lines.push_back(fmt::format(
            "The fitted {} depends strongly on {}: it changes by {:.1f} standard errors.", p.name,
            change.effect, drift(p, *later)));
    }
    return lines;
}

std::string answer_on(const ChangedStudy& changed) {
    const StudyChange& change = changed.change;
    const bool adds = change.change == Action::add;
    if (changed.written)
        return verdict_of(change, changed.before.ladder_step,
                          changed.comparable_after().ladder_step);
    return fmt::format("{} not {}: the fit {} it did not converge ({}). {} is unchanged.",
                       change.effect, adds ? "added" : "dropped", adds ? "with" : "without",
                       changed.after.calibration.fit.message, change.study.study().file.string());
}

namespace {

/// Sentence on the readings that the fits before and after a change use, where the study itself
/// fits the dry readings alone before or after it; empty otherwise.
std::string on_fitted_readings(const ChangedStudy& changed) {
    if (changed.after_to_all) {
        const Calibration& c = changed.after.calibration;
        return fmt::format(
            "The fits with and without {0} use all readings, dry and wet. Without {0}, a fit to "
            "the dry readings alone ('pendular calibrate') gives {1} = {2}.",
            changed.change.effect, c.parameters[0].name,
            estimate_text(c.fit, 0, c.parameters[0].unit));
    }
    return changed.widened ? fmt::format(
                                 "Both fits, with and without {0}, use all readings, dry and wet, "
                                 "as 'pendular calibrate' does if the model contains {0}.",
                                 changed.change.effect)
                           : "";
}

}  // namespace

Output change_output(const ChangedStudy& changed) {
    Output output;
    output.answer(answer_on(changed));
    if (!changed.written) {
        output.notes(changed.after.calibration.notes);
        return output;
    }
    add_doubts(output, changed.after.belief, 0,
               changed.after_to_all
                   ? "Warning from 'pendular calibrate', which fits the dry readings alone: "
                   : "Warning about the new fit: ");
    const StudyChange& change = changed.change;
    const FittedStudy& before = changed.before;
    const FittedStudy& after = changed.comparable_after();
    output.table(error_changes(before.ladder_step, after.ladder_step), 10);
    output.table(parameter_changes(before.ladder_step, after.ladder_step), 5);
    const bool adds = change.change == Action::add;
    output.line(fmt::format("Chi2 is {:.2f} for {} {} {}, and {:.2f} for {} {} it.",
                            before.ladder_step.chi2, freedom_text(before.ladder_step.dof),
                            adds ? "without" : "with", change.effect, after.ladder_step.chi2,
                            after.ladder_step.dof, adds ? "with" : "without"));
    output.line(on_fitted_readings(changed));
    if (change.change == Action::drop &&
        change.study.catalogue().is_written(change.study.catalogue().find(change.effect))) {
        output.line(
            fmt::format("Its table [[effect]] stays in {}.", change.study.study().file.string()));
    }
    output.notes(advice_on(change, before.ladder_step, after.ladder_step));
    if (const auto& rivals = after.ladder_step.rivals; !rivals.empty()) {
        std::vector<std::string> names, effects = {change.effect};
        for (const auto& rival : rivals) {
            names.push_back(fmt::format("{}", fmt::join(rival, " with ")));
            for (const std::string& effect : rival) {
                if (std::ranges::find(effects, effect) == effects.end()) effects.push_back(effect);
            }
        }
        output.line(fmt::format(
            "In the last diagnosis, other effects explained the readings as well as {}: {}. "
            "'pendular diagnose' and 'pendular next' continue to compare these models.",
            change.effect, fmt::join(names, ", ")));
        const std::string methods = direct_methods(effects, change.study.catalogue());
        if (!methods.empty()) {
            output.line(
                fmt::format("A direct measurement would decide between them: {}.", methods));
        }
    }
    add_limits(output, after.calibration.runs, after.calibration.readings,
               after.calibration.fit.parameters(0));
    if (!before.calibration.fit.converged) {
        output.note("The fit before the change did not converge: " +
                    before.calibration.fit.message);
    }
    if (after.left_out.undetermined > 0) {
        output.note(fmt::format(
            "Cross-validation: without {} of the {} conditions, the other conditions do not "
            "determine a parameter, which then keeps its starting value.",
            after.left_out.undetermined == 1
                ? "one"
                : fmt::format("any of {}", after.left_out.undetermined),
            after.left_out.conditions));
    }
    output.notes(after.calibration.notes);
    return output;
}

}  // namespace pendular
