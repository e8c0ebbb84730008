#include "analysis/misfit/checks.h"

#include <fmt/format.h>

#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <numeric>
#include <tuple>

#include "data/recordings/reading_groups.h"

namespace pendular {
namespace {

using Statistic = std::function<double(const Eigen::VectorXd&)>;

/// Lengths of the Gaussian kernel of the neighbours check, in ranks scaled to -1 to 1. Chosen: a
/// seventh, half and more than all of the readings.
constexpr std::array<double, 3> lengths = {0.3, 1, 3};

std::vector<Eigen::Index> order_along(const Eigen::VectorXd& values) {
    std::vector<Eigen::Index> order(static_cast<std::size_t>(values.size()));
    std::iota(order.begin(), order.end(), Eigen::Index{0});
    std::erase_if(order, [&](Eigen::Index k) { return std::isnan(values(k)); });
    std::ranges::stable_sort(order, {}, [&](Eigen::Index k) { return values(k); });
    return order;
}

/// Ranks of values, scaled to -1 to 1, equal for equal values; 0 where a value is not a number.
Eigen::VectorXd ranks(const Eigen::VectorXd& values) {
    const auto n = static_cast<double>(values.size() - values.array().isNaN().count());
    Eigen::VectorXd result(values.size());
    for (Eigen::Index k = 0; k < values.size(); ++k) {
        const auto below = static_cast<double>((values.array() < values(k)).count());
        const auto above = static_cast<double>((values.array() > values(k)).count());
        result(k) = (below - above) / n;
    }
    return result;
}

/// Largest absolute value of the cumulated sum of `scores` in the given order, over `deviation`.
/// Only sums up to the last entry of each value of the covariate `values` count.
double largest_excursion(const Eigen::VectorXd& scores, const std::vector<Eigen::Index>& order,
                         const Eigen::VectorXd& values, double deviation) {
    double sum = 0, largest = 0;
    for (std::size_t k = 0; k < order.size(); ++k) {
        sum += scores(order[k]);
        const bool steps = k + 1 < order.size() && values(order[k + 1]) > values(order[k]);
        if (steps) largest = std::max(largest, std::abs(sum));
    }
    return largest / deviation;
}

class Checking {
  public:
    Checking(const WeightedResiduals& residuals, const EntryKinds& kinds,
             const std::vector<Covariate>& covariates, const NullDraws& draws)
        : residuals_(residuals), kinds_(kinds), covariates_(covariates) {
        // Projected, since the fit need not be the optimum of all readings (fit_to = "dry").
        own_residuals_ = residuals.project(residuals.residuals());
        drawn_residuals_ = residuals.project(draws.whitened(residuals));
    }
    Checks run() {
        lack_of_fit();
        for (const Covariate& covariate : covariates_) {
            scores(covariate);
            trends(covariate);
        }
        if (!kinds_.replicated) runs();
        if (!covariates_.empty()) neighbours();
        together();
        return std::move(result_);
    }

  private:
    /// Adds a check with its statistics in the random draws, from which its p value follows.
    void add(Check check, const Eigen::VectorXd& drawn) {
        check.p = NullDraws::p(check.statistic, drawn);
        result_.all.push_back(std::move(check));
        drawn_.push_back(drawn);
    }
    void add(Check check, const Statistic& statistic) {
        Eigen::VectorXd drawn(drawn_residuals_.cols());
        for (Eigen::Index draw = 0; draw < drawn.size(); ++draw) {
            drawn(draw) = statistic(drawn_residuals_.col(draw));
        }
        check.statistic = statistic(own_residuals_);
        add(std::move(check), drawn);
    }
    /// Adds a check with the statistic |B' r|^2, B the basis.
    void add_squares(Check check, const Eigen::MatrixXd& basis) {
        check.statistic = (basis.transpose() * own_residuals_).squaredNorm();
        add(std::move(check),
            (basis.transpose() * drawn_residuals_).colwise().squaredNorm().transpose());
    }

