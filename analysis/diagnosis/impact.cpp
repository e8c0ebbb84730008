#include "analysis/diagnosis/impact.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>
#include <map>
#include <memory>
#include <stdexcept>
#include <utility>
#include <vector>

#include "analysis/diagnosis/explanations.h"
#include "analysis/diagnosis/side_by_side.h"
#include "data/quantities/decompositions.h"

namespace pendular {
namespace {

/// Model with one candidate at a fixed value, so that the parameters of the bare model are fitted.
class WithFixed : public Model {
  public:
    WithFixed(const ModelSpace& space, std::size_t candidate, double value)
        : bare_(space.with({})), inside_(space.with({candidate})), value_(value) {}
    const std::vector<Parameter>& parameters() const override { return bare_->parameters(); }
    Prediction predict(const Eigen::VectorXd& parameters, PredictionPart what) const override {
        Eigen::VectorXd all(std::ssize(inside_->parameters()));
        all.head(parameters.size()) = parameters;
        all.tail(all.size() - parameters.size()).setConstant(value_);  // none for a switch
        Prediction prediction = inside_->predict(all, what);
        if (what != PredictionPart::values) {
            prediction.jacobian = prediction.jacobian.leftCols(parameters.size()).eval();
        }
        return prediction;
    }
    ParameterBounds bounds() const override { return bare_->bounds(); }

  private:
    std::shared_ptr<const Model> bare_, inside_;
    double value_;
};

/// Computes impacts on the fit of one diagnosis.
class Impacts {
  public:
    Impacts(const ModelSpace& space, const Evidence& evidence, const Diagnosis& diagnosis)
        : space_(space),
          evidence_(evidence),
          diagnosis_(diagnosis),
          fit_(diagnosis.base.fit),
          bare_(space.with({})),
          residuals_(residuals_of(*bare_, evidence.measured, fit_)),
          covariance_(evidence.measured.covariance + fit_.prediction.covariance) {
        table_.parameters = bare_->parameters();
        table_.fitted = fit_.parameters;
        table_.errors = Eigen::VectorXd::NullaryExpr(
            fit_.parameters.size(), [&](Eigen::Index k) { return fit_.standard_error(k); });
    }

    void add_all(std::size_t threads);
    void refit_leading(std::size_t most, std::size_t threads);
    void sum_groups();
    ImpactTable& table() { return table_; }

  private:
    /// Impact of the effect of a finding; empty where it cannot be computed.
    std::vector<Impact> impact_of(const Finding& finding) const;
    /// Impact of each kind of error of a suspect measurement.
    std::vector<Impact> impacts_of_suspect(std::size_t k) const;
    bool is_named(const Impact& impact) const;
    bool is_switch(const Impact& impact) const {
        return !impact.measurement && space_.candidates()[impact.index].is_switch();
    }
    /// The diagnosis' refit with a candidate alone; null where there is none.
    const FittedModel* refit_of(std::size_t candidate) const;
    /// Shift of the parameters by an effect that changes the readings by `change`.
    Eigen::VectorXd shift_by(const Eigen::VectorXd& change) const {
        return -residuals_.parameter_shift_of(residuals_.whiten(change));
    }
    /// A shift of the parameters, limited to their bounds: beyond, the linear approximation
    /// describes no model.
    Eigen::VectorXd within_bounds(const Eigen::VectorXd& shift) const {
        const ParameterBounds bounds = bare_->bounds();
        return (fit_.parameters + shift).cwiseMax(bounds.lower).cwiseMin(bounds.upper) -
               fit_.parameters;
    }
    Shift shift_of(double size, const Eigen::VectorXd& linear) const {
        return {size, linear, within_bounds(linear), {}};
    }
    /// Limits the step from the estimate to `end`, rather than `end`, so that a step from an
    /// estimate beyond the bounds does not vanish.
    void bound_step(const Shift& estimate, Shift& end) const {
        // Readings that do not determine a parameter shift it to its bound, whatever the size.
        const Eigen::VectorXd step = end.linear - estimate.linear;
        end.bounded = estimate.bounded + within_bounds(step.array().isFinite().select(step, 0));
    }
    /// Shift of the parameters by a refit with the effect at `size`; the fit starts from `start`.
    Eigen::VectorXd refitted(const Impact& impact, double size, const Eigen::VectorXd& start) const;

