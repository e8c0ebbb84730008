#include "analysis/design/separating_series.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <map>
#include <set>

namespace pendular {
namespace {

using Pair = std::pair<std::size_t, std::size_t>;
using Counts = std::map<std::size_t, int>;  ///< number of readings at each point, by its index

/// Smallest increase of the noncentrality [1] that counts as progress. Each reading increases it by
/// a little: without a limit, the search would spend all allowed readings.
constexpr double least_gain = 1e-3 * telling_noncentrality;

/// Difference of two rivals' predictions at all points, with its covariance from errors of
/// parameters and simulation, without the noise of the readings.
struct Contrast {
    Pair rivals;
    Eigen::VectorXd difference;
    Eigen::MatrixXd covariance;
};

std::vector<Contrast> contrasts_of(const std::vector<FittedModel>& rivals,
                                   const std::vector<Point>& points,
                                   Eigen::VectorXd& first_forecast) {
    std::vector<Prediction> predicted;
    std::vector<Eigen::MatrixXd> by_parameters;
    for (const FittedModel& rival : rivals) {
        predicted.push_back(predicted_at(rival, points));
        const Eigen::MatrixXd& slopes = predicted.back().jacobian;
        by_parameters.emplace_back(slopes * rival.fit.covariance * slopes.transpose());
    }
    first_forecast = predicted.front().value;
    std::vector<Contrast> contrasts;
    for (std::size_t i = 0; i < rivals.size(); ++i) {
        for (std::size_t j = i + 1; j < rivals.size(); ++j) {
            contrasts.push_back({{i, j},
                                 predicted[i].value - predicted[j].value,
                                 by_parameters[i] + by_parameters[j] +
                                     0.5 * (predicted[i].covariance + predicted[j].covariance)});
        }
    }
    return contrasts;
}

class SeriesSearch {
  public:
    SeriesSearch(const std::vector<FittedModel>& rivals, const std::vector<Point>& points,
                 const Eigen::Vector2d& relative_noise, int most_repeats, int most_readings)
        : points_(points), most_repeats_(most_repeats), most_readings_(most_readings) {
        for (const Point& point : points) {
            first_entry_.push_back(entries_);
            entries_ += entries_at(point);
        }
        Eigen::VectorXd forecast;
        contrasts_ = contrasts_of(rivals, points, forecast);
        noise_ = noise_at(points, forecast, relative_noise);
    }

    Series run() {
        std::vector<const Contrast*> wanted;
        for (const Contrast& contrast : contrasts_) {
            wanted.push_back(&contrast);
        }
        // Pairs that remain indistinguishable would cost readings without a benefit: the search is
        // repeated without these pairs.
        Counts counts;
        while (!wanted.empty()) {
            counts = greedy(wanted);
            std::vector<const Contrast*> reached;
            std::ranges::copy_if(wanted, std::back_inserter(reached),
                                 [&](const Contrast* each) { return told(*each, counts); });
            if (reached.size() == wanted.size()) break;
            if (reached.empty() && wanted.size() > 1) {
                reached = {*std::ranges::max_element(wanted, {}, [&](const Contrast* each) {
                    return noncentrality(*each, counts);
                })};
            }
            wanted = std::move(reached);
        }
        if (wanted.empty()) return {};
        return series_of(without_needless(counts, wanted), wanted);
    }

  private:
    double noncentrality(const Contrast& contrast, const Counts& counts) const {
        std::vector<Eigen::Index> entries;
        std::vector<double> noise;
        for (const auto& [point, readings] : counts) {
            for (Eigen::Index k = 0; k < entries_at(points_[point]); ++k) {
                entries.push_back(first_entry_[point] + k);
                noise.push_back(noise_(entries.back()) / readings);
            }
        }
        const Eigen::VectorXd difference = contrast.difference(entries);
        Eigen::MatrixXd covariance = contrast.covariance(entries, entries);
        covariance.diagonal() += Eigen::Map<const Eigen::VectorXd>(
            noise.data(), static_cast<Eigen::Index>(noise.size()));
        return difference.dot(covariance.ldlt().solve(difference));
    }
    bool told(const Contrast& contrast, const Counts& counts) const {
        return noncentrality(contrast, counts) >= telling_noncentrality;
    }
    /// Sum of the noncentralities of the wanted pairs, each limited to `telling_noncentrality`.
    double progress(const std::vector<const Contrast*>& wanted, const Counts& counts) const {
        double sum = 0;
        for (const Contrast* contrast : wanted) {
            sum += std::min(noncentrality(*contrast, counts), telling_noncentrality);
        }
        return sum;
    }
    double cost(const Counts& counts) const {
        double sum = 0, longest_wait = 0;
        std::set<std::optional<double>> filled;
        for (const auto& [point, readings] : counts) {
            const Point& p = points_[point];
            if (!p.direct && filled.insert(p.condition.bead_volume).second) sum += p.first_cost;
            longest_wait = std::max(longest_wait, p.wait_cost);
            sum += p.cost * readings;
        }
        return sum + longest_wait;
    }

    Counts greedy(const std::vector<const Contrast*>& wanted) const {
        Counts counts;
        double now = 0;
        for (int readings = 0; readings < most_readings_; ++readings) {
            double best_rate = 0, best_progress = now;
            std::size_t best = points_.size();
            for (std::size_t point = 0; point < points_.size(); ++point) {
                const auto known = counts.find(point);
                if (known != counts.end() && known->second >= most_repeats_) continue;
                Counts more = counts;
                ++more[point];
                const double then = progress(wanted, more);
                const double rate = (then - now) / (cost(more) - cost(counts));
                if (then - now > least_gain && rate > best_rate) {
                    best_rate = rate, best_progress = then, best = point;
                }
            }
            if (best == points_.size()) break;
            ++counts[best];
            now = best_progress;
        }
        return counts;
    }

    Counts without_needless(Counts counts, const std::vector<const Contrast*>& wanted) const {
        for (bool left_out = true; left_out;) {
            left_out = false;
            for (const auto& [point, readings] : Counts(counts)) {
                Counts fewer = counts;
                if (--fewer[point] == 0) fewer.erase(point);
                if (!fewer.empty() && std::ranges::all_of(wanted, [&](const Contrast* each) {
                        return told(*each, fewer);
                    })) {
                    counts = std::move(fewer);
                    left_out = true;
                }
            }
        }
        return counts;
    }

    Series series_of(const Counts& counts, const std::vector<const Contrast*>& told) const {
        Series series{.cost = cost(counts)};
        for (const auto& [point, readings] : counts) {
            series.steps.push_back({point, readings});
        }
        std::ranges::stable_sort(
            series.steps, {}, [&](const Series::Step& step) { return points_[step.point].wait; });
        for (const Contrast* contrast : told) {
            series.separated.push_back(contrast->rivals);
        }
        return series;
    }

    const std::vector<Point>& points_;
    int most_repeats_, most_readings_;
    std::vector<Contrast> contrasts_;
    std::vector<Eigen::Index> first_entry_;  ///< index of the first value of each point
    Eigen::Index entries_ = 0;
    Eigen::VectorXd noise_;  ///< variance of each value in one reading
};

}  // namespace

int Series::readings() const {
    int sum = 0;
    for (const Step& step : steps) {
        sum += step.readings;
    }
    return sum;
}

Series separating_series(const std::vector<FittedModel>& rivals, const std::vector<Point>& points,
                         const Eigen::Vector2d& relative_noise, int most_repeats,
                         int most_readings) {
    return SeriesSearch(rivals, points, relative_noise, most_repeats, most_readings).run();
}

}  // namespace pendular
