#include "calib/model/mohr_coulomb.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "calib/model/closure_model.h"
#include "calib/model/study_state.h"
#include "data/input_error.h"
#include "sim/catalogue/effect_catalogue.h"

namespace pendular {
namespace {

/// Relative tolerance of the liquid contents that share a cohesion [1], as in `wet_groups`.
constexpr double content_tolerance = 0.02;

/// Whether P* is one to which a line is fitted, up to rounding by the conversion from stresses.
bool on_line(double reduced_pressure) {
    constexpr double rounding = 1e-9;
    return reduced_pressure >= lowest_cohesion_pressure * (1 - rounding);
}

bool same_content(const CohesionGroup& group, const MeasuredStrength& strength) {
    const double first = group.strengths.front().condition.liquid_content;
    return std::abs(strength.condition.liquid_content - first) <= content_tolerance * first;
}

/// Whether the cohesion adds the same stress at two conditions. It does not depend on the inertial
/// number, so that its error cancels where a fitted reading is brought to another one.
bool same_cohesive_stress(const Condition& a, const Condition& b) {
    return a.normal_stress == b.normal_stress && a.liquid_content == b.liquid_content &&
           a.at_failure == b.at_failure;
}

}  // namespace

std::vector<CohesionGroup> cohesion_groups(const ModelSettings& model,
                                           const GrainProperties& grains,
                                           const std::optional<Liquid>& liquid) {
    std::vector<CohesionGroup> groups;
    if (!liquid) return groups;
    for (const MeasuredStrength& strength : model.strengths) {
        if (!on_line(reduced_pressure(strength.condition.normal_stress, grains, *liquid))) continue;
        const auto home = std::ranges::find_if(
            groups, [&](const CohesionGroup& group) { return same_content(group, strength); });
        (home == groups.end() ? groups.emplace_back() : *home).strengths.push_back(strength);
    }
    for (CohesionGroup& group : groups) {
        for (const MeasuredStrength& strength : group.strengths) {
            group.liquid_content +=
                strength.condition.liquid_content / static_cast<double>(group.strengths.size());
        }
    }
    std::ranges::sort(groups, {}, &CohesionGroup::liquid_content);
    return groups;
}

MohrCoulombModel::MohrCoulombModel(std::shared_ptr<const EmulatedSimulation> simulation,
                                   const Study& study)
    : simulation_(std::move(simulation)), study_(study) {
    for (const CohesionGroup& group : cohesion_groups(study.model, study.grains, study.liquid)) {
        Line line{.liquid_content = group.liquid_content};
        line.weight.resize(std::ssize(group.strengths));
        double information = 0;
        Eigen::Index i = 0;
        for (const MeasuredStrength& strength : group.strengths) {
            const double inverse = inverse_pressure_of(strength.condition, study),
                         weight = std::pow(strength.standard_error, -2);
            information += weight * inverse * inverse;
            line.constant += weight * inverse * strength.stress_ratio;
            line.weight(i++) = weight * inverse / strength.condition.normal_stress;
            line.fitted.push_back(strength.condition);
            line.conditions.push_back(strength.condition);
            line.conditions.back().liquid_content = 0;
        }
        line.constant /= information;
        line.weight /= information;
        line.variance = 1 / information;
        lines_.push_back(std::move(line));
    }
    if (lines_.empty()) {
        throw InputError({study.file.string()},
                         fmt::format("base = \"mohr-coulomb\" fits a cohesion to wet readings at "
                                     "reduced pressures of {} and more, and there are none: add "
                                     "such readings, or choose base = \"dem\" or \"rumpf\"",
                                     lowest_cohesion_pressure));
    }
}

std::size_t MohrCoulombModel::line_at(double liquid_content) const {
    const auto distance = [&](const Line& line) {
        return std::abs(std::log(line.liquid_content / liquid_content));
    };
    return static_cast<std::size_t>(std::ranges::min_element(lines_, {}, distance) -
                                    lines_.begin());
}

std::vector<EffectiveCondition> MohrCoulombModel::dry_conditions() const {
    std::vector<EffectiveCondition> all;
    for (const Line& line : lines_) {
        all.insert(all.end(), line.conditions.begin(), line.conditions.end());
    }
    return all;
}

std::vector<std::pair<double, double>> MohrCoulombModel::cohesions(double friction) const {
    const Eigen::VectorXd dry = simulation_
                                    ->predict_flow(Eigen::VectorXd::Constant(1, friction),
                                                   dry_conditions(), PredictionPart::values)
                                    .value;
    std::vector<std::pair<double, double>> result;
    Eigen::Index next = 0;
    for (const Line& line : lines_) {
        double cohesion = line.constant;
        for (Eigen::Index i = 0; i < line.weight.size(); ++i, next += 2) {
            cohesion -= line.weight(i) * dry(next);
        }
        result.emplace_back(line.liquid_content, cohesion);
    }
    return result;
}

Prediction MohrCoulombModel::predict_flow(const Eigen::VectorXd& parameters,
                                          const std::vector<EffectiveCondition>& conditions,
                                          PredictionPart what) const {
    // Predictions at the conditions, at their dry twins and at the strengths; the stress of a wet
    // condition is linear in these.
    std::vector<EffectiveCondition> all = with_dry_twins(conditions);
    const auto n = static_cast<Eigen::Index>(conditions.size());
    auto next = 2 * static_cast<Eigen::Index>(all.size());
    std::vector<Eigen::Index> first;  // entry of each line's first strength
    for (const Line& line : lines_) {
        first.push_back(next);
        next += 2 * line.weight.size();
    }
    const std::vector<EffectiveCondition> dry = dry_conditions();
    all.insert(all.end(), dry.begin(), dry.end());
    const Prediction simulated = simulation_->predict_flow(parameters, all, what);

    Eigen::MatrixXd map = Eigen::MatrixXd::Identity(2 * n, simulated.value.size());
    Eigen::VectorXd constant = Eigen::VectorXd::Zero(2 * n);
    Eigen::MatrixXd by_cohesion =
        Eigen::MatrixXd::Zero(2 * n, static_cast<Eigen::Index>(lines_.size()));
    Eigen::Index twin = 2 * n;
    for (Eigen::Index k = 0; k < n; ++k) {
        const EffectiveCondition& condition = conditions[static_cast<std::size_t>(k)];
        if (condition.dry()) continue;
        const std::size_t which = line_at(condition.liquid_content);
        const Line& line = lines_[which];
        const double unit =
            condition.normal_stress * inverse_pressure_of(condition, study_);  // F0/a^2 [Pa]
        map(2 * k, 2 * k) = 0;
        map(2 * k, twin) = 1;
        for (Eigen::Index i = 0; i < line.weight.size(); ++i) {
            map(2 * k, first[which] + 2 * i) -= unit * line.weight(i);
        }
        constant(2 * k) = unit * line.constant;
        const bool fitted = std::ranges::any_of(line.fitted, [&](const Condition& one) {
            return same_cohesive_stress(one, condition);
        });
        if (!fitted) {
            by_cohesion(2 * k, static_cast<Eigen::Index>(which)) = unit * std::sqrt(line.variance);
        }
        twin += 2;
    }
    Prediction result{.value = map * simulated.value + constant,
                      .jacobian = {},
                      .covariance = {},
                      .run_noise = {}};
    if (what != PredictionPart::values) result.jacobian = map * simulated.jacobian;
    if (simulated.covariance.size() > 0) {
        result.covariance =
            map * simulated.covariance * map.transpose() + by_cohesion * by_cohesion.transpose();
        result.run_noise = map * simulated.run_noise * map.transpose();
    }
    return result;
}

int fitted_cohesions(const ModelSettings& model, const GrainProperties& grains,
                     const std::optional<Liquid>& liquid) {
    Study study{.grains = grains, .liquid = liquid, .model = model};
    if (level_of(study) != closures::Level::mohr_coulomb) return 0;
    return static_cast<int>(cohesion_groups(model, grains, liquid).size());
}

Study with_strengths(Study study, const std::vector<Reading>& readings) {
    if (study.model.base != "mohr-coulomb") return study;
    study.model.strengths.clear();
    for (const Reading& reading : readings) {
        if (reading.condition.dry() || reading.condition.at_failure) continue;
        study.model.strengths.push_back(
            {reading.condition, reading.stress_ratio(),
             std::sqrt(reading.covariance(0, 0)) / reading.condition.normal_stress});
    }
    return study;
}

}  // namespace pendular
