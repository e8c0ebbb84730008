#include "data/recordings/findings/drift.h"

#include <Eigen/QR>
#include <algorithm>
#include <cmath>

#include "data/quantities/statistics.h"
#include "data/recordings/findings/detectors.h"
#include "data/recordings/time_series.h"

namespace pendular {
namespace {

/// Smallest distance of the end of a step from its steady value, over this value; smallest bend
/// over its error; smallest share of steps that change in the sense of the mean [1]. Chosen: a
/// trend that does not clearly bend may go on, and is a drift, which steps share.
constexpr double least_distance = 0.005, clear_bend = 2.5, same_sense = 0.75;
constexpr std::size_t least_steps = 3;  ///< two change in the same sense in half of all cases

/// Second half of the samples of a step.
std::span<const double> second_half(const std::vector<double>& values) {
    return std::span(values).subspan(values.size() / 2);
}

/// Columns of a recording that should be constant after the transient.
struct LevelColumn {
    const char* quantity;
    std::vector<double> StepSeries::*values;
};
constexpr LevelColumn level_columns[] = {{"torque", &StepSeries::torque},
                                         {"height", &StepSeries::height}};

bool examined(const RecordedStep& step) {
    return step.lid_turns && step.series.size() >= 2 * shortest_step;
}

/// Relative changes of one column over the steps of a study, pooled.
struct PooledChange {
    double value = 0, error = 0;  ///< weighted mean with its standard error [1]
    double share = 0;             ///< share of the steps whose change has the sense of the mean [1]
    double freedom = 0;           ///< degrees of freedom of the error
};

/// Variance of the relative change of each step [1]. In strongly correlated noise, a step has few
/// independent rows and its own estimate is poor: the smallest estimates, whose steps would have
/// most weight, are too small. Each estimate is therefore averaged with the mean of all steps,
/// which counts as `common_freedom` degrees of freedom.
std::vector<double> variances_of(const std::vector<const StepTrend*>& trends) {
    // Chosen: a step in weakly correlated noise has some hundred of its own, so that it loses
    // nothing.
    constexpr double common_freedom = 10;
    const auto own = [](const StepTrend* trend) {
        return std::pow(trend->course.change_error / trend->course.mean, 2);
    };
    double mean = 0;
    for (const StepTrend* trend : trends)
        mean += own(trend) / static_cast<double>(trends.size());
    std::vector<double> variances;
    for (const StepTrend* trend : trends) {
        const double freedom = std::max(trend->course.freedom, 0.0);
        variances.push_back((freedom * own(trend) + common_freedom * mean) /
                            (freedom + common_freedom));
    }
    return variances;
}

PooledChange pooled(const std::vector<const StepTrend*>& trends) {
    const std::vector<double> variances = variances_of(trends);
    std::vector<double> changes;
    double weights = 0, sum = 0, freedom = 0;
    for (std::size_t k = 0; k < trends.size(); ++k) {
        const Course& course = trends[k]->course;
        changes.push_back(course.change / course.mean);
        weights += 1 / variances[k];
        sum += changes[k] / variances[k];
        freedom += std::max(course.freedom, 0.0);
    }
    PooledChange result{.value = sum / weights};
    double squares = 0;
    for (std::size_t k = 0; k < trends.size(); ++k) {
        squares += std::pow(changes[k] - result.value, 2) / variances[k];
        result.share += changes[k] * result.value > 0;
    }
    const double count = static_cast<double>(trends.size());
    result.share /= count;
    result.error = std::sqrt(std::max(1.0, squares / (count - 1)) / weights);
    // The errors of the steps are known at least as well as from the scatter of their changes.
    result.freedom = std::max(count - 1, std::min(freedom, 10.0));
    return result;
}

}  // namespace

double Course::distance_at_end() const {
    // An exponential approach decays from one third of the samples to the next by the factor r; the
    // means of the thirds differ by (change -+ 2 bend)/3.
    const double r = (change + 2 * bend) / (change - 2 * bend);
    if (!(r > 0 && r < 1)) return 0;
    const double last_third = std::abs(change + 2 * bend) / 3 * r / (1 - r), decay = -std::log(r);
    return last_third * decay / std::expm1(decay);
}

std::optional<Course> course_of(std::span<const double> samples) {
    if (samples.size() < shortest_step) return std::nullopt;
    const auto n = static_cast<Eigen::Index>(samples.size());
    const Eigen::ArrayXd x = Eigen::ArrayXd::LinSpaced(n, -1, 1);
    Eigen::MatrixXd columns(n, 3);
    columns << Eigen::ArrayXd::Ones(n), x / 2, (3 * x.square() - 1) / 2;
    const Eigen::Map<const Eigen::VectorXd> values(samples.data(), n);
    const Eigen::VectorXd fit = columns.householderQr().solve(values);
    const Eigen::VectorXd residuals = values - columns * fit;
    const Mean noise = mean_of_correlated({residuals.data(), samples.size()});
    if (noise.standard_error <= 1e-12 * std::abs(fit(0))) return std::nullopt;
    // Variances of the coefficients of the Legendre polynomials 1, x, (3 x^2 - 1)/2 are as 1:3:5.
    return Course{.mean = fit(0),
                  .change = fit(1),
                  .change_error = 2 * std::sqrt(3.0) * noise.standard_error,
                  .bend = fit(2),
                  .bend_error = std::sqrt(5.0) * noise.standard_error,
                  .freedom = static_cast<double>(n) / noise.correlation_samples - 3};
}

std::vector<StepTrend> step_trends(const std::string& file,
                                   const std::vector<RecordedStep>& steps) {
    std::vector<StepTrend> result;
    for (const RecordedStep& step : steps) {
        if (!examined(step)) continue;
        for (const LevelColumn& column : level_columns) {
            // A gap that creeps is a doubt of its own (Remark::Kind::creeping_gap).
            if (step.gap_creeps && column.values == &StepSeries::height) continue;
            if (const auto course = course_of(second_half(step.series.*column.values)))
                result.push_back({column.quantity, file, step.number, *course});
        }
    }
    return result;
}

std::vector<Remark> run_in_tests(const std::string& file, const std::vector<RecordedStep>& steps) {
    std::vector<Remark> tests;
    for (const StepTrend& trend : step_trends(file, steps)) {
        const Course& c = trend.course;
        const double distance = c.distance_at_end();
        const bool bends = std::abs(c.bend) > clear_bend * c.bend_error && distance > 0;
        const bool far = distance > least_distance * std::abs(c.mean);
        tests.push_back(
            {.kind = Remark::Kind::unfinished_run_in,
             .quantity = trend.quantity,
             .files = {file},
             .step = trend.step,
             .size = distance,
             .relative = distance / std::abs(c.mean),
             .p = bends && far ? two_sided_p(c.change / c.change_error, c.freedom) : 1});
    }
    return tests;
}

std::vector<Remark> drift_tests(const std::vector<StepTrend>& trends,
                                const std::vector<Remark>& unfinished) {
    std::vector<Remark> tests;
    for (const LevelColumn& column : level_columns) {
        std::vector<const StepTrend*> chosen;
        Remark test{.kind = Remark::Kind::drift, .quantity = column.quantity};
        for (const StepTrend& trend : trends) {
            const bool runs_in = std::ranges::any_of(unfinished, [&](const Remark& each) {
                return each.files.front() == trend.file && each.step == trend.step;
            });
            if (trend.quantity != column.quantity || runs_in) continue;
            chosen.push_back(&trend);
            if (test.files.empty() || test.files.back() != trend.file)
                test.files.push_back(trend.file);
        }
        if (chosen.size() < least_steps) continue;
        const PooledChange change = pooled(chosen);
        test.count = chosen.size();
        // Over the whole of a step, twice the change of its second half.
        test.relative = 2 * change.value;
        test.relative_error = 2 * change.error;
        std::vector<double> sizes;
        for (const StepTrend* trend : chosen)
            sizes.push_back(std::abs(trend->course.mean));
        test.size = test.relative * median(sizes);
        test.size_error = test.relative_error * median(sizes);
        test.p = change.share >= same_sense
                     ? two_sided_p(change.value / change.error, change.freedom)
                     : 1;
        tests.push_back(std::move(test));
    }
    return tests;
}

}  // namespace pendular
