#include "data/recordings/replicate_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "data/quantities/statistics.h"

namespace pendular {
namespace {

/// Largest plausible standard deviation between fillings, relative to (stress ratio, solid
/// fraction) [1]. Larger differences come from a wrong column, unit or mass.
const Eigen::Vector2d largest_filling_difference(0.05, 0.03);
/// Smallest differences between files that make a note: as a share of `largest_filling_difference`,
/// and over the scatter of steps within the files [1]. Chosen: smaller ones are the usual error of
/// a filling, which the covariance contains.
constexpr double noted_share = 0.5, noted_ratio = 3;
/// Probability, for all conditions of a cluster together, of a false report that the replicates of
/// a condition scatter too much.
constexpr double far_by_chance = 1e-3;
/// Degrees of freedom of all other conditions with which the usual scatter is known well enough to
/// call that of one condition unusual. Chosen.
constexpr double fewest_to_judge_conditions = 4;

using Values = std::vector<ReplicatedValue>;

Values without_condition(const Values& values, std::size_t condition) {
    Values rest;
    std::ranges::copy_if(values, std::back_inserter(rest), [&](const ReplicatedValue& value) {
        return value.condition != condition;
    });
    return rest;
}

Values without_file(const Values& values, std::size_t file) {
    Values rest;
    std::ranges::copy_if(values, std::back_inserter(rest),
                         [&](const ReplicatedValue& value) { return value.file != file; });
    return rest;
}

/// Condition whose replicates scatter most, compared with the replicates of all other conditions.
struct FarCondition {
    std::size_t condition = 0;
    double variance = 0;  ///< relative variance of one value at this condition [1]
    double p = 1;         ///< probability that any condition scatters so much by chance (F test)
};

FarCondition farthest(const Values& values) {
    const ScatterSums all = analyse_scatter(values, 0);
    FarCondition result;
    std::set<std::size_t> conditions;
    for (const ReplicatedValue& value : values) {
        if (!conditions.insert(value.condition).second) continue;
        const ScatterSums others = analyse_scatter(without_condition(values, value.condition), 0);
        const double freedom = all.freedom_within - others.freedom_within;
        if (others.freedom_within < fewest_to_judge_conditions || freedom < 1) continue;
        const double own = (all.within - others.within) / freedom;
        const double usual = std::max(others.within, others.run_variance) / others.freedom_within;
        if (!(usual > 0) || !(own > usual)) continue;
        const double p = fisher_f_tail(own / usual, freedom, others.freedom_within);
        if (p < result.p) result = {value.condition, own, p};
    }
    result.p *= static_cast<double>(conditions.size());
    return result;
}

/// Standard deviation between files, relative to the values [1].
double filling_difference(const ScatterSums& sums) {
    return sums.steps > 0 ? std::sqrt(sums.between / sums.steps) : 0;
}

/// Files of a cluster that may be wrong. If the cluster has at least three files and all but one
/// agree, this is the one file without which the others agree best; else all files.
std::vector<std::size_t> far_files(const ReplicateCluster& cluster, Eigen::Index o) {
    std::vector<std::size_t> far = cluster.files;
    double least = largest_filling_difference(o);
    for (const std::size_t file : cluster.files) {
        const ScatterSums others =
            analyse_scatter(without_file(cluster.values[static_cast<std::size_t>(o)], file), 0);
        if (others.freedom_between > 0 && filling_difference(others) <= least) {
            least = filling_difference(others);
            far = {file};
        }
    }
    return far;
}

Remark remark_on(Eigen::Index observable, Remark::Kind kind) {
    return {.kind = kind, .quantity = observable == 0 ? "shear_stress" : "solid_fraction"};
}

std::vector<std::string> names_of(const ReplicateTable& table,
                                  const std::vector<std::size_t>& files) {
    std::vector<std::string> names;
    for (const std::size_t file : files)
        names.push_back(table.name_of(file));
    return names;
}

/// Adds a note if the files of a cluster differ far more than the steps within each file.
void note_unlike_files(const ReplicateTable& table, const ReplicateCluster& cluster, Eigen::Index o,
                       FarReplicates& result) {
    const ScatterSums sums = analyse_scatter(cluster.values[static_cast<std::size_t>(o)], 0);
    const double difference = filling_difference(sums);
    if (difference < noted_share * largest_filling_difference(o) || sums.freedom_within < 1) return;
    const double of_steps = std::sqrt(sums.within / sums.freedom_within);
    if (difference < noted_ratio * of_steps) return;
    Remark note = remark_on(o, Remark::Kind::unlike_files);
    note.names = names_of(table, cluster.files);
    note.relative = std::numbers::sqrt2 * difference;
    note.relative_error = of_steps;
    result.remarks.push_back(std::move(note));
}

void set_files_apart(ReplicateTable& table, std::size_t place, Eigen::Index o,
                     const std::vector<Reading>& readings, FarReplicates& result) {
    ReplicateCluster& cluster = table.clusters[place];
    auto& values = cluster.values[static_cast<std::size_t>(o)];
    const double difference = filling_difference(analyse_scatter(values, 0));
    if (difference <= largest_filling_difference(o))
        return note_unlike_files(table, cluster, o, result);
    const std::vector<std::size_t> far = far_files(cluster, o);
    const double variance = 2 * difference * difference;  // of the distance between two files
    Remark doubt = remark_on(o, Remark::Kind::far_files);
    doubt.names = names_of(table, far);
    doubt.relative = std::expm1(std::sqrt(variance));
    for (std::size_t k = 0; k < readings.size(); ++k) {
        if (std::ranges::find(far, table.file_of[k]) == far.end()) continue;
        result.variance[k](o) += variance;
        doubt.add(readings[k].origin);
    }
    result.remarks.push_back(std::move(doubt));
    if (far.size() == 1) {
        values = without_file(values, far.front());
    } else {
        result.unlike.emplace(place, o);
    }
}

void set_condition_apart(const ReplicateTable& table, const Values& values, Eigen::Index o,
                         const FarCondition& far, const std::vector<Reading>& readings,
                         FarReplicates& result) {
    Remark doubt = remark_on(o, Remark::Kind::far_condition);
    for (const ReplicatedValue& value : values) {
        if (value.condition != far.condition) continue;
        result.variance[value.reading](o) += far.variance;
        const Reading& reading = readings[value.reading];
        doubt.add(reading.origin);
        doubt.names.push_back(
            reading.step > 0
                ? fmt::format("step {} of {}", reading.step, table.name_of(value.file))
                : fmt::format("{}:{}", table.name_of(value.file), reading.origin.line));
    }
    result.remarks.push_back(std::move(doubt));
}

/// Readings by file, to compare files that were measured alike but for the liquid.
struct FilesOfContents {
    const ReplicateTable& table;
    const std::vector<Reading>& readings;

