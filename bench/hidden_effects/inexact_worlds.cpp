#include "bench/hidden_effects/inexact_worlds.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <boost/math/distributions/binomial.hpp>
#include <chrono>
#include <cmath>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <random>

#include "analysis/diagnosis/side_by_side.h"
#include "bench/hidden_effects/foreign_world.h"
#include "bench/hidden_effects/judgement.h"
#include "bench/hidden_effects/rig.h"
#include "calib/model/discrepancy.h"
#include "data/files/write_whole.h"
#include "data/quantities/statistics.h"
#include "data/recordings/measurements.h"
#include "sim/lab/virtual_recording.h"
#include "workflow/study_diagnosis.h"
#include "workflow/study_input.h"

namespace pendular::bench {
namespace {

/// Relative standard deviations [1] of a reading's shear stress and solid fraction about their true
/// values. A gap is measured better than a torque, so that the means of two replicates show an
/// error of the model of 0.06 %.
constexpr std::array scatter = {0.015, 0.001};

/// World in which grains differ from the model. Sizes are standard deviations of relative errors
/// [1], first of the shear stress, second of the solid fraction.
struct World {
    std::string_view name;
    std::array<double, 2> independent, smooth;
    /// `ForeignWorld` whose states' errors about the emulator these are; empty: none.
    std::string_view foreign = "";
};
/// The solid fraction errs less in the ratio of the errors that independent codes have.
constexpr std::array worlds = {World{"exact", {0, 0}, {0, 0}},
                               World{"independent", {0.004, 0.0006}, {0, 0}},
                               World{"smooth", {0, 0}, {0.005, 0.00075}},
                               World{"both", {0.007, 0.001}, {0.007, 0.001}},
                               World{"lammps", {0, 0}, {0, 0}, "wet plain"},
                               World{"yade", {0, 0}, {0, 0}, "wet plain, dry of YADE"}};

using StatePoint = std::array<double, 3>;  ///< normal stress, inertial number, liquid content
StatePoint point_of(const Condition& c) {
    return {c.normal_stress, c.inertial_number, c.liquid_content};
}

/// Relative errors [1] of the model, the states of another code over the emulator's minus 1, of the
/// replicates at each condition; empty where the world has none.
using ForeignErrors = std::map<StatePoint, std::vector<Eigen::Vector2d>>;

/// Models of one friction, with which truths are predicted and studies diagnosed.
class Rig {
  public:
    explicit Rig(double friction)
        : plan(rig(friction, 1)), study(study_of(plan)), known(known_for(study)) {
        study.model.discrepancy = usual_discrepancy;  // as study.toml without a word
        simulation_ = std::make_shared<EmulatedSimulation>(
            study, truth_fidelity(), Emulator(known.runs, known.hyperparameters));
    }

    /// Readings of the truth without noise: a prediction, with its covariance, at the conditions
    /// of the plan.
    Prediction predict(const Truth& truth, const std::vector<Condition>& conditions) const {
        std::vector<const Effect*> effects;
        std::vector<double> parameters = {truth.friction};
        for (const ActiveEffect& active : truth.hidden) {
            effects.push_back(active.effect);
            for (std::size_t k = 0; k < active.values.size(); ++k) {
                if (active.effect->parameters[k].is_fitted())
                    parameters.push_back(active.values[k]);
            }
        }
        Study exact = study;
        exact.model.discrepancy = {0, 0};
        return assemble_model(exact, simulation_, effects)
            ->predict(Eigen::Map<Eigen::VectorXd>(parameters.data(),
                                                  static_cast<Eigen::Index>(parameters.size())),
                      conditions);
    }

    LabPlan plan;
    Study study;
    KnownRuns known;

