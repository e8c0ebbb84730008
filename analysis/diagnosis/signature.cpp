#include "analysis/diagnosis/signature.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

namespace pendular {

Addition::Addition(const ModelSpace& space, EffectSet chosen, std::size_t added,
                   Eigen::VectorXd parameters, Eigen::VectorXd values)
    : space_(space),
      chosen_(std::move(chosen)),
      added_(added),
      parameters_(std::move(parameters)),
      values_(std::move(values)) {}

Eigen::VectorXd Addition::change_at(const Eigen::VectorXd& values) const {
    EffectSet more = chosen_;
    more.push_back(added_);
    Eigen::VectorXd all(parameters_.size() + values.size());
    all << parameters_, values;
    try {
        return space_.with(more)->predict(all, PredictionPart::values).value - values_;
    } catch (const std::domain_error&) {
        // These readings are impossible at this amplitude, so there is no change to compute.
        return Eigen::VectorXd::Constant(values_.size(), std::nan(""));
    }
}

Eigen::VectorXd Addition::neutral() const {
    std::vector<double> values;
    for (const EffectParameter& p : candidate().parameters) {
        if (!p.is_switch()) values.push_back(p.neutral);
    }
    return Eigen::Map<const Eigen::VectorXd>(values.data(),
                                             static_cast<Eigen::Index>(values.size()));
}

double Addition::direction(const EffectParameter& p) const {
    return p.neutral + p.smallest_of_interest <= p.upper ? 1 : -1;
}

bool Addition::mirrored(const Eigen::VectorXd& change) const {
    const EffectParameter& p = candidate().parameters.front();
    const double other = p.neutral - direction(p) * p.smallest_of_interest;
    if (other < p.lower || other > p.upper) {
        return false;
    }
    const Eigen::VectorXd there = change_at(Eigen::VectorXd::Constant(1, other));
    // Change in the other direction, projected on this change: -1 if the change is linear, 1 if it
    // is even, 0 if the other direction changes nothing. Chosen: a response that is a third as
    // strong in the other direction still counts as linear.
    constexpr double linear = -0.3;
    return there.dot(change) < linear * change.squaredNorm();
}

Signature Addition::signature(bool with_errors) const {
    const Candidate& c = candidate();
    Signature result;
    Eigen::VectorXd seen_at;
    if (c.is_switch()) {
        result.change = change_at(Eigen::VectorXd());
        result.one_sided = true;
    } else {
        const Eigen::VectorXd at = neutral();
        result.change.resize(values_.size(), at.size());
        Eigen::Index column = 0;
        for (const EffectParameter& p : c.parameters) {
            if (p.is_switch()) continue;
            seen_at = at;
            seen_at(column) = p.neutral + direction(p) * p.smallest_of_interest;
            result.change.col(column++) = change_at(seen_at);
        }
        if (at.size() == 1) {
            result.one_sided = !mirrored(result.change);
            result.taken_at = amplitude_at(seen_at(0), result.one_sided);
            result.change /= result.taken_at;
        }
    }
    if (with_errors && result.change.cols() == 1 && result.change.allFinite()) {
        result.errors = space_.change_errors(chosen_, parameters_, added_, seen_at);
        result.errors.change /= result.taken_at * result.taken_at;
        result.errors.with_without /= result.taken_at;
    }
    return result;
}

void Addition::retake(Signature& signature, double amplitude) const {
    const double value = value_at(amplitude, signature.one_sided);
    const double taken_at = amplitude_at(value, signature.one_sided);
    const Eigen::VectorXd change = change_at(Eigen::VectorXd::Constant(1, value));
    if (taken_at != 0 && change.allFinite()) {
        signature.change = change / taken_at;
        signature.taken_at = taken_at;
    }
}

double Addition::amplitude_at(double value, bool one_sided) const {
    const EffectParameter& p = candidate().parameters.front();
    if (one_sided && p.amplitude != nullptr) {
        return (p.amplitude(value) - p.amplitude(p.neutral)) /
               (p.amplitude(p.neutral + direction(p) * p.smallest_of_interest) -
                p.amplitude(p.neutral));
    }
    return (one_sided ? direction(p) : 1) * (value - p.neutral) / p.smallest_of_interest;
}

double Addition::value_at(double amplitude, bool one_sided) const {
    const EffectParameter& p = candidate().parameters.front();
    if (one_sided && p.amplitude != nullptr) {
        // Bisection: the amplitude increases from the neutral value to the bound.
        double low = p.neutral, high = direction(p) > 0 ? p.upper : p.lower;
        if (amplitude >= amplitude_at(high, true)) {
            return high;
        }
        for (int halving = 0; halving < 60; ++halving) {
            const double middle = 0.5 * (low + high);
            (amplitude_at(middle, true) < amplitude ? low : high) = middle;
        }
        return 0.5 * (low + high);
    }
    const double sign = one_sided ? direction(p) : 1;
    return std::clamp(p.neutral + sign * amplitude * p.smallest_of_interest, p.lower, p.upper);
}

}  // namespace pendular
