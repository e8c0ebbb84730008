#include "data/recordings/findings/detectors.h"

#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <numeric>

#include "data/quantities/decompositions.h"
#include "data/quantities/statistics.h"
#include "data/recordings/reading_groups.h"

namespace pendular {
namespace {

/// Smallest degrees of freedom of a comparison. With two, Student's t would have to exceed 14 at
/// `finding_significance`, with three 7.5.
constexpr double least_freedom = 3;
/// Smallest number of recordings on each side of a step, since one odd recording is no step.
constexpr Eigen::Index least_side = 2;
/// Ratio of the squared deviations with an offset to those with a factor, below which a change is
/// called an offset [1]. Chosen: in doubt, a change is a factor.
constexpr double share_left = 0.8;

/// Paths of the files of readings, in the order of their first reading in time.
std::vector<std::string> files_in_order(const std::vector<Reading>& readings) {
    std::map<std::string, double> begin;
    for (const Reading& r : readings) {
        const auto [at, fresh] = begin.try_emplace(r.origin.file, r.condition.time);
        if (!fresh) at->second = std::min(at->second, r.condition.time);
    }
    std::vector<std::string> files;
    for (const auto& [file, time] : begin)
        files.push_back(file);
    std::ranges::stable_sort(files, {}, [&](const std::string& file) { return begin[file]; });
    return files;
}

/// Comparison of the recordings of a study: a linear map that removes from values of readings what
/// their conditions explain and averages the rest over each recording.
struct FileComparison {
    std::vector<std::string> files;     ///< in run order
    std::vector<Eigen::Index> file_of;  ///< index of the file of each reading
    /// Readings at one condition, whose mean is removed before the averages over files; or none.
    std::vector<std::vector<std::size_t>> groups = {};
    /// Orthonormal basis, over files, of what is removed from the averages over files; or empty.
    Eigen::MatrixXd basis = {};
    double freedom = 0;  ///< degrees of freedom of the reduced values, for one slope