    /// Liquid content of a file [1].
    double content(std::size_t file) const {
        const auto first = std::ranges::find(table.file_of, file) - table.file_of.begin();
        return readings[static_cast<std::size_t>(first)].condition.liquid_content;
    }
    /// Mean of ln(stress ratio of a file over that of others) at conditions that are equal but for
    /// the liquid content [1]; NaN without any. Others are all files of a content but `without`.
    double distance(std::size_t file, double to_content, std::size_t without) const {
        double sum = 0;
        std::size_t count = 0;
        for (std::size_t k = 0; k < readings.size(); ++k) {
            if (table.file_of[k] != file) continue;
            for (std::size_t j = 0; j < readings.size(); ++j) {
                const std::size_t other = table.file_of[j];
                if (other == file || other == without || !alike(readings[k], readings[j]) ||
                    readings[j].condition.liquid_content != to_content)
                    continue;
                sum += std::log(readings[k].stress_ratio() / readings[j].stress_ratio());
                ++count;
            }
        }
        return sum / static_cast<double>(count);
    }

    static bool alike(const Reading& a, const Reading& b) {
        // As replicates (`are_replicates`); the gap of wet grains, by which I is divided, differs.
        constexpr double same_stress = 0.02, same_speed = 0.1;
        const auto near = [](double x, double y, double tolerance) {
            return std::abs(x - y) <= tolerance * std::max(x, y);
        };
        return near(a.condition.normal_stress, b.condition.normal_stress, same_stress) &&
               near(a.condition.inertial_number, b.condition.inertial_number, same_speed) &&
               a.condition.at_failure == b.condition.at_failure;
    }
};

/// Whether a file of dry grains lies where those of wet grains do, and one of these where those of
/// dry grains do.
bool are_exchanged(const FilesOfContents& files, std::size_t dry, std::size_t wet) {
    constexpr double clearly = 3;  // chosen: nearer to the others by so much
    const double content = files.content(wet);
    const double dry_to_dry = files.distance(dry, 0, wet),
                 wet_to_wet = files.distance(wet, content, dry),
                 dry_to_wet = files.distance(dry, content, wet),
                 wet_to_dry = files.distance(wet, 0, dry);
    return dry_to_dry * wet_to_wet < 0 && std::abs(dry_to_dry) > clearly * std::abs(dry_to_wet) &&
           std::abs(wet_to_wet) > clearly * std::abs(wet_to_dry);
}

/// Adds to remarks on files that differ in shear stress the pair of files, a dry and a wet one,
/// whose liquid contents are probably exchanged.
void name_exchanged(const FilesOfContents& files, std::vector<Remark>& remarks) {
    const auto of_remark = [&](const Remark& remark, std::size_t file) {
        return std::ranges::find(remark.names, files.table.name_of(file)) != remark.names.end();
    };
    constexpr std::size_t most = 60;  // files: the time grows with the square of their number
    for (Remark& remark : remarks) {
        if (remark.kind != Remark::Kind::far_files || remark.quantity != "shear_stress" ||
            files.table.files.size() > most)
            continue;
        for (std::size_t dry = 0; dry < files.table.files.size(); ++dry)
            for (std::size_t wet = 0; files.content(dry) == 0 && wet < files.table.files.size();
                 ++wet) {
                if (files.content(wet) == 0 || !remark.because.empty() ||
                    !(of_remark(remark, dry) || of_remark(remark, wet)) ||
                    !are_exchanged(files, dry, wet))
                    continue;
                Remark& pair = remark.because.emplace_back();
                pair.kind = Remark::Kind::far_files;
                pair.names = {files.table.name_of(dry), files.table.name_of(wet)};
            }
    }
}

}  // namespace

FarReplicates set_far_replicates_apart(ReplicateTable& table,
                                       const std::vector<Reading>& readings) {
    FarReplicates result;
    result.variance.assign(readings.size(), Eigen::Vector2d::Zero());
    for (std::size_t place = 0; place < table.clusters.size(); ++place) {
        for (const Eigen::Index o : {0, 1})
            set_files_apart(table, place, o, readings, result);
    }
    name_exchanged({table, readings}, result.remarks);
    for (ReplicateCluster& cluster : table.clusters) {
        for (const Eigen::Index o : {0, 1}) {
            Values& values = cluster.values[static_cast<std::size_t>(o)];
            for (FarCondition far = farthest(values); far.variance > 0 && far.p < far_by_chance;
                 far = farthest(values)) {
                set_condition_apart(table, values, o, far, readings, result);
                values = without_condition(values, far.condition);
            }
        }
    }
    return result;
}

}  // namespace pendular
