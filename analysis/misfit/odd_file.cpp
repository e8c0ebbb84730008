#include "analysis/misfit/odd_file.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "analysis/misfit/compare.h"
#include "data/quantities/statistics.h"

namespace pendular {
namespace {

/// Largest p of a file that is the first to look at. Chosen: where fillings scatter, one study in
/// four names a file that is not odd, which costs a look at a recording.
constexpr double look_at = 0.25;

/// Deviations of one observable from a model, by file.
struct FileDeviations {
    std::string file;
    std::vector<const Reading*> readings;
    std::vector<double> values;  ///< measured/predicted - 1 [1]

    double mean() const {
        return std::accumulate(values.begin(), values.end(), 0.0) /
               static_cast<double>(values.size());
    }
};

/// Files with at least two readings, in the order of the readings.
std::vector<FileDeviations> by_file(const std::vector<Reading>& readings,
                                    const Eigen::VectorXd& predicted, Eigen::Index observable) {
    std::vector<FileDeviations> files;
    for (std::size_t k = 0; k < readings.size(); ++k) {
        const std::string& name = readings[k].origin.file;
        auto at = std::ranges::find(files, name, &FileDeviations::file);
        if (at == files.end()) at = files.insert(at, {.file = name, .readings = {}, .values = {}});
        at->readings.push_back(&readings[k]);
        at->values.push_back(readings[k].value(observable) /
                                 predicted(2 * static_cast<Eigen::Index>(k) + observable) -
                             1);
    }
    std::erase_if(files, [](const FileDeviations& each) { return each.values.size() < 2; });
    return files;
}

/// Variance of the readings within files, with its degrees of freedom.
struct Within {
    double variance = 0, freedom = 0;
};
Within within(const std::vector<FileDeviations>& files) {
    Within result;
    for (const FileDeviations& each : files) {
        const double mean = each.mean();
        for (const double value : each.values)
            result.variance += (value - mean) * (value - mean);
        result.freedom += static_cast<double>(each.values.size() - 1);
    }
    result.variance /= result.freedom;
    return result;
}

/// Mean and variance of the means of all files but one, and the variance that the scatter within
/// files gives to the mean of a file.
struct Others {
    double mean = 0, variance = 0, by_readings = 0;
};
Others others_than(std::size_t one, const std::vector<FileDeviations>& files, double variance) {
    Others others;
    const auto count = static_cast<double>(files.size() - 1);
    for (std::size_t k = 0; k < files.size(); ++k) {
        if (k == one) continue;
        others.mean += files[k].mean() / count;
        others.by_readings += variance / static_cast<double>(files[k].values.size()) / count;
    }
    for (std::size_t k = 0; k < files.size(); ++k) {
        if (k != one) others.variance += std::pow(files[k].mean() - others.mean, 2) / (count - 1);
    }
    return others;
}

/// Probability of a distance as large, on either side, in one of `tests` tests.
double p_of(double distance, double variance, double freedom, double tests) {
    if (!(variance > 0)) return distance == 0 ? 1 : 0;
    return std::min(1.0,
                    2 * tests * students_t_tail(std::abs(distance) / std::sqrt(variance), freedom));
}

std::optional<double> mean_height(const FileDeviations& file) {
    double sum = 0;
    for (const Reading* const reading : file.readings) {
        if (!reading->condition.height) return std::nullopt;
        sum += *reading->condition.height;
    }
    return sum / static_cast<double>(file.readings.size());
}

bool is_alone(const FileDeviations& file, const std::vector<FileDeviations>& files) {
    const double content = file.readings.front()->condition.liquid_content;
    return std::ranges::none_of(files, [&](const FileDeviations& other) {
        return other.file != file.file &&
               std::ranges::any_of(other.readings, [&](const Reading* reading) {
                   return reading->condition.liquid_content == content;
               });
    });
}

/// The file with the smallest p in one observable.
std::optional<OddFile> oddest(const std::vector<FileDeviations>& files, Eigen::Index observable) {
    const Within inside = within(files);
    const auto count = static_cast<double>(files.size());
    const double tests = 2 * count;
    std::optional<OddFile> found;
    for (std::size_t k = 0; k < files.size(); ++k) {
        const Others others = others_than(k, files, inside.variance);
        const double mean = files[k].mean(), distance = mean - others.mean;
        const double own = inside.variance / static_cast<double>(files[k].values.size());
        const double p =
            p_of(distance, std::max(others.variance, others.by_readings) * (1 + 1 / (count - 1)),
                 count - 2, tests);
        const double by_readings =
            p_of(distance, own + others.by_readings / (count - 1), inside.freedom, tests);
        if (found && found->p <= p) continue;
        found = {.file = files[k].file,
                 .observable = observable,
                 .deviation = mean,
                 .others = others.mean,
                 .files = files.size(),
                 .p = p,
                 .p_by_readings = by_readings,
                 .height = mean_height(files[k]),
                 .alone = is_alone(files[k], files)};
    }
    return found;
}

}  // namespace

bool OddFile::stands_out() const {
    return p < significant_p;
}

bool OddFile::worth_a_look() const {
    return stands_out() || (p < look_at && p_by_readings < significant_p);
}

std::optional<double> OddFile::gap_error() const {
    // The solid fraction is V/(A H).
    if (observable != 1 || !height) return std::nullopt;
    return -(deviation - others) * *height;
}

std::optional<OddFile> odd_file(const std::vector<Reading>& readings,
                                const Eigen::VectorXd& predicted) {
    std::optional<OddFile> found;
    for (const Eigen::Index observable : {0, 1}) {
        const std::vector<FileDeviations> files = by_file(readings, predicted, observable);
        if (files.size() < 3) continue;
        const std::optional<OddFile> one = oddest(files, observable);
        if (one && (!found || one->p < found->p)) found = one;
    }
    return found;
}

}  // namespace pendular