    void lack_of_fit() {
        add_squares({.kind = Check::Kind::lack_of_fit}, residuals_.means_over(kinds_.conditions));
    }
    void scores(const Covariate& covariate) {
        const auto order = order_along(covariate.values);
        for (std::size_t j = 0; j < kinds_.parameters.size(); ++j) {
            const Eigen::VectorXd slope = residuals_.slopes().col(static_cast<Eigen::Index>(j));
            const double deviation = slope.norm();
            if (!(deviation > 0)) continue;
            add({.kind = Check::Kind::score,
                 .covariate = covariate.name,
                 .of = kinds_.parameters[j]},
                [&](const Eigen::VectorXd& r) {
                    return largest_excursion(slope.cwiseProduct(r), order, covariate.values,
                                             deviation);
                });
        }
    }
    void trends(const Covariate& covariate) {
        for (std::size_t o = 0; o < kinds_.observables.size(); ++o) {
            // Residuals proportional to the measured value, of this observable alone.
            Eigen::VectorXd along = ranks(covariate.values).cwiseProduct(residuals_.measured());
            for (Eigen::Index k = 0; k < along.size(); ++k) {
                if (kinds_.observable[static_cast<std::size_t>(k)] != o) along(k) = 0;
            }
            const Eigen::VectorXd whitened = residuals_.whiten(along);
            const Eigen::VectorXd left = residuals_.project(whitened);
            // The calibrated parameters imitate the trend: only rounding errors are left.
            if (!(left.squaredNorm() > 1e-9 * whitened.squaredNorm())) continue;
            const Eigen::VectorXd direction = left.normalized();
            // The sign is positive where measured values increase more than predicted ones.
            Check check{.kind = Check::Kind::trend,
                        .covariate = covariate.name,
                        .of = kinds_.observables[o],
                        .statistic = direction.dot(own_residuals_)};
            const Eigen::VectorXd drawn =
                (direction.transpose() * drawn_residuals_).cwiseAbs().transpose();
            check.p = NullDraws::p(std::abs(check.statistic), drawn);
            result_.all.push_back(std::move(check));
            drawn_.push_back(drawn);
        }
    }
    void runs() {
        for (std::size_t o = 0; o < kinds_.observables.size(); ++o) {
            add({.kind = Check::Kind::runs, .of = kinds_.observables[o]},
                [&](const Eigen::VectorXd& r) {
                    int changes = 0, before = 0;
                    for (Eigen::Index k = 0; k < r.size(); ++k) {
                        if (kinds_.observable[static_cast<std::size_t>(k)] != o) continue;
                        const int sign = r(k) > 0 ? 1 : -1;
                        changes += before != 0 && sign != before;
                        before = sign;
                    }
                    return -static_cast<double>(changes);  // few changes speak against the model
                });
        }
    }
    void neighbours() {
        Eigen::MatrixXd places(residuals_.size(), static_cast<Eigen::Index>(covariates_.size()));
        for (std::size_t c = 0; c < covariates_.size(); ++c) {
            places.col(static_cast<Eigen::Index>(c)) = ranks(covariates_[c].values);
        }
        for (const double length : lengths) {
            Eigen::MatrixXd kernel(places.rows(), places.rows());
            for (Eigen::Index i = 0; i < places.rows(); ++i) {
                for (Eigen::Index j = 0; j < places.rows(); ++j) {
                    const bool alike = kinds_.observable[static_cast<std::size_t>(i)] ==
                                       kinds_.observable[static_cast<std::size_t>(j)];
                    const double apart = (places.row(i) - places.row(j)).squaredNorm();
                    kernel(i, j) = alike ? std::exp(-apart / (2 * length * length)) : 0.0;
                }
            }
            const Eigen::VectorXd drawn =
                drawn_residuals_.cwiseProduct(kernel * drawn_residuals_).colwise().sum();
            add({.kind = Check::Kind::neighbours,
                 .covariate = fmt::format("all, length {:.1f}", length),
                 .statistic = own_residuals_.dot(kernel * own_residuals_)},
                drawn);
        }
    }
    void together() {
        // Smallest p value of any check in each draw, from the draw's rank among all draws.
        const auto draws = drawn_residuals_.cols();
        Eigen::VectorXd least = Eigen::VectorXd::Ones(draws);
        double observed = 1;
        for (std::size_t c = 0; c < drawn_.size(); ++c) {
            const auto order = order_along(-drawn_[c]);
            Eigen::Index k = 0;
            while (k < draws) {
                Eigen::Index end = k;
                while (end < draws && drawn_[c](order[static_cast<std::size_t>(end)]) ==
                                          drawn_[c](order[static_cast<std::size_t>(k)])) {
                    ++end;
                }
                const double p = static_cast<double>(end) / static_cast<double>(draws);
                for (; k < end; ++k) {
                    double& own = least(order[static_cast<std::size_t>(k)]);
                    own = std::min(own, p);
                }
            }
            observed = std::min(observed, result_.all[c].p);
        }
        result_.p = NullDraws::p(-observed, -least);
    }

