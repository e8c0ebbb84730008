#include "bench/hidden_effects/rig.h"

#include <fmt/format.h>

#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <memory>
#include <optional>
#include <tuple>

#include "analysis/diagnosis/signature.h"
#include "analysis/misfit/weighted_residuals.h"
#include "calib/model/study_model_space.h"
#include "sim/lab/virtual_recording.h"
#include "workflow/study_input.h"

namespace pendular::bench {
namespace {

constexpr double plain_friction = 0.11;
/// Rolling resistance does little where beads slide easily.
constexpr double rolling_friction = 0.3;
/// An effect whose bounds do not let it reach this is not hidden: nobody could find it.
constexpr double least_noncentrality = 5;

/// The model of the benchmark's readings and what a change of its predictions amounts to.
class Design {
  public:
    /// Design whose readings scatter by these relative standard deviations [1] in shear stress and
    /// solid fraction.
    Design(double friction, const std::array<double, 2>& scatter)
        : plan_(rig(friction, 1)), study_(study_of(plan_)), conditions_(planned_conditions(plan_)) {
        KnownRuns known =
            known_runs(StudyModelSpace::with_all_effects(study_), truth_fidelity(), nullptr)
                .value();
        models_ = std::make_unique<StudyModelSpace>(study_, conditions_, truth_fidelity(), known);
        simulation_ = std::make_shared<EmulatedSimulation>(
            study_, truth_fidelity(), Emulator(known.runs, std::move(known.hyperparameters)));
        const Eigen::VectorXd parameters = Eigen::VectorXd::Constant(1, friction);
        const Prediction prediction = models_->with({})->predict(parameters);
        Measured measured{.value = prediction.value, .covariance = {}};
        Eigen::VectorXd errors = prediction.value;
        for (Eigen::Index k = 0; k < errors.size(); k += 2) {
            errors(k) *= scatter[0];
            errors(k + 1) *= scatter[1];
        }
        measured.covariance = errors.cwiseAbs2().asDiagonal();
        residuals_ = std::make_unique<WeightedResiduals>(measured, prediction);
        for (std::size_t k = 0; k < models_->candidates().size(); ++k) {
            const Addition addition(*models_, {}, k, parameters, prediction.value);
            const Signature signature = addition.signature(false);
            signatures_.push_back(residuals_->project(residuals_->whiten(signature.change)));
            one_sided_.push_back(signature.one_sided);
        }
        base_ = prediction.value;
    }

    const StudyModelSpace& models() const { return *models_; }
    /// Its first parameter; neutral where the study has it.
    const EffectParameter& parameter_of(const Effect& effect) const {
        const auto& all = models_->candidates();
        const auto found = std::ranges::find(all, effect.name, &Candidate::name);
        return (found == all.end() ? effect.parameters : found->parameters).front();
    }

    /// Change of the readings by an effect of this size, in standard errors, with the friction
    /// refitted.
    Eigen::VectorXd change(const Effect& effect, const std::vector<double>& values) const {
        const auto model = assemble_model(study_, simulation_, {&effect});
        std::vector<double> parameters = {plan_.friction};
        for (std::size_t k = 0; k < values.size(); ++k) {
            if (effect.parameters[k].is_fitted()) parameters.push_back(values[k]);
        }
        const Eigen::VectorXd all = Eigen::Map<Eigen::VectorXd>(
            parameters.data(), static_cast<Eigen::Index>(parameters.size()));
        return residuals_->project(residuals_->whiten(
            model->predict(all, conditions_, PredictionPart::values).value - base_));
    }

    /// Part of a change that the best pair of the catalogue's effects does not explain.
    double beyond_pairs(const Eigen::VectorXd& changed) const {
        double least = changed.squaredNorm();
        for (std::size_t i = 0; i < signatures_.size(); ++i) {
            for (std::size_t j = i + 1; j < signatures_.size(); ++j) {
                Eigen::MatrixXd both(changed.size(), signatures_[i].cols() + signatures_[j].cols());
                both << signatures_[i], signatures_[j];
                if (!both.allFinite()) continue;
                const Eigen::VectorXd amplitudes = both.colPivHouseholderQr().solve(changed);
                least = std::min(least, (changed - both * amplitudes).squaredNorm());
            }
        }
        return least;
    }

