#include "bench/hidden_effects/walk.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <boost/math/distributions/chi_squared.hpp>
#include <chrono>
#include <cmath>
#include <stdexcept>

#include "data/files/write_whole.h"
#include "data/recordings/reading_groups.h"
#include "sim/lab/virtual_study.h"
#include "sim/runs/run_settings.h"
#include "workflow/session.h"

namespace pendular::bench {
namespace {

std::string name_of(const FittedModel& explanation, const StudyModelSpace& models,
                    const Evidence& evidence) {
    std::vector<std::string> parts;
    for (const std::size_t k : explanation.chosen) {
        parts.push_back(models.candidates()[k].name);
    }
    if (explanation.suspect) parts.push_back(evidence.suspects[*explanation.suspect].name);
    return parts.empty() ? "nothing" : fmt::format("{}", fmt::join(parts, " + "));
}

bool is_truth(const FittedModel& explanation, const StudyModelSpace& models, const Truth& truth) {
    return !explanation.suspect && explanation.chosen.size() == truth.hidden.size() &&
           std::ranges::all_of(explanation.chosen, [&](std::size_t k) {
               return truth.hides(models.candidates()[k].name);
           });
}

FittedStudy fitted_with(const Study& study, const Measurements& measurements,
                        const Fidelity& fidelity) {
    FittedStudy result = fitted(study, fit_study(study, measurements, {.fidelity = fidelity}, {}));
    cross_validate(result);
    return result;
}

/// RMS scatter [%] of replicates about the means of their conditions.
std::array<double, 2> scatter_of(const std::vector<Reading>& readings) {
    Eigen::Array2d squares = Eigen::Array2d::Zero();
    double freedom = 0;
    for (const auto& group : replicate_groups(readings)) {
        Eigen::Array2d mean = Eigen::Array2d::Zero();
        for (const std::size_t k : group) {
            mean += readings[k].value.array() / static_cast<double>(group.size());
        }
        for (const std::size_t k : group) {
            squares += (readings[k].value.array() / mean - 1).square();
        }
        freedom += static_cast<double>(group.size()) - 1;
    }
    return {100 * std::sqrt(squares(0) / freedom), 100 * std::sqrt(squares(1) / freedom)};
}

std::filesystem::path file_of(const Reading& reading) {
    return std::filesystem::path(reading.origin.file).filename();
}

}  // namespace

std::array<double, 2> noise_of(const std::vector<Reading>& readings, LabResult laboratory,
                               const std::filesystem::path& folder) {
    laboratory.plan.instrument.noise = laboratory.plan.instrument.drift = 0;
    write_whole_folder(folder, study_files(laboratory));
    const std::vector<Reading> exact = read_input(folder).measurements.readings;
    std::filesystem::remove_all(folder);
    Eigen::Array2d squares = Eigen::Array2d::Zero();
    for (const Reading& reading : readings) {
        const auto same = std::ranges::find_if(exact, [&](const Reading& one) {
            return one.step == reading.step && file_of(one) == file_of(reading);
        });
        if (same == exact.end()) throw std::logic_error("a step is steady only with noise");
        squares += (same->value.array() / reading.value.array() - 1).square();
    }
    squares /= static_cast<double>(readings.size());
    return {100 * std::hypot(std::sqrt(squares(0)),
                             typical_error(laboratory, dem::Observable::stress_ratio)),
            100 * std::hypot(std::sqrt(squares(1)),
                             typical_error(laboratory, dem::Observable::solid_fraction))};
}

namespace {

Outcome::Added added(const StudyInput& input, const std::vector<std::string>& effects,
                     const Fidelity& fidelity) {
    const FittedStudy before = fitted_with(input.study, input.measurements, fidelity);
    Study more = input.study;
    for (const std::string& effect : effects) {
        more = plan_change(more, Action::add, effect).study;
    }
    const FittedStudy after =
        effects.empty() ? before : fitted_with(more, input.measurements, fidelity);
    const boost::math::chi_squared law(after.ladder_step.dof);
    return {.p = boost::math::cdf(boost::math::complement(law, after.ladder_step.chi2)),
            .rms_before = before.ladder_step.rms_percent,
            .rms_after = after.ladder_step.rms_percent,
            .scatter = scatter_of(input.measurements.readings),
            .left_out_before = before.ladder_step.left_out_percent.value(),
            .left_out_after = after.ladder_step.left_out_percent.value()};
}

}  // namespace

void diagnose_into(Outcome& outcome, const Truth& truth, const StudyDiagnosis& found) {
    const StudyModelSpace& models = *found.models;
    const Evidence& evidence = found.evidence;
    const Diagnosis& d = found.diagnosis;
    outcome.verdict = to_string(d.verdict);
    outcome.complete = d.complete;
    outcome.named = d.effects;
    outcome.suspects = d.suspects;
    outcome.chi2 = d.base.fit.chi2;
    outcome.dof = d.dof;
    std::vector<std::string> set;
    for (const FittedModel& each : d.confidence_set) {
        set.push_back(name_of(each, models, evidence));
        outcome.set_has_truth |= is_truth(each, models, truth);
    }
    outcome.set_size = set.size();
    outcome.confidence_set = fmt::format("{}", fmt::join(set, " | "));
    for (const Finding& finding : d.scan) {
        if (truth.hidden.size() == 1 && truth.hides(models.candidates()[finding.candidate].name)) {
            outcome.predicted_reduction = finding.test.predicted_reduction;
            outcome.refitted_reduction = finding.refitted_reduction;
        }
    }
    const Fit& fit = d.base.fit;
    outcome.pull = (fit.parameters(0) - truth.friction) / fit.standard_error(0);
}

std::uint64_t noise_seed(const Truth& truth, int study) {
    std::uint64_t seed =
        14695981039346656037u;  // the hash of Fowler, Noll and Vo: for ever the same
    for (const char letter : truth.name) {
        seed = (seed ^ static_cast<unsigned char>(letter)) * 1099511628211u;
    }
    return seed + static_cast<std::uint64_t>(study);
}

std::map<std::string, std::string> recordings_with_noise(LabResult laboratory, const Truth& truth,
                                                         int study) {
    for (std::size_t k = 0; k < laboratory.recordings.size(); ++k) {
        laboratory.recordings[k].seed =
            seed_of_run(noise_seed(truth, study), k, SeedDomain::instrument);
    }
    return study_files(laboratory);
}

Outcome walk(const Truth& truth, const LabResult& laboratory, int study,
             const std::filesystem::path& folder, const std::array<double, 2>& discrepancy) {
    const auto begun = std::chrono::steady_clock::now();
    write_whole_folder(folder, recordings_with_noise(laboratory, truth, study));
    Outcome outcome{.truth = truth.name, .study = study};
    StudyInput input = read_input(folder);
    Study stated = input.study;
    stated.model.discrepancy = discrepancy;
    stated.model.discrepancy_stated = true;
    input.study = input.study.changed_to(stated);
    const Fidelity& fidelity = laboratory.plan.fidelity;
    for (const Remark& finding : input.measurements.faults(true)) {
        const std::string kind = to_string(finding);
        if (std::ranges::find(outcome.faults, kind) == outcome.faults.end()) {
            outcome.faults.push_back(kind);
        }
    }
    diagnose_into(outcome, truth,
                  diagnose_study(input.study, input.measurements, {.fidelity = fidelity}));
    std::vector<std::string> hidden;
    for (const ActiveEffect& active : truth.hidden) {
        hidden.push_back(active.effect->name);
    }
    if (outcome.set_has_truth) {
        outcome.added = added(input, hidden, fidelity);
        outcome.added->noise =
            noise_of(input.measurements.readings, laboratory, folder.string() + " without noise");
    }
    std::filesystem::remove_all(folder);
    outcome.seconds =
        std::chrono::duration<double>(std::chrono::steady_clock::now() - begun).count();
    return outcome;
}

}  // namespace pendular::bench