    const WeightedResiduals& residuals_;
    const EntryKinds& kinds_;
    const std::vector<Covariate>& covariates_;
    Eigen::VectorXd own_residuals_;
    Eigen::MatrixXd drawn_residuals_;  ///< entries x draws
    Checks result_;
    std::vector<Eigen::VectorXd> drawn_;  ///< statistics of each check
};

}  // namespace

std::string_view to_string(Check::Kind kind) {
    switch (kind) {
        case Check::Kind::lack_of_fit:
            return "lack of fit";
        case Check::Kind::score:
            return "score";
        case Check::Kind::trend:
            return "trend";
        case Check::Kind::runs:
            return "runs";
        default:
            return "neighbours";
    }
}

Checks check_fit(const WeightedResiduals& residuals, const EntryKinds& kinds,
                 const std::vector<Covariate>& covariates, const NullDraws& draws) {
    return Checking(residuals, kinds, covariates, draws).run();
}

namespace {

/// Entries of each condition, in separate groups for shear stress and solid fraction.
std::vector<std::vector<Eigen::Index>> entries_by_condition(const std::vector<Reading>& readings) {
    std::vector<std::vector<Eigen::Index>> result;
    for (const auto& group : replicate_groups(readings)) {
        for (const Eigen::Index observable : {0, 1}) {
            std::vector<Eigen::Index> entries;
            for (const std::size_t k : group) {
                entries.push_back(2 * static_cast<Eigen::Index>(k) + observable);
            }
            result.push_back(std::move(entries));
        }
    }
    return result;
}

/// Place of each reading, from 1, in the order in which the readings were taken: by time or, where
/// one table contains no time, by line. Zeros where tables without times do not show the order.
std::vector<double> run_order(const std::vector<Reading>& readings) {
    const bool timed = std::ranges::any_of(
        readings, [&](const Reading& r) { return r.condition.time != readings[0].condition.time; });
    const bool one_file = std::ranges::all_of(
        readings, [&](const Reading& r) { return r.origin.file == readings[0].origin.file; });
    if (!timed && !one_file) return std::vector<double>(readings.size(), 0.0);
    std::vector<std::size_t> places(readings.size());
    std::iota(places.begin(), places.end(), std::size_t{0});
    std::ranges::sort(places, {}, [&](std::size_t k) {
        const Reading& r = readings[k];
        return std::tuple(r.condition.time, r.origin.file, r.origin.line, r.step);
    });
    std::vector<double> order(readings.size());
    for (std::size_t k = 0; k < places.size(); ++k) {
        order[places[k]] = static_cast<double>(k + 1);
    }
    return order;
}

/// Height of the sample [m] that the model predicts for a reading: V/(A Phi_model). The measured
/// height V/(A Phi) has the error of the measured solid fraction Phi.
double predicted_height(const Reading& reading, double predicted_fraction) {
    return reading.condition.height.value_or(0) * reading.value(1) / predicted_fraction;
}

/// Inertial number [1] of a reading at the predicted height; the shear rate is proportional to
/// 1/height. A table that states the number has no error of the height in it.
double predicted_inertial_number(const Reading& reading, double predicted_fraction) {
    const double number = reading.condition.inertial_number;
    return reading.condition.height && reading.shear_rate > 0
               ? number * predicted_fraction / reading.value(1)
               : number;
}

/// Quantity along which residuals are checked. The checks use ranks. If the error of a
/// reading moved the rank of this reading, its residual would depend on its rank in a right model
/// too. Of each reading, a quantity must therefore be free of the reading's own errors.
struct CheckedQuantity {
    enum class OwnErrors {
        none,
        /// Small, and averaged over the readings at a condition, which then have one rank.
        averaged
    };
    std::string name;
    OwnErrors errors;
    std::function<double(std::size_t)> of_reading;
};

std::vector<CheckedQuantity> quantities_of(const std::vector<Reading>& readings,
                                           const Eigen::VectorXd& predicted) {
    using enum CheckedQuantity::OwnErrors;
    const auto fraction = [&predicted](std::size_t k) {
        return predicted(2 * static_cast<Eigen::Index>(k) + 1);
    };
    return {{"normal stress", averaged,
             [&readings](std::size_t k) { return readings[k].condition.normal_stress; }},
            {"inertial number", averaged,
             [&readings, fraction](std::size_t k) {
                 return predicted_inertial_number(readings[k], fraction(k));
             }},
            {"liquid content", none,
             [&readings](std::size_t k) { return readings[k].condition.liquid_content; }},
            {"height", averaged,
             [&readings, fraction](std::size_t k) {
                 return predicted_height(readings[k], fraction(k));
             }},
            {"time", none, [&readings](std::size_t k) { return readings[k].condition.time; }},
            {"run order", none, [order = run_order(readings)](std::size_t k) { return order[k]; }}};
}

/// Values of a quantity for each reading, without the readings' own errors.
Eigen::VectorXd values_of(const CheckedQuantity& quantity, const std::vector<Reading>& readings,
                          const std::vector<std::vector<std::size_t>>& conditions) {
    Eigen::VectorXd values(std::ssize(readings));
    for (std::size_t k = 0; k < readings.size(); ++k)
        values(static_cast<Eigen::Index>(k)) = quantity.of_reading(k);
    if (quantity.errors == CheckedQuantity::OwnErrors::none) return values;
    for (const auto& condition : conditions) {
        const std::vector<Eigen::Index> members(condition.begin(), condition.end());
        values(members).setConstant(values(members).mean());
    }
    return values;
}

}  // namespace

std::vector<Covariate> covariates_of(const std::vector<Reading>& readings,
                                     const Eigen::VectorXd& predicted, std::size_t direct) {
    const auto conditions = replicate_groups(readings);
    std::vector<Covariate> result;
    for (const CheckedQuantity& quantity : quantities_of(readings, predicted)) {
        const Eigen::VectorXd of_readings = values_of(quantity, readings, conditions);
        const auto entries = static_cast<Eigen::Index>(2 * readings.size() + direct);
        Covariate covariate{quantity.name, Eigen::VectorXd::Constant(entries, std::nan(""))};
        for (Eigen::Index k = 0; k < of_readings.size(); ++k)
            covariate.values.segment<2>(2 * k).setConstant(of_readings(k));
        const double low = of_readings.minCoeff(), high = of_readings.maxCoeff();
        // Quantities that vary by less than a tenth are constant set points with their scatter. The
        // ranks of the times give the run order.
        const bool known =
            quantity.name == "run order" && !result.empty() && result.back().name == "time";
        if (!known && high - low > 0.1 * std::max(std::abs(low), std::abs(high))) {
            result.push_back(std::move(covariate));
        }
    }
    return result;
}

EntryKinds entries_of(const std::vector<Reading>& readings,
                      const std::vector<Parameter>& parameters, std::size_t direct) {
    EntryKinds kinds{.observables = {"shear stress", "solid fraction"},
                     .conditions = entries_by_condition(readings)};
    for (const Parameter& parameter : parameters) {
        kinds.parameters.push_back(parameter.name);
    }
    for (const Reading& reading : readings) {
        kinds.observable.insert(kinds.observable.end(), {0, 1});
        kinds.replicated |= reading.replicates > 1;
    }
    for (std::size_t k = 0; k < direct; ++k) {
        // Each direct measurement is an observable and a condition of its own, without trends.
        kinds.observable.push_back(kinds.observables.size() + k);
        kinds.conditions.push_back({static_cast<Eigen::Index>(2 * readings.size() + k)});
    }
    return kinds;
}

}  // namespace pendular
