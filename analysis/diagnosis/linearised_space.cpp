#include "analysis/diagnosis/linearised_space.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>
#include <utility>

#include "analysis/diagnosis/signature.h"

namespace pendular {

/// One model of the space.
class LinearisedSpace::Linear : public Model {
  public:
    Linear(const LinearisedSpace& space, const EffectSet& chosen)
        : parameters_(space.parameters_),
          bounds_(space.bounds_),
          constant_(space.value_ - space.slopes_ * space.at_),
          errors_(space.errors_of(chosen)),
          columns_(space.slopes_) {
        for (const std::size_t k : chosen) {
            const Eigen::MatrixXd& change = space.changes_[k];
            if (!change.allFinite()) possible_ = false;
            if (space.candidates_[k].is_switch()) {
                constant_ += change;
                continue;
            }
            const auto before = columns_.cols();
            columns_.conservativeResize(Eigen::NoChange, before + change.cols());
            columns_.rightCols(change.cols()) = change;
            for (const EffectParameter& p : space.candidates_[k].parameters) {
                if (!p.is_switch()) add_parameter(p);
            }
        }
    }
    const std::vector<Parameter>& parameters() const override { return parameters_; }
    Prediction predict(const Eigen::VectorXd& parameters, PredictionPart what) const override {
        if (!possible_) throw std::domain_error("impossible with these readings");
        Prediction prediction{.value = constant_ + columns_ * parameters};
        if (what != PredictionPart::values) prediction.jacobian = columns_;
        if (what == PredictionPart::covariance) {
            prediction.covariance = errors_.covariance;
            prediction.run_noise = errors_.run_noise;
        }
        return prediction;
    }
    ParameterBounds bounds() const override { return bounds_; }

  private:
    void add_parameter(const EffectParameter& p) {
        parameters_.push_back(
            {.name = p.name, .lower = p.lower, .upper = p.upper, .start = p.neutral});
        const auto n = bounds_.lower.size();
        bounds_.lower.conservativeResize(n + 1);
        bounds_.upper.conservativeResize(n + 1);
        bounds_.lower(n) = p.lower;
        bounds_.upper(n) = p.upper;
    }

    std::vector<Parameter> parameters_;
    ParameterBounds bounds_;
    Eigen::VectorXd constant_;
    const Prediction& errors_;
    Eigen::MatrixXd columns_;
    bool possible_ = true;
};

namespace {

/// Refitted model with a candidate of one free parameter: `about` where it has the candidate, else
/// the refit with the candidate alone; null where there is none that converged.
const Explanation* refit_with(const ModelSpace& space, const Diagnosis& diagnosis,
                              const Explanation& about, std::size_t candidate) {
    if (space.candidates()[candidate].free_parameters() != 1) return nullptr;
    if (std::ranges::find(about.chosen, candidate) != about.chosen.end()) return &about;
    const auto found = std::ranges::find_if(diagnosis.tried, [&](const Explanation& each) {
        return each.chosen == EffectSet{candidate} && !each.suspect && each.fit.converged;
    });
    return found == diagnosis.tried.end() ? nullptr : &*found;
}

/// Value of the only parameter of a candidate in a refitted model that has it.
double value_in(const ModelSpace& space, const Explanation& refit, std::size_t candidate) {
    auto place = static_cast<Eigen::Index>(space.with({})->parameters().size());
    for (const std::size_t k : refit.chosen) {
        if (k == candidate) break;
        place += static_cast<Eigen::Index>(space.candidates()[k].free_parameters());
    }
    return refit.fit.parameters(place);
}

}  // namespace

LinearisedSpace::LinearisedSpace(const ModelSpace& space, const Diagnosis& diagnosis,
                                 const Explanation& about)
    : change_errors_(diagnosis.change_errors) {
    const std::shared_ptr<const Model> bare = space.with({});
    const auto count = static_cast<Eigen::Index>(bare->parameters().size());
    parameters_ = bare->parameters();
    bounds_ = bare->bounds();
    at_ = about.fit.parameters.head(count);
    value_ = bare->predict(at_, PredictionPart::values).value;
    slopes_ = about.fit.prediction.jacobian.leftCols(count);
    refitted_.emplace_back(EffectSet{}, diagnosis.fit.prediction);
    for (const Explanation& each : diagnosis.tried) {
        if (!each.suspect) refitted_.emplace_back(each.chosen, each.fit.prediction);
    }
    Eigen::VectorXd without = about.fit.prediction.value;  // less what the chosen effects add
    for (std::size_t k = 0; k < space.candidates().size(); ++k) {
        const double amplitude = add(space, k, refit_with(space, diagnosis, about, k));
        if (std::ranges::find(about.chosen, k) != about.chosen.end()) {
            without -= changes_[k] * Eigen::VectorXd::Constant(changes_[k].cols(), amplitude);
        }
    }
    if (!about.suspect) value_ = without;
}

double LinearisedSpace::add(const ModelSpace& space, std::size_t k, const Explanation* refit) {
    const Addition addition(space, {}, k, at_, value_);
    Signature signature = addition.signature(false);
    Candidate candidate = space.candidates()[k];
    const bool one_sided = signature.one_sided, single = candidate.free_parameters() == 1;
    double amplitude = 1;
    if (refit != nullptr) {
        amplitude = addition.amplitude_at(value_in(space, *refit, k), one_sided);
        addition.retake(signature, amplitude);
        if (refit->chosen.size() == 1 && amplitude != 0) {
            signature.change = (refit->fit.prediction.value - value_ -
                                slopes_ * (refit->fit.parameters.head(at_.size()) - at_)) /
                               amplitude;
        }
    }
    Eigen::Index column = 0;
    for (EffectParameter& p : candidate.parameters) {
        if (p.is_switch()) continue;
        double low = (p.lower - p.neutral) / p.smallest_of_interest,
               high = (p.upper - p.neutral) / p.smallest_of_interest;
        if (single && one_sided) {
            high = std::max(addition.amplitude_at(p.lower, true),
                            addition.amplitude_at(p.upper, true));
            low = 0;
        } else if (!single && high < 1) {
            signature.change.col(column) *= -1;  // it was taken in the other direction
        }
        p = {.name = p.name, .lower = low, .upper = high, .neutral = 0, .smallest_of_interest = 1};
        ++column;
    }
    changes_.push_back(std::move(signature.change));
    candidates_.push_back(std::move(candidate));
    return amplitude;
}

std::shared_ptr<const Model> LinearisedSpace::with(const EffectSet& chosen) const {
    return std::make_shared<Linear>(*this, chosen);
}

const Prediction& LinearisedSpace::errors_of(const EffectSet& chosen) const {
    const auto found =
        std::ranges::find(refitted_, chosen, &std::pair<EffectSet, Prediction>::first);
    return (found == refitted_.end() ? refitted_.front() : *found).second;
}

ModelSpace::ChangeErrors LinearisedSpace::change_errors(const EffectSet& /*chosen*/,
                                                        const Eigen::VectorXd& /*parameters*/,
                                                        std::size_t added, double value) const {
    ChangeErrors errors = change_errors_[added];
    errors.change *= value * value;
    errors.with_without *= value;
    return errors;
}

}  // namespace pendular
