#include "reports/figure_style.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "data/quantities/number.h"

namespace pendular {

bool spans_decade(const std::vector<double>& values) {
    const auto [least, greatest] = std::ranges::minmax(values);
    return least > 0 && greatest > 10 * least;
}

Shown shown(const Reading& r) {
    const double s = r.condition.normal_stress;
    return {{r.value(0) / s, r.value(1)},
            {std::sqrt(r.covariance(0, 0)) / s, std::sqrt(r.covariance(1, 1))}};
}

Shown shown(const Prediction& predicted, Eigen::Index place, double normal_stress) {
    const auto error = [&](Eigen::Index k) { return std::sqrt(predicted.covariance(k, k)); };
    return {{predicted.value(2 * place) / normal_stress, predicted.value(2 * place + 1)},
            {error(2 * place) / normal_stress, error(2 * place + 1)}};
}

namespace {

/// Weights 1/standard error^2 of the values of observable `o`, normalised to the sum 1.
Eigen::VectorXd weights_of(const std::vector<Shown>& all, std::size_t o) {
    Eigen::VectorXd weights(std::ssize(all));
    for (std::size_t k = 0; k < all.size(); ++k) {
        weights(static_cast<Eigen::Index>(k)) = std::pow(all[k].error[o], -2);
    }
    return weights / weights.sum();
}

}  // namespace

Shown mean_of(const std::vector<Shown>& all) {
    Shown mean{};
    for (std::size_t o = 0; o < 2; ++o) {
        const Eigen::VectorXd weights = weights_of(all, o);
        double variance = 0;
        for (std::size_t k = 0; k < all.size(); ++k) {
            const double weight = weights(static_cast<Eigen::Index>(k));
            mean.value[o] += weight * all[k].value[o];
            variance += std::pow(weight * all[k].error[o], 2);
        }
        mean.error[o] = std::sqrt(variance);
    }
    return mean;
}

MeasuredAndModel means_of(const std::vector<std::size_t>& places, const Calibration& c,
                          const Eigen::MatrixXd& covariance) {
    std::vector<Shown> measured;
    for (const std::size_t k : places) {
        measured.push_back(shown(c.readings[k]));
    }
    MeasuredAndModel means{mean_of(measured), {}};
    for (std::size_t o = 0; o < 2; ++o) {
        const Eigen::VectorXd weights = weights_of(measured, o);
        Eigen::VectorXd share = Eigen::VectorXd::Zero(c.prediction.value.size());
        for (std::size_t m = 0; m < places.size(); ++m) {
            const double unit = o == 0 ? c.readings[places[m]].condition.normal_stress : 1;
            share(static_cast<Eigen::Index>(2 * places[m] + o)) =
                weights(static_cast<Eigen::Index>(m)) / unit;
        }
        means.measured.error[o] = std::sqrt(share.dot(covariance * share));
        means.model.value[o] = share.dot(c.prediction.value);
        means.model.error[o] = std::sqrt(share.dot(c.prediction.covariance * share));
    }
    return means;
}

bool mean_suffices(const std::vector<std::size_t>& places, const Calibration& c) {
    const Shown mean = means_of(places, c, stack(c.readings).covariance).model;
    return std::ranges::all_of(places, [&](std::size_t k) {
        const Shown reading = shown(c.readings[k]),
                    model = shown(c.prediction, static_cast<Eigen::Index>(k),
                                  c.readings[k].condition.normal_stress);
        return std::abs(model.value[0] - mean.value[0]) <= same_point * reading.error[0] &&
               std::abs(model.value[1] - mean.value[1]) <= same_point * reading.error[1];
    });
}

void add_point(Curve& curve, double x, const Shown& shown, std::size_t o) {
    curve.x.push_back(x);
    curve.y.push_back(shown.value[o]);
    curve.y_error.push_back(shown.error[o]);
}

std::string names_of(const std::vector<const Effect*>& effects) {
    return effects.empty()       ? ""
           : effects.size() == 1 ? effects[0]->name
           : effects.size() == 2 ? effects[0]->name + " and " + effects[1]->name
                                 : fmt::format("{} effects", effects.size());
}

std::string inertial_text(double inertial_number) {
    return inertial_number == 0 ? "I → 0" : "I = " + nominal_text(inertial_number);
}

}  // namespace pendular