    const ModelSpace& space_;
    const Evidence& evidence_;
    const Diagnosis& diagnosis_;
    const Fit& fit_;
    std::shared_ptr<const Model> bare_;
    WeightedResiduals residuals_;
    /// Covariance of the differences between readings and predictions of the diagnosis' fit.
    Eigen::MatrixXd covariance_;
    ImpactTable table_;
};

bool Impacts::is_named(const Impact& impact) const {
    const auto& names = impact.measurement ? diagnosis_.suspects : diagnosis_.effects;
    return std::ranges::find(names, impact.name) != names.end();
}

const FittedModel* Impacts::refit_of(std::size_t candidate) const {
    const auto found = std::ranges::find_if(diagnosis_.tried, [&](const FittedModel& each) {
        return each.chosen == EffectSet{candidate} && !each.suspect;
    });
    return found == diagnosis_.tried.end() ? nullptr : &*found;
}

std::vector<Impact> Impacts::impact_of(const Finding& finding) const {
    const std::size_t k = finding.candidate;
    const Candidate& candidate = space_.candidates()[k];
    const EffectParameter& p = candidate.parameters.front();
    const Addition addition(space_, {}, k, fit_.parameters, fit_.prediction.value);
    const Signature signature = addition.signature(false);
    if (signature.change.cols() != 1 || !signature.change.allFinite()) return {};
    const Eigen::VectorXd unit = shift_by(signature.change);
    const bool one_sided = signature.one_sided, is_switch = candidate.is_switch();
    const auto shift = [&](double size) {
        const double within =
            is_switch ? std::clamp(size, 0.0, 1.0) : std::clamp(size, p.lower, p.upper);
        const double amplitude = is_switch ? within : addition.amplitude_at(within, one_sided);
        return shift_of(within, unit * amplitude);
    };
    Impact impact{.name = candidate.name,
                  .quantity = p.name,
                  .unit = p.unit,
                  .group = candidate.group,
                  .index = k,
                  .neutral = is_switch ? 0 : p.neutral};
    impact.at_interest = shift(is_switch ? 1 : addition.value_at(signature.taken_at, one_sided));
    double estimate = impact.neutral;
    if (finding.test.seen()) {
        estimate = finding.value;
        impact.error = finding.standard_error;
    }
    const FittedModel* refit = is_switch ? nullptr : refit_of(k);
    const auto last = [&] { return refit->fit.parameters.size() - 1; };
    if (refit != nullptr &&
        !(refit->fit.converged && std::isfinite(refit->fit.standard_error(last())))) {
        refit = nullptr;
        impact.error = 0;  // the size is unknown: no fit converged, or none determines it
    }
    if (refit != nullptr) {
        estimate = refit->fit.parameters.tail(1)(0);
        impact.error = refit->fit.standard_error(last());
    }
    impact.at_estimate = shift(estimate);
    if (refit != nullptr) {
        impact.at_estimate.refitted =
            refit->fit.parameters.head(fit_.parameters.size()) - fit_.parameters;
    }
    impact.above = shift(estimate + impact.error);
    impact.below = shift(estimate - impact.error);
    bound_step(impact.at_estimate, impact.above);
    bound_step(impact.at_estimate, impact.below);
    return {impact};
}

std::vector<Impact> Impacts::impacts_of_suspect(std::size_t k) const {
    std::vector<Impact> impacts;
    const SuspectMeasurement& suspect = evidence_.suspects[k];
    // All errors of the suspect are estimated together.
    const Eigen::MatrixXd projected = residuals_.project(residuals_.whiten(suspect.columns));
    const Eigen::CompleteOrthogonalDecomposition<Eigen::MatrixXd> decomposed(projected);
    const Eigen::VectorXd estimates = decomposed.solve(residuals_.residuals());
    const Eigen::MatrixXd root = pseudo_inverse(decomposed);
    const Eigen::VectorXd errors = root.rowwise().norm();
    for (Eigen::Index column = 0; column < suspect.columns.cols(); ++column) {
        const Eigen::VectorXd unit = shift_by(suspect.columns.col(column));
        const auto shift = [&](double size) { return shift_of(size, unit * size); };
        Impact impact{.name = suspect.name,
                      .unit = "1",
                      .group = suspect.group,
                      .measurement = true,
                      .index = k,
                      .column = column,
                      .error = errors(column)};
        if (const auto place = static_cast<std::size_t>(column);
            place < suspect.quantities.size()) {
            impact.quantity = suspect.quantities[place];
        }
        impact.at_interest = shift(suspect.smallest_of_interest);
        impact.at_estimate = shift(estimates(column));
        impact.above = shift(estimates(column) + errors(column));
        impact.below = shift(estimates(column) - errors(column));
        bound_step(impact.at_estimate, impact.above);
        bound_step(impact.at_estimate, impact.below);
        impacts.push_back(std::move(impact));
    }
    return impacts;
}

Eigen::VectorXd Impacts::refitted(const Impact& impact, double size,
                                  const Eigen::VectorXd& start) const {
    try {
        if (!impact.measurement) {
            const WithFixed model(space_, impact.index, size);
            const Eigen::MatrixXd covariance =
                evidence_.measured.covariance +
                model.predict(start, PredictionPart::covariance).covariance;
            return best_parameters(model, evidence_.measured, covariance, start, refit_effort) -
                   fit_.parameters;
        }
        Measured corrected = evidence_.measured;
        corrected.value -= size * evidence_.suspects[impact.index].columns.col(impact.column);
        return best_parameters(*bare_, corrected, covariance_, start, refit_effort) -
               fit_.parameters;
    } catch (const std::domain_error&) {
        return {};  // the readings are impossible with so much of the effect
    }
}

void Impacts::refit_leading(std::size_t most, std::size_t threads) {
    std::vector<Impact>& list = table_.impacts;
    const auto others = std::stable_partition(
        list.begin(), list.end(), [&](const Impact& impact) { return is_named(impact); });
    const auto named = static_cast<std::size_t>(others - list.begin());
    const std::size_t leading = std::min(list.size(), std::min(named, most) + most);
    std::vector<std::pair<const Impact*, Shift*>> wanted;
    for (std::size_t k = 0; k < leading; ++k) {
        Impact& impact = list[k];
        std::vector<Shift*> shifts = {&impact.at_estimate, &impact.at_interest};
        if (is_named(impact)) shifts.insert(shifts.end(), {&impact.above, &impact.below});
        for (Shift* shift : shifts) {
            if (shift->refitted.size() > 0) continue;             // the diagnosis has this refit
            if (is_switch(impact) && shift->size != 1) continue;  // a switch is on or off
            wanted.emplace_back(&impact, shift);
        }
    }
    side_by_side(wanted.size(), threads, nullptr, [&](std::size_t k) {
        const auto [impact, shift] = wanted[k];
        shift->refitted = refitted(*impact, shift->size, fit_.parameters + shift->bounded);
    });
}

void Impacts::sum_groups() {
    std::map<std::string, GroupImpact> sums;
    const Eigen::VectorXd none = Eigen::VectorXd::Zero(table_.fitted.size());
    for (const Impact& impact : table_.impacts) {
        GroupImpact& sum =
            sums.emplace(impact.group, GroupImpact{impact.group, none, none, none}).first->second;
        sum.at_interest += impact.at_interest.bounded.cwiseAbs2();
        sum.at_estimate += impact.at_estimate.bounded.cwiseAbs2();
        sum.by_error +=
            (impact.above.bounded - impact.at_estimate.bounded)
                .cwiseAbs()
                .cwiseMax((impact.below.bounded - impact.at_estimate.bounded).cwiseAbs())
                .cwiseAbs2();
    }
    for (auto& [name, sum] : sums) {
        sum.at_interest = sum.at_interest.cwiseSqrt();
        sum.at_estimate = sum.at_estimate.cwiseSqrt();
        sum.by_error = sum.by_error.cwiseSqrt();
        table_.groups.push_back(std::move(sum));
    }
}

void Impacts::add_all(std::size_t threads) {
    const std::size_t effects = diagnosis_.scan.size();
    std::vector<std::vector<Impact>> found(effects + evidence_.suspects.size());
    side_by_side(found.size(), threads, nullptr, [&](std::size_t k) {
        found[k] = k < effects ? impact_of(diagnosis_.scan[k]) : impacts_of_suspect(k - effects);
    });
    for (std::vector<Impact>& each : found) {
        std::ranges::move(each, std::back_inserter(table_.impacts));
    }
    std::ranges::stable_sort(table_.impacts, std::greater<>(), [](const Impact& impact) {
        return std::abs(impact.at_interest.linear(0));
    });
}

}  // namespace

double Impact::pull() const {
    return error > 0 ? (at_estimate.size - neutral) / error : std::nan("");
}

ImpactTable impacts(const ModelSpace& space, const Evidence& evidence, const Diagnosis& diagnosis,
                    std::size_t most_refitted, std::size_t threads) {
    Impacts all(space, evidence, diagnosis);
    all.add_all(threads);
    all.refit_leading(most_refitted, threads);
    all.sum_groups();
    return std::move(all.table());
}

}  // namespace pendular
