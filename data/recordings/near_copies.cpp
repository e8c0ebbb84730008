#include "data/recordings/copies.h"

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <set>
#include <string>
#include <utility>

#include "data/quantities/statistics.h"
#include "data/recordings/reading_groups.h"
#include "data/recordings/replicate_table.h"
#include "data/recordings/scatter.h"

namespace pendular {
namespace {

using Kind = Remark::Kind;

/// Probability [1] of a false report in an honest study, all pairs of files and both tests
/// together. So small since readings are left out, as for far conditions (`far_replicates.cpp`).
constexpr double copied_by_chance = 1e-3;
/// Factor [1] by which standard errors from the scatter within a step may be too large: those of
/// series with few correlation times are known to about that, and a wobble or drift that all
/// replicates share adds to them.
constexpr double overestimate = 2;
/// Largest scatter between two files over that between the others [1]. Chosen: honest fillings and
/// operators differ by a factor of 2 to 3.
constexpr double far_below = 0.25;
/// Fewest steps in common: with fewer, agreement by chance cannot be told from a copy.
constexpr std::size_t fewest_steps = 2;
/// Degrees of freedom of the other files from which their scatter is known well enough. Chosen, as
/// in `far_replicates.cpp`.
constexpr double fewest_of_others = 4;
/// Files beyond which nothing is compared, since the time grows with the square of their number.
constexpr std::size_t most_files = 500;

using Members = std::vector<std::size_t>;

/// Steps that two files have in common.
struct Pair {
    std::vector<std::pair<std::size_t, std::size_t>> readings;  ///< in the earlier and later file
    Eigen::Matrix2Xd differences;                               ///< d of each [1]
    bool fractions_known = true;  ///< an unknown solid fraction shows no scatter
};

Eigen::Vector2d logs(const Reading& reading) {
    return {std::log(reading.stress_ratio()), std::log(reading.value(1))};
}

Pair steps_in_common(const std::vector<Reading>& readings, const Members& earlier,
                     const Members& later) {
    Pair pair;
    for (const std::size_t b : later) {
        const auto a = std::ranges::find_if(earlier, [&](std::size_t k) {
            return readings[k].step == readings[b].step && are_replicates(readings[k], readings[b]);
        });
        if (a != earlier.end()) pair.readings.emplace_back(*a, b);
    }
    pair.differences.resize(2, std::ssize(pair.readings));
    for (std::size_t i = 0; i < pair.readings.size(); ++i) {
        const auto [a, b] = pair.readings[i];
        pair.differences.col(static_cast<Eigen::Index>(i)) = logs(readings[a]) - logs(readings[b]);
        if (readings[a].fraction_unknown() || readings[b].fraction_unknown())
            pair.fractions_known = false;
    }
    return pair;
}

/// Probability [1] that the scatter within the recordings alone makes so small differences of
/// stress ratio or solid fraction. Each by itself: noise that is small for one column may not be
/// for the other.
double p_of_rows(const std::vector<Reading>& readings, const Pair& pair) {
    Eigen::Array2d chi2 = Eigen::Array2d::Zero();
    for (std::size_t i = 0; i < pair.readings.size(); ++i) {
        const auto [a, b] = pair.readings[i];
        const Eigen::Array2d d = pair.differences.col(static_cast<Eigen::Index>(i));
        for (const Eigen::Index o : {0, 1})
            chi2(o) += d(o) * d(o) /
                       (relative_variance(readings[a], o) + relative_variance(readings[b], o));
    }
    if (!pair.fractions_known) chi2(1) = INFINITY;
    return 1 - chi_squared_tail(overestimate * overestimate * chi2.minCoeff(),
                                static_cast<double>(pair.readings.size()));
}

/// Scatter of stress ratio and solid fraction between the files of a cluster without one.
using OtherFiles = std::array<ScatterSums, 2>;

OtherFiles files_beside(const ReplicateTable& table, std::size_t reading) {
    OtherFiles sums;
    for (const std::size_t o : {0, 1}) {
        std::vector<ReplicatedValue> others = table.clusters[table.cluster_of[reading]].values[o];
        std::erase_if(others, [&](const ReplicatedValue& value) {
            return value.file == table.file_of[reading];
        });
        sums[o] = analyse_scatter(others, 0);
    }
    return sums;
}

/// Probability [1] that two files scatter so little beside the others of their cluster.
double p_of_others(const OtherFiles& others, const Pair& pair) {
    const double freedom = static_cast<double>(pair.readings.size()) - 1;
    double p = 1;
    for (const Eigen::Index o : {0, 1}) {
        if (o == 1 && !pair.fractions_known) continue;
        const ScatterSums& sums = others[static_cast<std::size_t>(o)];
        if (sums.freedom_within < fewest_of_others || freedom < 1 || !(sums.within > 0)) continue;
        const Eigen::ArrayXd d = pair.differences.row(o).transpose().array();
        const double own = (d - d.mean()).square().sum() / 2 / freedom;
        const double ratio = own / (sums.within / sums.freedom_within);
        if (ratio > far_below * far_below) continue;
        // The lower tail of F is the upper one of 1/F, with exchanged degrees of freedom.
        p = std::min(p, fisher_f_tail(1 / std::max(ratio, 1e-12), sums.freedom_within, freedom));
    }
    return p;
}

/// Recordings of a study, to compare each with those before it.
class Comparison {
  public:
    Comparison(const std::vector<Reading>& readings, const std::vector<Remark>& before)
        : readings_(readings), table_(replicate_table(readings)), files_(table_.files.size()) {
        for (std::size_t k = 0; k < readings.size(); ++k)
            if (is_compared(readings[k])) files_[table_.file_of[k]].push_back(k);
        for (const Remark& remark : before)
            if (remark.kind == Kind::coarse_steps)
                coarse_.insert(remark.files.begin(), remark.files.end());
    }

