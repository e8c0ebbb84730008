#include "data/recordings/replicate_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>
#include <numeric>

#include "data/recordings/reading_groups.h"

namespace pendular {
namespace {

double compared(const Reading& reading, Eigen::Index observable) {
    return observable == 0 ? reading.stress_ratio() : reading.value(1);
}

/// Number of the filling of a table's reading, if the table states errors of fillings; 0 otherwise.
std::size_t stated_filling(const Reading& reading) {
    const auto error = std::ranges::find(reading.shared, false, &SharedError::of_rounding);
    return error == reading.shared.end() || reading.within_run_only ? 0 : error->source / 2;
}

void number_files(const std::vector<Reading>& readings, ReplicateTable& table) {
    std::map<std::pair<std::string, std::size_t>, std::size_t> numbers;
    for (const Reading& reading : readings) {
        const auto [place, added] = numbers.emplace(
            std::pair(reading.origin.file, stated_filling(reading)), table.files.size());
        if (added) {
            table.files.push_back(reading.origin.file);
            table.fillings.push_back(stated_filling(reading));
        }
        table.file_of.push_back(place->second);
    }
}

/// For each file, the index of a file that represents its cluster: files with a common condition
/// are joined by union-find.
std::vector<std::size_t> connected_files(const ReplicateTable& table) {
    std::vector<std::size_t> root(table.files.size());
    std::iota(root.begin(), root.end(), std::size_t{0});
    const auto root_of = [&](std::size_t file) {
        while (root[file] != file)
            file = root[file];
        return file;
    };
    for (const auto& group : table.groups) {
        for (const std::size_t k : group)
            root[root_of(table.file_of[k])] = root_of(table.file_of[group.front()]);
    }
    for (std::size_t file = 0; file < root.size(); ++file)
        root[file] = root_of(file);
    return root;
}

void find_clusters(ReplicateTable& table) {
    const std::vector<std::size_t> root = connected_files(table);
    std::map<std::size_t, std::size_t> numbers;
    for (std::size_t file = 0; file < table.files.size(); ++file) {
        const auto [place, added] = numbers.emplace(root[file], table.clusters.size());
        if (added) table.clusters.emplace_back();
        table.clusters[place->second].files.push_back(file);
    }
    for (const std::size_t file : table.file_of)
        table.cluster_of.push_back(numbers.at(root[file]));
}

double geometric_mean_of_normal_stress(const std::vector<Reading>& readings) {
    if (readings.empty()) return 1;
    double sum = 0;
    for (const Reading& reading : readings)
        sum += std::log(reading.condition.normal_stress);
    return std::exp(sum / static_cast<double>(readings.size()));
}

/// Relative variance of an observable [1] without the error of a filling that a table states.
double unshared_variance(const Reading& reading, Eigen::Index observable) {
    if (reading.within_run_only) return relative_variance(reading, observable);
    const double left =
        reading.covariance(observable, observable) - reading.filling_variance()(observable);
    return std::max(0.0, left) / std::pow(reading.value(observable), 2);
}

void add_values(const std::vector<Reading>& readings, std::size_t condition,
                Eigen::Index observable, ReplicateTable& table) {
    std::vector<std::size_t> group = table.groups[condition];
    // The solid fraction of a bed that creeps is no measurement of the flow.
    if (observable == 1)
        std::erase_if(group, [&](std::size_t k) { return readings[k].condition.gap_creep != 0; });
    const auto usable = [&](std::size_t k) { return compared(readings[k], observable) > 0; };
    if (group.size() < 2 || !std::ranges::all_of(group, usable)) return;
    double mean = 0;
    for (const std::size_t k : group)
        mean += std::log(compared(readings[k], observable)) / static_cast<double>(group.size());
    for (const std::size_t k : group) {
        const double load = readings[k].condition.normal_stress / table.reference_stress;
        table.least_load = std::min(table.least_load, load);
        table.greatest_load = std::max(table.greatest_load, load);
        table.clusters[table.cluster_of[k]].values[static_cast<std::size_t>(observable)].push_back(
            {.reading = k,
             .condition = condition,
             .file = table.file_of[k],
             .deviation = std::log(compared(readings[k], observable)) - mean,
             .within = unshared_variance(readings[k], observable),
             .load = load});
    }
}

}  // namespace

std::string ReplicateTable::name_of(std::size_t file) const {
    const std::string name = std::filesystem::path(files[file]).filename().string();
    return fillings[file] == 0 ? name : fmt::format("{} (filling {})", name, fillings[file]);
}

ReplicateTable replicate_table(const std::vector<Reading>& readings) {
    ReplicateTable table;
    table.groups = replicate_groups(readings);
    table.reference_stress = geometric_mean_of_normal_stress(readings);
    number_files(readings, table);
    find_clusters(table);
    for (std::size_t condition = 0; condition < table.groups.size(); ++condition) {
        for (const Eigen::Index observable : {0, 1})
            add_values(readings, condition, observable, table);
    }
    return table;
}

double relative_variance(const Reading& reading, Eigen::Index i) {
    return reading.covariance(i, i) / (reading.value(i) * reading.value(i));
}

}  // namespace pendular
