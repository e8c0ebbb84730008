#include "calib/model/effect_model.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "calib/model/discrepancy.h"
#include "data/input_error.h"
#include "sim/catalogue/instrument.h"

namespace pendular {
namespace {

/// Starting value of an effect's parameter in a fit: distance from neutral, where some effects have
/// no slope, over the smallest effect of interest [1]. Chosen: small, so that the readings stay
/// possible.
constexpr double start_share = 0.3;
/// Step of the central difference quotients, whose error goes as its square, over the smallest
/// effect of interest [1].
constexpr double step_share = 1e-3;

/// Solid fraction and stress ratio assumed for the cell as shown [1]: the fraction for readings
/// without a height, the ratio for the torque. Dry flows of frictions up to 0.4 have 0.59 to 0.64
/// and 0.13 to 0.35 (docs/validation.md, An independent code).
constexpr double typical_solid_fraction = 0.6, typical_stress_ratio = 0.3;
/// Cell of a study without one [m, m^3]: only ratios of its states matter.
constexpr AnnularCell typical_cell{.inner_radius = 0.02, .outer_radius = 0.04, .bead_volume = 1e-5};

double start_of(const Effect& effect, const EffectParameter& p, const Study& study) {
    if (effect.given_by_liquid && study.liquid) {
        return effect.unlisted_value(study.liquid);
    }
    return std::clamp(p.neutral + start_share * p.smallest_of_interest, p.lower, p.upper);
}

}  // namespace

/// True states of the cell at the conditions that the instrument shows.
struct EffectModel::Truths {
    std::vector<ActiveEffect> effects;
    /// Instrument map of each reading; empty where no instrument effect touches the reading.
    std::vector<InstrumentMap> maps;
    std::vector<CellState> states;  ///< true state for each reading; default where its map is empty
    std::vector<Condition> shown;   ///< conditions as recorded
    std::vector<EffectiveCondition> imposed;  ///< true conditions, passed to the inner model
};

EffectModel::EffectModel(std::shared_ptr<const FlowPredictor> inside, const Study& study,
                         std::vector<const Effect*> effects)
    : inside_(std::move(inside)),
      study_(study),
      effects_(std::move(effects)),
      parameters_(inside_->parameters()),
      uncertainties_(shared_uncertainties(study)) {
    std::erase_if(uncertainties_, [this](const SharedUncertainty& each) {
        return std::ranges::any_of(
            effects_, [&](const Effect* effect) { return each.is_fitted_by(*effect); });
    });
    for (const Effect* effect : effects_) {
        for (const EffectParameter& p : effect->parameters) {
            if (p.is_fitted()) {
                parameters_.push_back({.name = fmt::format("{}.{}", effect->name, p.name),
                                       .unit = p.unit,
                                       .lower = p.lower,
                                       .upper = p.upper,
                                       .start = start_of(*effect, p, study)});
            }
        }
    }
}

bool EffectModel::has_instrument() const {
    return std::ranges::any_of(effects_, &Effect::of_instrument);
}

bool EffectModel::changes_grains() const {
    return std::ranges::any_of(effects_, &Effect::of_grains);
}

std::vector<ActiveEffect> EffectModel::effects_at(const Eigen::VectorXd& parameters) const {
    std::vector<ActiveEffect> active;
    auto next = static_cast<Eigen::Index>(inside_->parameters().size());
    for (const Effect* effect : effects_) {
        std::vector<double> values;
        for (const EffectParameter& p : effect->parameters) {
            values.push_back(p.is_fitted() ? parameters(next++) : p.value_if_not_fitted());
        }
        active.push_back({effect, std::move(values)});
    }
    return active;
}

AnnularCell EffectModel::cell() const {
    AnnularCell cell = study_.cell.value_or(typical_cell);
    if (cell.bead_volume == 0) cell.bead_volume = typical_cell.bead_volume;
    return cell;
}

EffectModel::Truths EffectModel::truths_with(std::vector<ActiveEffect> effects,
                                             const std::vector<Condition>& conditions,
                                             const Truths* near) const {
    Truths truths{.effects = std::move(effects),
                  .maps = {},
                  .states = {},
                  .shown = conditions,
                  .imposed = {}};
    for (std::size_t k = 0; k < conditions.size(); ++k) {
        const Condition& condition = conditions[k];
        Condition imposed = condition;
        InstrumentMap map;
        if (!condition.ideal_instrument) map = InstrumentMap(touching(truths.effects, condition));
        CellState state;
        if (!map.empty()) {
            state = map.truth(shown_state(condition, typical_stress_ratio * condition.normal_stress,
                                          typical_solid_fraction, cell(), study_.grains),
                              near && !near->maps[k].empty() ? &near->states[k] : nullptr);
            imposed = true_condition(condition, state, map);
        }
        truths.imposed.push_back(changed_condition(imposed, truths.effects, study_.liquid));
        truths.maps.push_back(std::move(map));
        truths.states.push_back(state);
    }
    return truths;
}

EffectModel::Truths EffectModel::truths_at(const Eigen::VectorXd& parameters,
                                           const std::vector<Condition>& conditions,
                                           const Truths* near) const {
    return truths_with(effects_at(parameters), conditions, near);
}

std::vector<EffectiveCondition> EffectModel::imposed(
    const Eigen::VectorXd& parameters, const std::vector<Condition>& conditions) const {
    return truths_at(parameters, conditions).imposed;
}

Eigen::VectorXd EffectModel::shown(const Truths& truths, const Eigen::VectorXd& predicted) const {
    Eigen::VectorXd result = predicted;
    for (std::size_t k = 0; k < truths.maps.size(); ++k) {
        const auto at = 2 * static_cast<Eigen::Index>(k);
        Eigen::Vector2d reading = predicted.segment<2>(at);
        const Condition& imposed = truths.imposed[k];
        for (const ActiveEffect& active : touching(truths.effects, truths.shown[k])) {
            if (const auto* change = std::get_if<ChangeFlow>(&active.effect->change)) {
                const FlowPoint point = change->change(
                    {reading(0) / imposed.normal_stress, reading(1)}, imposed, active.by_name());
                reading << point.stress_ratio * imposed.normal_stress, point.solid_fraction;
            }
        }
        if (!truths.maps[k].empty()) {
            reading = shown_reading(reading, truths.states[k], truths.maps[k], cell());
        }
        result.segment<2>(at) = reading;
    }
    return result;
}

Eigen::SparseMatrix<double> EffectModel::shown_by_predicted(
    const Truths& truths, const Eigen::VectorXd& predicted) const {
    // Each reading depends on its own two predictions only, so that all readings are varied at
    // once.
    const Eigen::Index n = predicted.size();
    std::vector<Eigen::Triplet<double>> slopes;
    constexpr double step = 1e-5;  // about the cube root of rounding errors: best for this quotient
    for (const Eigen::Index of : {0, 1}) {
        Eigen::VectorXd above = predicted, below = predicted;
        for (Eigen::Index k = of; k < n; k += 2) {
            above(k) *= 1 + step;
            below(k) *= 1 - step;
        }
        const Eigen::VectorXd difference = shown(truths, above) - shown(truths, below);
        for (Eigen::Index k = 0; k < n; k += 2) {
            for (const Eigen::Index row : {0, 1}) {
                slopes.emplace_back(k + row, k + of,
                                    difference(k + row) / (above(k + of) - below(k + of)));
            }
        }
    }
    Eigen::SparseMatrix<double> result(n, n);
    result.setFromTriplets(slopes.begin(), slopes.end());
    return result;
}

class EffectModel::Nearby {
  public:
    Nearby(const EffectModel& model, const Eigen::VectorXd& parameters, const Truths& truths,
           const Eigen::VectorXd& predicted)
        : model_(model),
          own_(model.inside_parameters(parameters)),
          truths_(truths),
          predicted_(predicted) {}