    Eigen::Index count() const { return static_cast<Eigen::Index>(files.size()); }
    /// 1 for readings of file k and later files, 0 for earlier readings.
    Eigen::VectorXd from(Eigen::Index k) const {
        Eigen::VectorXd result(std::ssize(file_of));
        std::ranges::transform(file_of, result.begin(),
                               [k](Eigen::Index file) { return file >= k ? 1.0 : 0.0; });
        return result;
    }
    /// Value of each reading's file.
    Eigen::VectorXd of_files(const Eigen::VectorXd& values) const { return values(file_of); }
    /// Mean over the readings of each file.
    Eigen::VectorXd averages(const Eigen::VectorXd& values) const {
        Eigen::VectorXd sums = Eigen::VectorXd::Zero(count()), counts = sums;
        for (Eigen::Index k = 0; k < values.size(); ++k) {
            const Eigen::Index file = file_of[static_cast<std::size_t>(k)];
            sums(file) += values(k);
            counts(file) += 1;
        }
        return sums.cwiseQuotient(counts);
    }
    /// Values of readings without the means of their conditions.
    Eigen::VectorXd centred(Eigen::VectorXd values) const {
        for (const auto& group : groups) {
            const std::vector<Eigen::Index> members(group.begin(), group.end());
            values(members).array() -= values(members).mean();
        }
        return values;
    }
    /// Values of files without what conditions explain.
    Eigen::VectorXd reduced(const Eigen::VectorXd& values) const {
        Eigen::VectorXd result = averages(centred(values));
        if (basis.cols() > 0) result -= basis * (basis.transpose() * result);
        return result;
    }
};

FileComparison comparison_of(const std::vector<Reading>& readings) {
    FileComparison result{.files = files_in_order(readings), .file_of = {}};
    std::map<std::string, Eigen::Index> index;
    for (Eigen::Index k = 0; k < result.count(); ++k)
        index[result.files[static_cast<std::size_t>(k)]] = k;
    for (const Reading& reading : readings)
        result.file_of.push_back(index.at(reading.origin.file));
    return result;
}

/// Number of sets of files that no condition connects.
std::size_t separate_sets(const FileComparison& comparison) {
    std::vector<std::size_t> root(comparison.files.size());
    std::iota(root.begin(), root.end(), std::size_t{0});
    const auto root_of = [&](std::size_t file) {
        while (root[file] != file)
            file = root[file] = root[root[file]];
        return file;
    };
    const auto file_of = [&](std::size_t reading) {
        return static_cast<std::size_t>(comparison.file_of[reading]);
    };
    for (const auto& group : comparison.groups)
        for (const std::size_t reading : group)
            root[root_of(file_of(reading))] = root_of(file_of(group.front()));
    std::size_t sets = 0;
    for (std::size_t file = 0; file < root.size(); ++file)
        sets += root[file] == file;
    return sets;
}

/// Readings at conditions that at least two files share.
std::vector<Reading> readings_of_repeats(const std::vector<Reading>& readings) {
    std::vector<Reading> result;
    for (const auto& group : replicate_groups(readings)) {
        const bool shared = std::ranges::any_of(group, [&](std::size_t k) {
            return readings[k].origin.file != readings[group.front()].origin.file;
        });
        if (!shared) continue;
        for (const std::size_t k : group)
            result.push_back(readings[k]);
    }
    return result;
}

/// Comparison by repeated conditions: the mean of each condition is removed.
FileComparison by_repetition(const std::vector<Reading>& readings) {
    FileComparison result = comparison_of(readings);
    result.groups = replicate_groups(readings);
    result.freedom =
        static_cast<double>(result.files.size()) - static_cast<double>(separate_sets(result)) - 1;
    return result;
}

/// Readings of the liquid content and volume of grains with most readings.
std::vector<Reading> largest_filling(const std::vector<Reading>& readings) {
    std::map<std::pair<double, double>, std::vector<Reading>> fillings;
    for (const Reading& r : readings)
        fillings[{r.condition.liquid_content, r.condition.bead_volume.value_or(0)}].push_back(r);
    std::vector<Reading> largest;
    for (auto& [filling, members] : fillings)
        if (members.size() > largest.size()) largest = std::move(members);
    return largest;
}

/// Comparison by a smooth function of the conditions, fitted to the means of the files.
FileComparison by_smooth_trend(const std::vector<Reading>& readings) {
    FileComparison result = comparison_of(readings);
    const auto n = static_cast<Eigen::Index>(readings.size());
    Eigen::MatrixXd columns(n, 4);
    for (Eigen::Index r = 0; r < n; ++r) {
        const Condition& c = readings[static_cast<std::size_t>(r)].condition;
        const double stress = std::log(c.normal_stress / 1e3);
        const double rate = std::log(std::max(c.inertial_number, 1e-6) / 1e-2);
        columns.row(r) << 1, stress, stress * stress, rate;
    }
    Eigen::MatrixXd of_files(result.count(), columns.cols());
    for (Eigen::Index c = 0; c < columns.cols(); ++c)
        of_files.col(c) = result.averages(columns.col(c));
    // Set points scatter by a few thousandths: directions that vary less, relative to the largest,
    // are no trend.
    Eigen::ColPivHouseholderQR<Eigen::MatrixXd> trend(of_files);
    trend.setThreshold(0.02);
    const Eigen::Index rank = trend.rank();
    result.basis = basis_of(trend);
    result.freedom = static_cast<double>(result.count() - rank) - 1;
    return result;
}

/// Straight line through the origin of reduced values against a reduced regressor.
struct OriginLine {
    double slope = 0, error = 0, squares = INFINITY;
};

OriginLine origin_line(const Eigen::VectorXd& x, const Eigen::VectorXd& y, double freedom) {
    const double length = x.squaredNorm(), slope = x.dot(y) / length;
    const double squares = (y - slope * x).squaredNorm();
    return {slope, std::sqrt(squares / freedom / length), squares};
}

/// Whether at least `least_side` files lie on each side of a step, in its reduced regressor.
bool has_two_sides(const Eigen::VectorXd& x) {
    constexpr double some = 0.01;  // far above rounding
    return (x.array() > some).count() >= least_side && (x.array() < -some).count() >= least_side;
}

/// Whether an offset of the column [unit of `scale`] describes the change better than a factor.
/// `scale`: value of the column at each reading.
bool is_offset(const FileComparison& files, const Eigen::VectorXd& change,
               const Eigen::VectorXd& values, const Eigen::VectorXd& scale) {
    const auto squares = [&](const Eigen::VectorXd& regressor) {
        return origin_line(files.centred(regressor), files.centred(values), 1).squares;
    };
    return squares(change.cwiseQuotient(scale)) < share_left * squares(change);
}

/// Most significant step between the recordings in one column; p 1 for none.
/// @param values logarithm of the quantity that is constant at repeated conditions, by reading
/// @param column value of the column at each reading, in its SI unit
Remark strongest_step(const FileComparison& files, const Eigen::VectorXd& values,
                      const Eigen::VectorXd& column) {
    const Eigen::VectorXd reduced = files.reduced(values);
    const Eigen::VectorXd order = Eigen::VectorXd::LinSpaced(files.count(), -1, 1);
    const double steady_trend =
        origin_line(files.reduced(files.of_files(order)), reduced, files.freedom).squares;
    Remark best{.kind = Remark::Kind::level_change, .count = files.files.size()};
    OriginLine line;
    Eigen::Index first = 0;
    int tested = 0;
    for (Eigen::Index k = 1; k < files.count(); ++k) {
        const Eigen::VectorXd x = files.reduced(files.from(k));
        if (!has_two_sides(x)) continue;
        ++tested;
        const OriginLine each = origin_line(x, reduced, files.freedom);
        if (each.squares < line.squares) line = each, first = k;
    }
    if (tested == 0 || line.squares >= steady_trend || line.error <= 0) return best;
    const Eigen::VectorXd change = files.from(first);
    best.p = std::min(1.0, tested * two_sided_p(line.slope / line.error, files.freedom));
    best.relative = std::expm1(line.slope);
    best.relative_error = std::exp(line.slope) * line.error;
    best.files.assign(files.files.begin() + first, files.files.end());
    best.offset = is_offset(files, change, values, column);
    const double usual_value = median({column.begin(), column.end()});
    best.size = best.relative * usual_value;
    best.size_error = best.relative_error * usual_value;
    if (best.offset) {
        const OriginLine offset = origin_line(files.centred(change.cwiseQuotient(column)),
                                              files.centred(values), files.freedom);
        best.size = offset.slope;
        best.size_error = offset.error;
    }
    return best;
}

/// Values of a function of readings, one for each.
template <typename Function>
Eigen::VectorXd of_each(const std::vector<Reading>& readings, const Function& function) {
    Eigen::VectorXd result(static_cast<Eigen::Index>(readings.size()));
    std::ranges::transform(readings, result.begin(),
                           [&](const Reading& each) { return std::invoke(function, each); });
    return result;
}

}  // namespace

std::vector<Remark> level_change_tests(const std::vector<Reading>& readings,
                                       const AnnularCell& cell) {
    std::vector<Reading> compared = readings_of_repeats(readings);
    FileComparison files = by_repetition(compared);
    if (files.freedom < least_freedom) {
        compared = largest_filling(readings);
        files = by_smooth_trend(compared);
        // One degree more, since no function of the conditions is exact.
        if (files.freedom < least_freedom + 1) return {};
    }
    // Stress ratios rather than torques: at a repeated condition, the torque follows the scatter
    // of the normal stress.
    const Eigen::VectorXd ratios = of_each(compared, &Reading::stress_ratio);
    const Eigen::VectorXd torques =
        of_each(compared, [&](const Reading& r) { return torque(r.value(0), cell); });
    const Eigen::VectorXd gaps =
        of_each(compared, [&](const Reading& r) { return height(r.value(1), cell); });
    std::vector<Remark> tests = {strongest_step(files, ratios.array().log(), torques),
                                 strongest_step(files, gaps.array().log(), gaps)};
    tests[0].quantity = "torque";
    tests[1].quantity = "height";
    return tests;
}

}  // namespace pendular