  private:
    static KnownRuns known_for(const Study& study) {
        return known_runs(StudyModelSpace::with_all_effects(study), truth_fidelity(), nullptr)
            .value();
    }
    std::shared_ptr<const EmulatedSimulation> simulation_;
};

/// None if states of the world are missing in the table.
std::optional<ForeignErrors> foreign_errors(const World& world,
                                            const std::filesystem::path& states) {
    if (world.foreign.empty()) return ForeignErrors{};
    const std::vector<ForeignWorld> all = read_foreign_worlds(states);
    const auto plain = std::ranges::find(all, world.foreign, [](const ForeignWorld& each) {
        return std::string_view(each.truth.name);
    });
    if (plain == all.end()) return {};
    const LabPlan& plan = plain->laboratory.plan;
    const Study study = study_of(plan);
    KnownRuns known =
        known_runs(StudyModelSpace::with_all_effects(study), plan.fidelity, nullptr).value();
    const auto model =
        assemble_model(study,
                       std::make_shared<EmulatedSimulation>(
                           study, plan.fidelity, Emulator(known.runs, known.hyperparameters)),
                       {});
    ForeignErrors errors;
    for (const LabRecording& recording : plain->laboratory.recordings) {
        for (const LabStep& step : recording.steps) {
            const Eigen::VectorXd value = model
                                              ->predict(Eigen::VectorXd::Constant(1, plan.friction),
                                                        {step.condition}, PredictionPart::values)
                                              .value;
            using enum dem::Observable;
            errors[point_of(step.condition)].emplace_back(
                step.run[stress_ratio].value * step.condition.normal_stress / value(0) - 1,
                step.run[solid_fraction].value / value(1) - 1);
        }
    }
    return errors;
}

/// Draws what one study of a truth shows.
class Laboratory {
  public:
    Laboratory(const Rig& rig, const World& world, const ForeignErrors& foreign, std::uint64_t seed)
        : rig_(rig), world_(world), foreign_(foreign), random_(seed) {}

    Measurements measure(const Truth& truth) {
        std::vector<Condition> conditions = planned_conditions(rig_.plan);
        const Prediction exact = rig_.predict(truth, conditions);
        Eigen::VectorXd shown = exact.value + drawn(exact.covariance);
        add_error_of_model(conditions, shown);
        Measurements measurements;
        std::size_t at = 0;
        for (const PlannedRecording& recording : recordings_of(rig_.plan)) {
            for (std::size_t step = 0; step < recording.conditions.size(); ++step, ++at)
                measurements.readings.push_back(
                    reading(recording, step, conditions[at],
                            shown.segment<2>(2 * static_cast<Eigen::Index>(at))));
        }
        pool_replicates(measurements);
        return measurements;
    }

  private:
    double normal() { return normal_(random_); }
    Eigen::VectorXd drawn(Eigen::MatrixXd covariance) {
        covariance.diagonal() *= 1 + 1e-6;  // replicates are predicted alike
        const Eigen::MatrixXd lower = covariance.llt().matrixL();
        return lower * Eigen::VectorXd::NullaryExpr(covariance.rows(), [this] { return normal(); });
    }

    void add_error_of_model(const std::vector<Condition>& conditions, Eigen::VectorXd& shown) {
        std::vector<Condition> distinct;
        std::map<StatePoint, Eigen::Index> place;
        for (const Condition& condition : conditions) {
            if (place.try_emplace(point_of(condition), std::ssize(distinct)).second)
                distinct.push_back(condition);
        }
        Eigen::VectorXd errors = Eigen::VectorXd::Zero(2 * std::ssize(distinct));
        if (world_.smooth[0] > 0) errors += drawn(smooth_covariance(distinct));
        for (Eigen::Index k = 0; k < std::ssize(distinct); ++k) {
            for (const Eigen::Index o : {0, 1})
                errors(2 * k + o) += world_.independent[static_cast<std::size_t>(o)] * normal();
            if (!foreign_.empty()) {
                // Another mean of the replicates in each study, so that studies differ.
                const auto& of = foreign_.at(point_of(distinct[static_cast<std::size_t>(k)]));
                const double weight = std::uniform_real_distribution(0.25, 0.75)(random_);
                errors.segment<2>(2 * k) = weight * of.front() + (1 - weight) * of.back();
            }
        }
        for (std::size_t k = 0; k < conditions.size(); ++k)
            shown.segment<2>(2 * static_cast<Eigen::Index>(k)).array() *=
                1 + errors.segment<2>(2 * place.at(point_of(conditions[k]))).array();
    }

    /// Covariance of smooth relative errors: squared exponential in the logarithm of the normal
    /// stress and the roots of inertial number and liquid content. Lengths differ from those that
    /// the program assumes.
    Eigen::MatrixXd smooth_covariance(const std::vector<Condition>& conditions) const {
        const auto scaled = [](const Condition& c) {
            return Eigen::Vector3d(std::log(c.normal_stress) / 1.5,
                                   std::sqrt(c.inertial_number) / 0.15,
                                   std::sqrt(c.liquid_content) / 0.15);
        };
        const auto count = std::ssize(conditions);
        Eigen::MatrixXd covariance = Eigen::MatrixXd::Zero(2 * count, 2 * count);
        for (Eigen::Index a = 0; a < count; ++a) {
            for (Eigen::Index b = 0; b < count; ++b) {
                const double distance = (scaled(conditions[static_cast<std::size_t>(a)]) -
                                         scaled(conditions[static_cast<std::size_t>(b)]))
                                            .squaredNorm();
                for (const Eigen::Index o : {0, 1})
                    covariance(2 * a + o, 2 * b + o) =
                        std::pow(world_.smooth[static_cast<std::size_t>(o)], 2) *
                        std::exp(-distance / 2);
            }
        }
        return covariance;
    }

