#include "analysis/diagnosis/study_evidence.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <functional>
#include <map>
#include <numeric>
#include <set>
#include <tuple>

#include "analysis/misfit/compare.h"
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

/// CheckedQuantity along which residuals are checked. The checks use ranks. If the error of a
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

std::string condition_text(const Condition& condition) {
    std::string text = fmt::format("{} Pa, I = {:.2g}", short_text(condition.normal_stress),
                                   condition.inertial_number);
    return text + (condition.dry()
                       ? ", dry"
                       : fmt::format(", liquid content {:.3g}", condition.liquid_content));
}

namespace {

/// Adds direct measurements to the evidence, from index `entry` on, and one suspect measurement for
/// all direct measurements of a parameter.
void add_direct(Evidence& evidence, const std::vector<DirectMeasurement>& direct,
                Eigen::Index entry) {
    const std::size_t known = evidence.errors.freedom.size();
    if (!direct.empty()) evidence.errors.freedom.push_back(INFINITY);
    std::map<std::string, Eigen::MatrixXd> columns;
    for (const DirectMeasurement& each : direct) {
        evidence.errors.kind.push_back(known);
        evidence.conditions.push_back({entry});
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

Evidence evidence_of(const std::vector<Reading>& readings, const ReplicateScatter& scatter,
                     const std::vector<DirectMeasurement>& direct) {
    Evidence evidence;
    evidence.errors_assumed = std::ranges::any_of(readings, &Reading::error_assumed);
    evidence.measured = stack(readings, direct);
    evidence.errors = knowledge_of(readings, scatter, evidence.measured.value.size());
    evidence.conditions = entries_by_condition(readings);
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