    /// Returns the shown values for truths near those given; the inner model predicts again only at
    /// conditions that changed.
    /// @param own parameters of the inner model
    Eigen::VectorXd shown(const Truths& there, const Eigen::VectorXd& own) const {
        std::vector<EffectiveCondition> changed;
        std::vector<std::size_t> places;
        for (std::size_t k = 0; k < truths_.imposed.size(); ++k) {
            if (own != own_ || !(there.imposed[k] == truths_.imposed[k])) {
                changed.push_back(there.imposed[k]);
                places.push_back(k);
            }
        }
        Eigen::VectorXd values = predicted_;
        if (!changed.empty()) {
            if (!nearby_) nearby_ = model_.inside_->neighbourhood(own_, truths_.imposed);
            const Eigen::VectorXd anew = nearby_->values(own, changed, places);
            for (std::size_t k = 0; k < places.size(); ++k) {
                values.segment<2>(2 * static_cast<Eigen::Index>(places[k])) =
                    anew.segment<2>(2 * static_cast<Eigen::Index>(k));
            }
        }
        return model_.shown(there, values);
    }
    /// Returns the shown values with the parameters of the inner model unchanged.
    Eigen::VectorXd shown(const Truths& there) const { return shown(there, own_); }

  private:
    const EffectModel& model_;
    Eigen::VectorXd own_;
    const Truths& truths_;
    const Eigen::VectorXd& predicted_;
    mutable std::unique_ptr<const FlowNeighbourhood> nearby_;
};

void EffectModel::add_slopes(const Eigen::VectorXd& parameters,
                             const std::vector<Condition>& conditions, const Truths& truths,
                             const Nearby& nearby, Prediction& result) const {
    const auto inside = static_cast<Eigen::Index>(inside_->parameters().size());
    // Truths where the parameters of effects on the instrument are those of `truths`.
    const auto with_same_instrument = [&](const Eigen::VectorXd& at) {
        Truths there = truths;
        there.effects = effects_at(at);
        for (std::size_t k = 0; k < conditions.size(); ++k) {
            const Condition imposed =
                true_condition(conditions[k], truths.states[k], truths.maps[k]);
            there.imposed[k] = changed_condition(imposed, there.effects, study_.liquid);
        }
        return there;
    };
    const auto values_at = [&](const Eigen::VectorXd& at, bool of_instrument) {
        return nearby.shown(
            of_instrument ? truths_at(at, conditions, &truths) : with_same_instrument(at),
            inside_parameters(at));
    };
    const auto quotient = [&](Eigen::Index k, double step, bool of_instrument) {
        const Parameter& p = parameters_[static_cast<std::size_t>(k)];
        Eigen::VectorXd above = parameters, below = parameters;
        above(k) = std::min(parameters(k) + step, p.upper);
        below(k) = std::max(parameters(k) - step, p.lower);
        return Eigen::VectorXd((values_at(above, of_instrument) - values_at(below, of_instrument)) /
                               (above(k) - below(k)));
    };
    // At least 0.1 * step_share, since a friction of 0 needs a step too.
    for (Eigen::Index k = 0; changes_grains() && k < inside; ++k) {
        result.jacobian.col(k) = quotient(k, step_share * std::max(0.1, parameters(k)), false);
    }
    Eigen::Index next = inside;
    for (const Effect* effect : effects_) {
        for (const EffectParameter& p : effect->parameters) {
            if (p.is_fitted()) {
                result.jacobian.col(next) =
                    quotient(next, step_share * p.smallest_of_interest, effect->of_instrument());
                ++next;
            }
        }
    }
}

Eigen::MatrixXd EffectModel::changes_by(bool all, const std::vector<Condition>& conditions,
                                        const Truths& truths, const Nearby& nearby,
                                        const Eigen::VectorXd& here) const {
    Eigen::MatrixXd changes =
        Eigen::MatrixXd::Zero(here.size(), static_cast<Eigen::Index>(uncertainties_.size()));
    for (std::size_t k = 0; k < uncertainties_.size(); ++k) {
        const SharedUncertainty& each = uncertainties_[k];
        if (!all && !each.counts) continue;
        // No change where no true state, or no formula of the user, allows such an error.
        const auto change_by_error = [&](bool below) -> Eigen::VectorXd {
            std::vector<ActiveEffect> effects = truths.effects;
            std::ranges::move(each.error(below), std::back_inserter(effects));
            try {
                return nearby.shown(truths_with(std::move(effects), conditions, &truths)) - here;
            } catch (const std::domain_error&) {
            } catch (const InputError&) {
            }
            return Eigen::VectorXd::Zero(here.size());
        };
        const Eigen::VectorXd above = change_by_error(false), below = -change_by_error(true);
        // One side is shorter at the end of a range, as for a contact angle of 0.
        changes.col(static_cast<Eigen::Index>(k)) = above.norm() < below.norm() ? below : above;
    }
    return changes;
}

Eigen::MatrixXd EffectModel::shared_changes(const Eigen::VectorXd& parameters,
                                            const std::vector<Condition>& conditions) const {
    const Truths truths = truths_at(parameters, conditions);
    const Eigen::VectorXd predicted =
        inside_->predict_flow(inside_parameters(parameters), truths.imposed, PredictionPart::values)
            .value;
    return changes_by(true, conditions, truths, Nearby(*this, parameters, truths, predicted),
                      shown(truths, predicted));
}

Prediction EffectModel::predict(const Eigen::VectorXd& parameters,
                                const std::vector<Condition>& conditions,
                                PredictionPart what) const {
    const Truths truths = truths_at(parameters, conditions);
    // The inner model's slopes by its own parameters do not contain how the response to effects on
    // grains depends on these parameters, which needs difference quotients.
    const bool own_slopes = what == PredictionPart::slopes && !changes_grains();
    const Prediction inside = inside_->predict_flow(
        inside_parameters(parameters), truths.imposed,
        what == PredictionPart::covariance || own_slopes ? what : PredictionPart::values);
    Prediction result{
        .value = shown(truths, inside.value), .jacobian = {}, .covariance = {}, .run_noise = {}};
    if (what == PredictionPart::values) {
        return result;
    }
    result.jacobian = Eigen::MatrixXd::Zero(inside.value.size(), parameters.size());
    const Nearby nearby(*this, parameters, truths, inside.value);
    add_slopes(parameters, conditions, truths, nearby, result);
    if (what == PredictionPart::slopes && !own_slopes) {
        return result;
    }
    const Eigen::SparseMatrix<double> slopes = shown_by_predicted(truths, inside.value);
    if (!changes_grains()) {
        result.jacobian.leftCols(inside.jacobian.cols()) = slopes * inside.jacobian;
    }
    const auto shown_covariance = [&](const Eigen::MatrixXd& predicted) {
        const Eigen::MatrixXd half = slopes * predicted;
        return Eigen::MatrixXd(half * slopes.transpose());
    };
    if (what == PredictionPart::covariance) {
        result.covariance = shown_covariance(inside.covariance);
        if (study_.model.discrepancy != std::array{0.0, 0.0}) {
            result.discrepancy =
                discrepancy_covariance(conditions, result.value, study_.model.discrepancy);
            result.covariance += result.discrepancy;
        }
        if (std::ranges::any_of(uncertainties_, &SharedUncertainty::counts)) {
            const Eigen::MatrixXd changes =
                changes_by(false, conditions, truths, nearby, result.value);
            result.covariance += changes * changes.transpose();
        }
        result.run_noise = shown_covariance(inside.run_noise);
    }
    return result;
}

ModelSpace::ChangeErrors EffectModel::change_errors(
    const Eigen::VectorXd& parameters, const EffectModel& without,
    const Eigen::VectorXd& parameters_without, const std::vector<Condition>& conditions) const {
    const Truths here = truths_at(parameters, conditions);
    const Truths there = without.truths_at(parameters_without, conditions);
    const Eigen::VectorXd own = inside_parameters(parameters);
    const auto n = 2 * static_cast<Eigen::Index>(conditions.size());
    // Conditions without the effect, then those that the effect changes.
    std::vector<EffectiveCondition> requested = there.imposed;
    std::vector<Eigen::Index> place;  // index of each reading's condition with the effect
    for (std::size_t k = 0; k < here.imposed.size(); ++k) {
        const bool same = here.imposed[k] == there.imposed[k];
        place.push_back(static_cast<Eigen::Index>(same ? k : requested.size()));
        if (!same) requested.push_back(here.imposed[k]);
    }
    const Prediction inside = inside_->predict_flow(own, requested);
    Eigen::VectorXd with_values(n);
    for (std::size_t k = 0; k < place.size(); ++k) {
        with_values.segment<2>(2 * static_cast<Eigen::Index>(k)) =
            inside.value.segment<2>(2 * place[k]);
    }
    // Selects the predictions with the effect, and those without it, from all requested ones.
    const auto selection = [&](const auto& place_of) {
        std::vector<Eigen::Triplet<double>> ones;
        for (Eigen::Index row = 0; row < n; ++row) {
            ones.emplace_back(row, 2 * place_of(row / 2) + row % 2, 1);
        }
        Eigen::SparseMatrix<double> result(n, inside.value.size());
        result.setFromTriplets(ones.begin(), ones.end());
        return result;
    };
    const Eigen::SparseMatrix<double> with_by_asked = shown_by_predicted(here, with_values) *
                                                      selection([&](Eigen::Index k) {
                                                          return place[static_cast<std::size_t>(k)];
                                                      }),
                                      without_by_asked =
                                          without.shown_by_predicted(there, inside.value.head(n)) *
                                          selection([](Eigen::Index k) { return k; }),
                                      change = with_by_asked - without_by_asked;
    const Eigen::MatrixXd half = inside.covariance * change.transpose();
    return {change * half, without_by_asked * half};
}

ParameterBounds EffectModel::bounds() const {
    ParameterBounds range = inside_->bounds();
    const Eigen::Index inside = range.lower.size();
    const auto all = static_cast<Eigen::Index>(parameters_.size());
    range.lower.conservativeResize(all);
    range.upper.conservativeResize(all);
    for (Eigen::Index k = inside; k < all; ++k) {
        range.lower(k) = parameters_[static_cast<std::size_t>(k)].lower;
        range.upper(k) = parameters_[static_cast<std::size_t>(k)].upper;
    }
    return range;
}

bool needs_joint_fit(const std::vector<const Effect*>& effects) {
    return std::ranges::any_of(effects, [](const Effect* effect) {
        return effect->touches != Touches::wet || !effect->is_switch();
    });
}

}  // namespace pendular