    Reading reading(const PlannedRecording& recording, std::size_t step, Condition condition,
                    const Eigen::Vector2d& shown) {
        const Eigen::Vector2d errors =
            Eigen::Vector2d(scatter[0] * shown(0), scatter[1] * shown(1));
        Reading reading{.origin = {recording.file, 1},
                        .step = static_cast<int>(step) + 1,
                        .condition = condition};
        reading.value = shown + Eigen::Vector2d(errors(0) * normal(), errors(1) * normal());
        reading.condition.height = height(reading.value(1), *rig_.study.cell);
        reading.within_run_only = true;
        const Eigen::Vector2d within = std::sqrt(Instrument{}.share_within) * errors;
        reading.covariance = within.cwiseAbs2().asDiagonal();
        return reading;
    }

    const Rig& rig_;
    const World& world_;
    const ForeignErrors& foreign_;
    std::mt19937_64 random_;
    std::normal_distribution<double> normal_;
};

/// All models with which studies are diagnosed.
struct Rigs {
    Rig plain{0.11}, rolling{0.3};
    const Rig& of(const Truth& truth) const {
        return truth.friction == plain.plan.friction ? plain : rolling;
    }
};

/// Name of a truth in a world, as outcomes have it.
std::string name_in(const World& world, const Truth& truth) {
    return fmt::format("{}: {}", world.name, truth.name);
}

Outcome outcome_of(const Rig& rig, const World& world, const ForeignErrors& foreign,
                   const Truth& truth, int study) {
    const auto begun = std::chrono::steady_clock::now();
    Truth named = truth;
    named.name = name_in(world, truth);
    Outcome outcome{.truth = named.name, .study = study};
    try {
        const Measurements measurements =
            Laboratory(rig, world, foreign, noise_seed(named, study)).measure(truth);
        diagnose_into(
            outcome, truth,
            diagnose_study(rig.study, measurements, {.fidelity = truth_fidelity()}, rig.known));
    } catch (const std::exception& error) {
        outcome.verdict = fmt::format("error: {}", error.what());
    }
    outcome.seconds =
        std::chrono::duration<double>(std::chrono::steady_clock::now() - begun).count();
    return outcome;
}

std::vector<Truth> truths_of(const InexactWorldsOptions& options) {
    std::vector<Truth> all = read_truths(options.truths);
    for (Truth& truth : read_truths(options.more_truths))
        all.push_back(std::move(truth));
    std::erase_if(all, [&](const Truth& truth) {
        // Two sizes of each effect: these readings show more than those for which they were chosen.
        return truth.name.ends_with(" at 25") ||
               (!options.hidden.empty() &&
                std::ranges::none_of(options.hidden, [&](const std::string& name) {
                    return truth.name.starts_with(name);
                }));
    });
    // Replicates share the error of the model at their condition, which they do not average out.
    std::array<double, 2> errors = scatter;
    for (std::size_t o = 0; o < errors.size(); ++o)
        errors[o] = std::hypot(scatter[o], std::sqrt(2.0) * usual_discrepancy[o]);
    set_separations(all, errors);
    return all;
}

/// Interval of 95 % of a rate (Clopper and Pearson), in per cent, as text.
std::string rate(std::ptrdiff_t of, std::ptrdiff_t all) {
    if (all == 0) return "-";
    using law = boost::math::binomial_distribution<double>;
    const auto n = static_cast<double>(all), k = static_cast<double>(of);
    return fmt::format("{}/{} = {:.1f} % ({:.1f} to {:.1f})", of, all, 100 * k / n,
                       100 * law::find_lower_bound_on_p(n, k, 0.025),
                       100 * law::find_upper_bound_on_p(n, k, 0.025));
}

std::string text_of(const World& world, const Studies& studies) {
    const auto kind = [](const LabStudy& s) { return s.truth->kind; };
    Studies complete, hidden, separated, outside;
    for (const LabStudy& s : studies) {
        if (kind(s) == Truth::Kind::complete)
            complete.push_back(s);
        else if (kind(s) == Truth::Kind::outside)
            outside.push_back(s);
        else
            hidden.push_back(s);
        constexpr double well_apart = 26;
        if (kind(s) == Truth::Kind::effect && s.truth->separation >= well_apart)
            separated.push_back(s);
    }
    const auto counted = [](const Studies& of, const auto& test) {
        return rate(std::ranges::count_if(of, test), std::ssize(of));
    };
    const auto failed = [](const LabStudy& s) { return s.outcome->verdict.starts_with("error"); };
    Studies noticed;
    std::ranges::copy_if(hidden, std::back_inserter(noticed), alarms);
    std::vector<double> pulls, seconds;
    for (const LabStudy& s : complete)
        pulls.push_back(s.outcome->pull.value_or(0));
    for (const LabStudy& s : studies)
        seconds.push_back(s.outcome->seconds);
    double square = 0;
    for (const double pull : pulls)
        square += pull * pull / static_cast<double>(pulls.size());
    std::string text = fmt::format("{}\n", world.name);
    const auto line = [&](std::string_view what, const std::string& value) {
        text += fmt::format("  {:<54} {}\n", what, value);
    };
    line("alarms where nothing is hidden", counted(complete, alarms));
    line("error of the friction there over its standard error",
         fmt::format("{:.2f}", std::sqrt(square)));
    line("confidently wrong, of all", counted(studies, confidently_wrong));
    line("noticed, of hidden effects of the catalogue", counted(hidden, alarms));
    line("truth among what is named, of those noticed", counted(noticed, [](const LabStudy& s) {
             return points_at_truth(s) || s.outcome->set_has_truth;
         }));
    line("right and alone, of those well apart from all others", counted(separated, right));
    line("unknown effects flagged", counted(outside, flagged));
    line("unknown effects that raise an alarm", counted(outside, alarms));
    line("ended in an error", counted(studies, failed));
    line("median time of a study [s]", fmt::format("{:.2f}", median(seconds)));
    return text + "\n";
}

}  // namespace

void inexact_worlds(const InexactWorldsOptions& options) {
    const std::vector<Truth> truths = truths_of(options);
    const Rigs rigs;
    const std::filesystem::path file = options.work / "outcomes.csv";
    std::filesystem::create_directories(options.work);
    std::vector<Outcome> outcomes = read_outcomes(file);
    std::mutex guard;
    std::string text = "pendular-bench inexact-worlds, pendular " PENDULAR_VERSION "\n\n";
    for (const World& world : worlds) {
        if (!options.only.empty() &&
            std::ranges::find(options.only, world.name) == options.only.end())
            continue;
        const std::optional<ForeignErrors> foreign = foreign_errors(world, options.states);
        if (!foreign) {
            fmt::print(stderr, "{} is left out: {} lacks its states\n", world.name,
                       options.states.string());
            continue;
        }
        struct Task {
            const Truth* truth;
            int study;
        };
        std::vector<Task> tasks;
        for (const Truth& truth : truths) {
            const bool complete = truth.kind == Truth::Kind::complete;
            for (int k = 0; k < (complete ? options.complete_studies : options.studies); ++k) {
                if (std::ranges::none_of(outcomes, [&](const Outcome& one) {
                        return one.study == k && one.truth == name_in(world, truth);
                    }))
                    tasks.push_back({&truth, k});
            }
        }
        side_by_side(
            tasks.size(), static_cast<std::size_t>(options.threads), [](std::size_t) {},
            [&](std::size_t k) {
                Outcome outcome = outcome_of(rigs.of(*tasks[k].truth), world, *foreign,
                                             *tasks[k].truth, tasks[k].study);
                const std::lock_guard lock(guard);
                fmt::print(stderr, "{} of {}: {}, study {}: {} {} ({:.1f} s)\n", k, tasks.size(),
                           outcome.truth, outcome.study, outcome.verdict,
                           fmt::join(outcome.named, ", "), outcome.seconds);
                outcomes.push_back(std::move(outcome));
                write_outcomes(file, outcomes);
            });
        Studies studies;
        for (const Truth& truth : truths) {
            for (const Outcome& outcome : outcomes)
                if (outcome.truth == name_in(world, truth)) studies.push_back({&truth, &outcome});
        }
        text += text_of(world, studies);
    }
    std::ranges::sort(outcomes, {}, [](const Outcome& o) { return std::pair(o.truth, o.study); });
    write_outcomes(options.results / "inexact_worlds_studies.csv", outcomes);
    write_whole(options.results / "inexact_worlds.txt", text);
    fmt::print("{}", text);
}

}  // namespace pendular::bench
