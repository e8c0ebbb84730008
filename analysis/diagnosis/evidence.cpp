#include "analysis/diagnosis/evidence.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>
#include <set>
#include <tuple>

#include "analysis/misfit/checks.h"
#include "data/quantities/number.h"
#include "data/recordings/reading_groups.h"

namespace pendular {
namespace {

/// Suspect measurement of some readings: one wrong factor on their shear stresses, another on their
/// solid fractions. `values`: measured values of all entries.
SuspectMeasurement suspect(std::string name, std::string group,
                           const std::vector<std::size_t>& readings,
                           const Eigen::VectorXd& values) {
    constexpr double one_percent = 0.01;
    SuspectMeasurement result{.name = std::move(name),
                              .columns = Eigen::MatrixXd::Zero(values.size(), 2),
                              .quantities = {"shear stress", "solid fraction"},
                              .smallest_of_interest = one_percent,
                              .group = std::move(group)};
    for (const std::size_t k : readings) {
        for (const Eigen::Index observable : {0, 1}) {
            const Eigen::Index entry = 2 * static_cast<Eigen::Index>(k) + observable;
            result.columns(entry, observable) = values(entry);
        }
    }
    return result;
}

/// Adds direct measurements to the evidence, from index `entry` on, and one suspect measurement for
/// all direct measurements of a parameter.
void add_direct(Evidence& evidence, const std::vector<DirectMeasurement>& direct,
                Eigen::Index entry) {
    const std::size_t known = evidence.errors.freedom.size();
    if (!direct.empty()) evidence.errors.freedom.push_back(INFINITY);
    std::map<std::string, Eigen::MatrixXd> columns;
    for (const DirectMeasurement& each : direct) {
        evidence.errors.kind.push_back(known);
        auto& column = columns[each.parameter];
        // An error common to all of them, of the size of one standard error.
        const double off = column.size() > 0 ? column.maxCoeff() : each.standard_error;
        if (column.size() == 0) column.setZero(evidence.measured.value.size(), 1);
        column(entry++, 0) = off;
    }
    for (const auto& [parameter, column] : columns) {
        evidence.suspects.push_back({.name = "the direct measurements of " + parameter,
                                     .columns = column,
                                     .group = "direct measurements"});
    }
}

/// Errors of one observable that all readings of a filling share, as sources of variance.
SharedErrors filling_errors(const std::vector<Reading>& readings,
                            const ReplicateScatter::Filling& filling, Eigen::Index observable,
                            Eigen::Index entries) {
    std::map<std::string, std::vector<std::size_t>> files;
    for (std::size_t k = 0; k < readings.size(); ++k) {
        if (readings[k].within_run_only) files[readings[k].origin.file].push_back(k);
    }
    SharedErrors shared{.loadings = Eigen::MatrixXd::Zero(entries, std::ssize(files)),
                        .variance = filling.variance,
                        .between = filling.between,
                        .within = filling.within,
                        .freedom_between = filling.freedom_between,
                        .freedom_within = filling.freedom_within,
                        .steps = filling.steps};
    Eigen::Index source = 0;
    for (const auto& [file, members] : files) {
        for (const std::size_t k : members) {
            shared.loadings(2 * static_cast<Eigen::Index>(k) + observable, source) =
                readings[k].value(observable);
        }
        ++source;
    }
    return shared;
}

/// Errors of known size that several readings share, such as rounding errors, as sources of
/// variance.
SharedErrors known_shared_errors(const std::vector<Reading>& readings, Eigen::Index entries) {
    std::map<std::size_t, Eigen::VectorXd> loadings;
    for (std::size_t k = 0; k < readings.size(); ++k) {
        for (const SharedError& error : readings[k].shared) {
            if (!error.known) continue;
            auto& column =
                loadings.emplace(error.source, Eigen::VectorXd::Zero(entries)).first->second;
            column.segment<2>(2 * static_cast<Eigen::Index>(k)) = error.size;
        }
    }
    SharedErrors shared{.loadings = Eigen::MatrixXd(entries, std::ssize(loadings)), .variance = 1};
    Eigen::Index source = 0;
    for (const auto& [number, column] : loadings) {
        shared.loadings.col(source++) = column;
    }
    return shared;
}

/// Natural logarithm of the factor by which an observable's error changes, at each entry, where the
/// exponent of its dependence on normal stress changes by one standard error; 0 at other entries.
Eigen::VectorXd load_errors(const std::vector<Reading>& readings, const ReplicateScatter& scatter,
                            Eigen::Index observable, Eigen::Index entries) {
    Eigen::VectorXd logs = Eigen::VectorXd::Zero(entries);
    for (std::size_t k = 0; k < readings.size(); ++k) {
        logs(2 * static_cast<Eigen::Index>(k) + observable) =
            -scatter.load_exponent_error(observable) *
            std::log(readings[k].condition.normal_stress / scatter.reference_stress);
    }
    return logs;
}

ErrorKnowledge knowledge_of(const std::vector<Reading>& readings, const ReplicateScatter& scatter,
                            Eigen::Index entries) {
    ErrorKnowledge knowledge;
    // Groups whose scatter was pooled share one estimate and therefore the error of this estimate.
    std::map<std::tuple<Eigen::Index, double, double>, std::size_t> kinds;
    for (const Reading& reading : readings) {
        for (const Eigen::Index o : {0, 1}) {
            double mean_square = 0, freedom = INFINITY;
            if (reading.scatter_group < scatter.groups.size()) {
                const auto& group = scatter.groups[reading.scatter_group];
                // Errors that the user states and that explain the scatter count as known.
                const bool not_stated =
                    reading.within_run_only || reading.unstated[static_cast<std::size_t>(o)];
                if (group.excess(o, o) > 0 || (not_stated && group.freedom(o) > 0)) {
                    mean_square = group.mean_square(o);
                    freedom = group.freedom(o);
                }
            }
            const auto [kind, added] =
                kinds.emplace(std::tuple(o, mean_square, freedom), knowledge.freedom.size());
            if (added) knowledge.freedom.push_back(freedom);
            knowledge.kind.push_back(kind->second);
        }
    }
    knowledge.readings = std::ssize(readings);
    knowledge.correlation_freedom = scatter.correlation_freedom;
    for (const Eigen::Index o : {0, 1}) {
        if (scatter.load_exponent_error(o) > 0) {
            knowledge.log_sizes.push_back(load_errors(readings, scatter, o, entries));
        }
    }
    if (auto known = known_shared_errors(readings, entries); known.loadings.cols() > 0) {
        knowledge.shared.push_back(std::move(known));
    }
    for (const Eigen::Index o : {0, 1}) {
        const auto& filling = scatter.filling[static_cast<std::size_t>(o)];
        if (filling.freedom_between > 0) {
            knowledge.shared.push_back(filling_errors(readings, filling, o, entries));
        }
    }
    return knowledge;
}

/// Indices of readings, by the file that contains the readings.
using ReadingsOfFiles = std::map<std::string, std::vector<std::size_t>>;

std::string file_name(const std::string& path) {
    return std::filesystem::path(path).filename().string();
}

/// Readings of a file and of all later files, in ascending order, with a name, for each file but
/// the first. An instrument that changes between two recordings, such as a torque transducer that
/// is knocked, shows wrong values in all later recordings. Left out are all wet readings, since
/// liquid was added before them. Empty if the files do not follow one another in time.
std::vector<std::pair<std::string, std::vector<std::size_t>>> parts_since(
    const ReadingsOfFiles& files, const std::vector<Reading>& readings) {
    struct Recording {
        double begin, end;
        ReadingsOfFiles::const_iterator file;
    };
    std::vector<Recording> recordings;
    for (auto file = files.begin(); file != files.end(); ++file) {
        Recording recording{INFINITY, -INFINITY, file};
        for (const std::size_t k : file->second) {
            recording.begin = std::min(recording.begin, readings[k].condition.time);
            recording.end = std::max(recording.end, readings[k].condition.time);
        }
        recordings.push_back(recording);
    }
    std::ranges::sort(recordings, {}, &Recording::begin);
    std::vector<std::size_t> wet;
    for (std::size_t k = 0; k < readings.size(); ++k) {
        if (!readings[k].condition.dry()) wet.push_back(k);
    }
    std::vector<std::pair<std::string, std::vector<std::size_t>>> parts;
    std::vector<std::size_t> later;
    for (std::size_t k = recordings.size(); k-- > 1;) {
        if (recordings[k].begin <= recordings[k - 1].end) return {};
        const auto& [file, members] = *recordings[k].file;
        later.insert(later.end(), members.begin(), members.end());
        std::ranges::sort(later);
        if (later == wet) continue;
        const std::string name = file_name(file);
        const std::size_t after = recordings.size() - 1 - k;
        parts.emplace_back(
            after == 1 ? fmt::format("the readings of {} and the later file {}", name,
                                     file_name(recordings[k + 1].file->first))
                       : fmt::format("the readings of {} and the {} later files", name, after),
            later);
    }
    return parts;
}

}  // namespace

std::string condition_text(const Condition& condition) {
    std::string text = fmt::format("{} Pa, I = {:.2g}", short_text(condition.normal_stress),
                                   condition.inertial_number);
    return text + (condition.dry()
                       ? ", dry"
                       : fmt::format(", liquid content {:.3g}", condition.liquid_content));
}

Evidence evidence_of(const std::vector<Reading>& readings, const ReplicateScatter& scatter,
                     const std::vector<DirectMeasurement>& direct) {
    Evidence evidence;
    evidence.errors_assumed = std::ranges::any_of(readings, &Reading::error_assumed);
    evidence.measured = stack(readings, direct);
    evidence.errors = knowledge_of(readings, scatter, evidence.measured.value.size());
    evidence.conditions = entries_of(readings, {}, direct.size()).conditions;
    const auto groups = replicate_groups(readings);
    ReadingsOfFiles files;
    for (std::size_t k = 0; k < readings.size(); ++k) {
        files[readings[k].origin.file].push_back(k);
    }
    std::set<std::vector<std::size_t>> suspected;
    for (const auto& group : groups) {
        if (groups.size() > 1 && suspected.insert(group).second) {
            evidence.suspects.push_back(
                suspect("the readings at " + condition_text(readings[group.front()].condition),
                        "conditions", group, evidence.measured.value));
        }
    }
    for (const auto& [file, members] : files) {
        if (files.size() > 1 && suspected.insert(members).second) {
            evidence.suspects.push_back(
                suspect("the readings of " + std::filesystem::path(file).filename().string(),
                        "files", members, evidence.measured.value));
        }
    }
    for (auto& [name, later] : parts_since(files, readings)) {
        if (suspected.insert(later).second) {
            evidence.suspects.push_back(
                suspect(std::move(name), "changes in time", later, evidence.measured.value));
        }
    }
    add_direct(evidence, direct, 2 * static_cast<Eigen::Index>(readings.size()));
    return evidence;
}

}  // namespace pendular
