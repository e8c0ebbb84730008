#include "data/recordings/findings/detectors.h"

#include <algorithm>
#include <cmath>

#include "data/quantities/statistics.h"
#include "data/recordings/autoregression.h"

namespace pendular {

std::vector<Remark> wobble_tests(const std::string& file, const std::vector<RecordedStep>& steps) {
    std::vector<Remark> tests;
    for (const RecordedStep& step : steps) {
        for (const PeriodicColumn& column : step.periodic) {
            const double mean = std::abs(column.mean);
            for (const Harmonic& h : column.harmonics)
                tests.push_back({.kind = Remark::Kind::wobble,
                                 .quantity = column.quantity,
                                 .files = {file},
                                 .step = step.number,
                                 .size = h.amplitude,
                                 .size_error = h.standard_error,
                                 .relative = h.amplitude / mean,
                                 .relative_error = h.standard_error / mean,
                                 .period = 1.0 / h.per_turn,
                                 .p = h.p,
                                 .corrected = step.beyond_whole_turns > 0 && h.per_turn == 1});
        }
    }
    return tests;
}

namespace {

/// Limits of a sudden change, in robust deviations of all increments and in steps of the
/// resolution: values that flicker between three levels change by up to two steps.
constexpr double sudden = 3, resolved = 2.5;
/// Number of means that are compared, twice `shortest_step`, and largest number of samples in a
/// mean: slips over more samples are not sudden. Chosen.
constexpr std::size_t least_slip_samples = 40, longest_mean = 8;

/// Means of successive groups of samples.
std::vector<double> group_means(std::span<const double> samples, std::size_t group) {
    std::vector<double> means;
    for (std::size_t k = 0; k + group <= samples.size(); k += group)
        means.push_back(plain_mean(samples.subspan(k, group)));
    return means;
}

/// Sudden drops of a series, with the number of its sudden rises.
struct SuddenChanges {
    std::vector<double> drops;        ///< sizes
    std::vector<std::size_t> places;  ///< indices of the increments with which the drops begin
    std::size_t rises = 0;
    double usual = 0;  ///< median increment
    double noise = 0;  ///< robust deviation of the increments
};

SuddenChanges sudden_changes(const std::vector<double>& series, double resolution) {
    std::vector<double> increments;
    for (std::size_t k = 1; k < series.size(); ++k)
        increments.push_back(series[k] - series[k - 1]);
    // Between drops the torque rises steadily; what exceeds the usual rise is sudden.
    const double usual = median(increments);
    for (double& increment : increments)
        increment -= usual;
    const double limit = std::max(sudden * robust_deviation(increments), resolved * resolution);
    SuddenChanges found{.usual = usual, .noise = robust_deviation(increments)};
    for (std::size_t k = 0; k < increments.size();) {
        const bool down = increments[k] < -limit;
        const bool up = increments[k] > limit;
        const std::size_t begin = k;
        double change = 0;
        do {
            change += increments[k++];
        } while ((down || up) && k < increments.size() &&
                 (down ? increments[k] < -limit : increments[k] > limit));
        if (down) {
            found.drops.push_back(-change);
            found.places.push_back(begin);
        }
        found.rises += up;
    }
    return found;
}

/// Mean distance of successive drops, as a number of values.
double distance_of(const SuddenChanges& found) {
    return static_cast<double>(found.places.back() - found.places.front()) /
           static_cast<double>(found.places.size() - 1);
}

/// Whether drops are those of a sawtooth: far beyond the noise, of one size, without sudden rises,
/// and each as large as the slow rise since the drop before. The number of drops, on which
/// `asymmetry_p` rests, is then no limit of what is certain: noise has no such drop, and one that
/// falls out and comes back rises suddenly too.
bool is_sawtooth(const SuddenChanges& found) {
    constexpr std::size_t fewest = 5;  // chosen: of fewer, neither size nor distance is regular
    constexpr double far = 20, same = 2;
    if (found.drops.size() < fewest || found.rises > 0) return false;
    const auto [least, most] = std::ranges::minmax(found.drops);
    const double rise = found.usual * distance_of(found);
    return least > far * found.noise && most < same * least && rise > least / same &&
           rise < most * same;
}

/// Probability of at least this number of drops among sudden changes that are as often rises [1].
double asymmetry_p(const SuddenChanges& found) {
    const double drops = static_cast<double>(found.drops.size());
    if (found.drops.empty()) return 1;
    return binomial_at_least(drops, drops + static_cast<double>(found.rises), 0.5);
}

}  // namespace

std::optional<Slips> slips(std::span<const double> samples, double resolution) {
    if (samples.size() < least_slip_samples) return std::nullopt;
    Slips best;
    int tests = 0;
    for (std::size_t group = 1; group <= longest_mean; group *= 2) {
        const std::vector<double> means = group_means(samples, group);
        if (means.size() < least_slip_samples) break;
        ++tests;
        const SuddenChanges found = sudden_changes(means, resolution);
        const double p = is_sawtooth(found) ? 0 : asymmetry_p(found);
        if (p < best.p)
            best = {median(found.drops),
                    found.drops.size() > 1 ? static_cast<double>(group) * distance_of(found)
                                           : static_cast<double>(samples.size()),
                    p};
    }
    best.p = std::min(1.0, tests * best.p);
    return best;
}

std::vector<Remark> stick_slip_tests(const std::string& file,
                                     const std::vector<RecordedStep>& steps) {
    std::vector<Remark> tests;
    for (const RecordedStep& step : steps) {
        const auto part = level_part(step);
        if (!part) continue;
        const auto found = slips(part->torque, least_step(part->torque));
        if (!found) continue;
        const double seconds =
            (part->time.back() - part->time.front()) / static_cast<double>(part->size() - 1);
        tests.push_back({.kind = Remark::Kind::stick_slip,
                         .quantity = "torque",
                         .files = {file},
                         .step = step.number,
                         .size = found->drop,
                         .relative = found->drop / std::abs(plain_mean(part->torque)),
                         .period = found->samples * seconds,
                         .p = found->p});
    }
    return tests;
}

}  // namespace pendular