    /// v (1 - cos^2) about the other effect that is most like a change, and its name.
    std::pair<double, std::string> separation(const Eigen::VectorXd& changed,
                                              const std::string& but) const {
        std::pair<double, std::string> least{changed.squaredNorm(), ""};
        for (std::size_t k = 0; k < signatures_.size(); ++k) {
            const std::string& name = models_->candidates()[k].name;
            const Eigen::VectorXd other = signatures_[k].col(0);
            if (name == but || !other.allFinite() || other.norm() == 0) continue;
            const double along = other.normalized().dot(changed);
            if (one_sided_[k] && along < 0) continue;  // it can do the opposite only
            const double left = changed.squaredNorm() - along * along;
            if (left < least.first) least = {left, name};
        }
        return least;
    }

  private:
    LabPlan plan_;
    Study study_;
    std::vector<Condition> conditions_;
    std::unique_ptr<StudyModelSpace> models_;
    std::shared_ptr<const EmulatedSimulation> simulation_;
    std::unique_ptr<WeightedResiduals> residuals_;
    std::vector<Eigen::MatrixXd> signatures_;
    std::vector<bool> one_sided_;
    Eigen::VectorXd base_;
};

/// Design whose readings scatter as the benchmark's instrument does.
Design planned_design(double friction) {
    const double noise = rig(friction, 1).instrument.noise;
    return {friction, {noise * torque_scatter, noise * solid_fraction_scatter}};
}

double rounded(double value) {
    return std::stod(fmt::format("{:.3g}", value));
}

double noncentrality_of(const Design& design, const Effect& effect, double value, bool outside) {
    try {
        const Eigen::VectorXd changed = design.change(effect, {value});
        const double v = outside ? design.beyond_pairs(changed) : changed.squaredNorm();
        return std::isfinite(v) ? v : INFINITY;
    } catch (const std::domain_error&) {
        return INFINITY;  // more than anything real could show
    }
}

/// Value of the first parameter at which v is as wanted, towards the farther bound; that bound
/// where it is never reached. By secants: v goes with a power of the distance from neutral.
double value_reaching(const Design& design, const Effect& effect, double wanted, bool outside) {
    const EffectParameter& p = design.parameter_of(effect);
    const double room =
        p.upper - p.neutral >= p.neutral - p.lower ? p.upper - p.neutral : p.lower - p.neutral;
    double distance = room > 0 ? p.smallest_of_interest : -p.smallest_of_interest, power = 2,
           before = 0, v_before = 0;
    for (int turn = 0; turn < 20; ++turn) {
        distance = room > 0 ? std::min(distance, room) : std::max(distance, room);
        const double v = noncentrality_of(design, effect, p.neutral + distance, outside);
        if (std::abs(v / wanted - 1) < 0.005 || (distance == room && v < wanted)) break;
        if (before != 0 && distance != before && v > 0) {
            power = std::clamp(std::log(v / v_before) / std::log(distance / before), 1.0, 8.0);
        }
        before = distance, v_before = v;
        distance *= std::clamp(std::pow(wanted / v, 1 / power), 0.2, 5.0);
    }
    return p.neutral + rounded(distance);
}

Truth truth_of(const Design& design, const Effect& effect, std::vector<double> values,
               const std::string& name, bool outside) {
    Truth truth{.kind = outside ? Truth::Kind::outside : Truth::Kind::effect,
                .name = name,
                .hidden = {{&effect, values}}};
    const Eigen::VectorXd changed = design.change(effect, values);
    truth.noncentrality = outside ? design.beyond_pairs(changed) : changed.squaredNorm();
    std::tie(truth.separation, truth.most_like) = design.separation(changed, effect.name);
    return truth;
}

void add_effect(const Design& design, const Effect& effect, double friction, bool outside,
                const std::vector<double>& noncentralities, std::vector<Truth>& truths) {
    std::vector<std::pair<std::vector<double>, std::string>> sizes;
    if (effect.is_switch()) {
        sizes = {{std::vector<double>(effect.parameters.size(), 1.0), effect.name}};
    } else {
        for (const double wanted : noncentralities) {
            const double value = value_reaching(design, effect, wanted, outside);
            const bool reached = noncentrality_of(design, effect, value, outside) > 0.9 * wanted;
            sizes.push_back(
                {{value}, reached ? fmt::format("{} at {:g}", effect.name, wanted) : effect.name});
        }
    }
    for (auto& [values, name] : sizes) {
        Truth truth = truth_of(design, effect, values, name, outside);
        truth.friction = friction;
        const bool again = !truths.empty() && truths.back().hidden.size() == 1 &&
                           truths.back().hidden[0].effect == &effect &&
                           truths.back().hidden[0].values == values;
        if (truth.noncentrality >= least_noncentrality && !again) {
            truths.push_back(std::move(truth));
        } else {
            fmt::print(stderr, "{}: left out, v = {:.3g}\n", name, truth.noncentrality);
        }
    }
}

void add_pair(const std::string& one, const std::string& other, std::vector<Truth>& truths) {
    const auto largest = [&](const std::string& effect) -> const Truth* {
        const auto found = std::ranges::find_if(
            truths.rbegin(), truths.rend(),
            [&](const Truth& t) { return t.kind == Truth::Kind::effect && t.hides(effect); });
        return found == truths.rend() ? nullptr : &*found;
    };
    const Truth *first = largest(one), *second = largest(other);
    if (!first || !second) return;
    Truth both = *first;
    both.kind = Truth::Kind::pair;
    both.name = fmt::format("{} and {}", one, other);
    both.hidden.push_back(second->hidden.front());
    both.noncentrality = std::min(first->noncentrality, second->noncentrality);
    both.separation = 0;
    both.most_like.clear();
    truths.push_back(std::move(both));
}

}  // namespace

std::vector<Truth> planned_truths(const std::vector<double>& noncentralities) {
    std::vector<Truth> truths = {{.name = "complete", .friction = plain_friction}};
    std::optional<Design> plain(planned_design(plain_friction));
    for (const Effect& effect : built_in_effects()) {
        const auto& offered = plain->models().candidates();
        if (std::ranges::find(offered, effect.name, &Candidate::name) == offered.end()) continue;
        fmt::print(stderr, "{}\n", effect.name);
        if (effect.name == "rolling-resistance") {
            add_effect(planned_design(rolling_friction), effect, rolling_friction, false,
                       noncentralities, truths);
        } else {
            add_effect(*plain, effect, plain_friction, false, noncentralities, truths);
        }
    }
    add_pair("wet-friction", "torque-gain", truths);
    add_pair("wall-friction", "lid-slip", truths);
    add_pair("capillary-coulomb", "normal-force-offset", truths);
    for (const Effect& effect : outside_effects()) {
        fmt::print(stderr, "{}\n", effect.name);
        add_effect(*plain, effect, plain_friction, true, {noncentralities.back()}, truths);
    }
    return truths;
}

std::vector<Truth> planned_outside_truths(const std::vector<double>& noncentralities) {
    std::vector<Truth> truths;
    const Design plain = planned_design(plain_friction);
    for (const OutsideEffect& outside : more_outside_effects()) {
        fmt::print(stderr, "{}\n", outside.effect.name);
        add_effect(plain, outside.effect, plain_friction, true, noncentralities, truths);
    }
    return truths;
}

void set_separations(std::vector<Truth>& truths, const std::array<double, 2>& scatter) {
    std::map<double, Design> designs;
    for (Truth& truth : truths) {
        if (truth.kind != Truth::Kind::effect) continue;
        const Design& design =
            designs.try_emplace(truth.friction, truth.friction, scatter).first->second;
        const ActiveEffect& hidden = truth.hidden.front();
        const Eigen::VectorXd changed = design.change(*hidden.effect, hidden.values);
        truth.noncentrality = changed.squaredNorm();
        std::tie(truth.separation, truth.most_like) =
            design.separation(changed, hidden.effect->name);
    }
}

}  // namespace pendular::bench