    std::vector<Remark> copies() const {
        std::vector<Remark> found;
        if (files_.size() > most_files) return found;
        const double limit = copied_by_chance / tests();
        for (std::size_t later = 1; later < files_.size(); ++later) {
            std::optional<OtherFiles> others;  // the same for all earlier files
            for (std::size_t earlier = 0; earlier < later; ++earlier) {
                const Pair pair = steps_in_common(readings_, files_[earlier], files_[later]);
                if (pair.readings.size() < fewest_steps) continue;
                if (!others) others = files_beside(table_, pair.readings.front().second);
                const double p = p_of(pair, *others);
                if (!(p < limit)) continue;
                report(pair, p, found);
                break;
            }
        }
        return found;
    }

  private:
    static bool is_compared(const Reading& reading) {
        return reading.within_run_only && reading.step > 0 && reading.value.minCoeff() > 0 &&
               reading.covariance.diagonal().minCoeff() > 0;
    }
    /// Number of tests: of two quantities by the rows and by the other files, for each pair.
    double tests() const {
        const auto files = static_cast<double>(
            std::ranges::count_if(files_, [](const Members& file) { return !file.empty(); }));
        return std::max(1.0, 4 * files * (files - 1) / 2);
    }
    bool is_coarse(std::size_t reading) const {
        return coarse_.contains(readings_[reading].origin.file);
    }
    double p_of(const Pair& pair, const OtherFiles& others) const {
        const auto [earlier, later] = pair.readings.front();
        const double of_others = p_of_others(others, pair);
        if (is_coarse(earlier) || is_coarse(later)) return of_others;
        return std::min(of_others, p_of_rows(readings_, pair));
    }
    void report(const Pair& pair, double p, std::vector<Remark>& found) const {
        for (const auto& [a, b] : pair.readings) {
            Remark& copy = found.emplace_back(readings_[b].remark(Kind::repeated_reading));
            copy.add(readings_[a].origin);
            copy.relative = scatter(pair);
        }
        const auto [a, b] = pair.readings.front();
        found.push_back({.kind = Kind::copied_readings,
                         .files = {readings_[a].origin.file, readings_[b].origin.file},
                         .count = pair.readings.size(),
                         .relative = scatter(pair),
                         .p = p});
    }
    /// Root mean square difference of the stress ratios [1].
    static double scatter(const Pair& pair) {
        return std::sqrt(pair.differences.row(0).squaredNorm() /
                         static_cast<double>(pair.readings.size()));
    }

    const std::vector<Reading>& readings_;
    ReplicateTable table_;
    std::vector<Members> files_;  ///< indices of the compared readings of each file
    std::set<std::string> coarse_;
};

}  // namespace

std::vector<Remark> near_copies(const std::vector<Reading>& readings,
                                const std::vector<Remark>& before) {
    return Comparison(readings, before).copies();
}

}  // namespace pendular
