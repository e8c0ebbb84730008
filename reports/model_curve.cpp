#include "reports/model_curve.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <iterator>
#include <utility>

#include "calib/fit/cohesion_lines.h"
#include "data/quantities/number.h"
#include "reports/figure.h"

namespace pendular {

const Coordinate along_inertial_number = {
    [](const Condition& c) { return c.inertial_number; },
    [](Condition& c, double value) { c.inertial_number = value; }};
const Coordinate along_inverse_normal_stress = {
    [](const Condition& c) { return 1 / c.normal_stress; },
    [](Condition& c, double value) { c.normal_stress = 1 / value; }};

namespace {

/// Largest number of groups of either state: more colours of one scale are not told apart.
constexpr std::size_t most_series = 8;
/// Relative difference up to which coordinates belong to one set point [1].
constexpr double same_place = 0.05;

double mixed(double a, double b, double share) {
    return a + share * (b - a);
}

std::optional<double> mixed(const std::optional<double>& a, const std::optional<double>& b,
                            double share) {
    return a && b ? std::optional(mixed(*a, *b, share)) : std::nullopt;
}

/// Condition between `a` and `b`, interpolated linearly with the share of `b` [1].
Condition mixed(const Condition& a, const Condition& b, double share) {
    Condition result = a;
    result.normal_stress = mixed(a.normal_stress, b.normal_stress, share);
    result.inertial_number = mixed(a.inertial_number, b.inertial_number, share);
    result.liquid_content = mixed(a.liquid_content, b.liquid_content, share);
    result.height = mixed(a.height, b.height, share);
    result.bead_volume = mixed(a.bead_volume, b.bead_volume, share);
    result.time = mixed(a.time, b.time, share);
    return result;
}

}  // namespace

ConditionPath::ConditionPath(std::vector<Condition> conditions, const Coordinate& along)
    : along_(along) {
    std::ranges::sort(conditions, {}, along.of);
    double first = 0;  // coordinate of the first condition of the last node
    int count = 0;     // number of conditions in the last node
    for (const Condition& condition : conditions) {
        if (count == 0 || !agree(first, along.of(condition), same_place)) {
            nodes_.push_back(condition);
            first = along.of(condition);
            count = 1;
        } else {
            nodes_.back() = mixed(nodes_.back(), condition, 1.0 / ++count);
        }
    }
}

Condition ConditionPath::at(double coordinate) const {
    const auto above = std::ranges::lower_bound(nodes_, coordinate, {}, along_.of);
    Condition result = above == nodes_.end() ? nodes_.back() : *above;
    if (above != nodes_.begin() && above != nodes_.end()) {
        const Condition& below = *std::prev(above);
        const double from = along_.of(below);
        result = mixed(below, *above, (coordinate - from) / (along_.of(*above) - from));
    }
    along_.set(result, coordinate);
    return result;
}

bool ConditionPath::turns(double (*quantity)(const Condition&)) const {
    bool rises = false, falls = false;
    double before = quantity(nodes_.front());  // the last value that differs
    for (const Condition& node : nodes_) {
        const double here = quantity(node);
        if (agree(before, here, same_place)) continue;
        (here > before ? rises : falls) = true;
        before = here;
    }
    return rises && falls;
}

namespace {

double stress_of(const Condition& c) {
    return c.normal_stress;
}

/// Number by which readings are divided: normal stress [Pa], bead volume [m^3], or index of the
/// file from 1.
double number_of(const Reading& reading, Apart apart, const std::vector<std::string>& files) {
    switch (apart) {
        case Apart::normal_stress:
            return reading.condition.normal_stress;
        case Apart::bead_volume:
            return reading.condition.bead_volume.value_or(0);
        case Apart::file:
            break;
    }
    return static_cast<double>(std::ranges::find(files, reading.origin.file) - files.begin()) + 1;
}

std::string text_of(double number, Apart apart, const std::vector<std::string>& files,
                    const Calibration& c) {
    switch (apart) {
        case Apart::normal_stress:
            return fmt::format("σ_{{22}} = {} Pa", nominal_text(number));
        case Apart::bead_volume:
            return fmt::format("{:.3g} g of beads", 1e3 * c.grains.density * number);
        case Apart::file:
            break;
    }
    const std::filesystem::path file = files[static_cast<std::size_t>(std::lround(number)) - 1];
    return plain_text(file.filename().string());
}

std::vector<std::string> files_of(const std::vector<Reading>& readings) {
    std::vector<std::string> files;
    for (const Reading& reading : readings) {
        if (std::ranges::find(files, reading.origin.file) == files.end()) {
            files.push_back(reading.origin.file);
        }
    }
    return files;
}

/// Divides a series by a quantity into parts, sorted by the rising quantity.
std::vector<CurveGroup> divided(const CurveGroup& series, Apart apart, const Calibration& c) {
    const std::vector<std::string> files = files_of(c.readings);
    const auto number = [&](std::size_t k) { return number_of(c.readings[k], apart, files); };
    std::vector<std::size_t> order = series.members;
    std::ranges::stable_sort(order, {}, number);
    std::vector<CurveGroup> parts;
    for (const std::size_t k : order) {
        const bool next = parts.empty() || !agree(number(parts.back().members.front()), number(k),
                                                  apart == Apart::file ? 0 : same_place);
        if (next) parts.emplace_back();
        parts.back().members.push_back(k);
    }
    for (CurveGroup& part : parts) {
        part.name = series.name;
        if (parts.size() > 1) {
            double sum = 0;
            for (const std::size_t k : part.members)
                sum += number(k);
            part.name += (part.name.empty() ? "" : ", ") +
                         text_of(sum / static_cast<double>(part.members.size()), apart, files, c);
        }
        std::ranges::sort(part.members);
    }
    return parts;
}

/// Largest difference between the predictions of the members and the curve `drawn` at `conditions`,
/// in standard errors of the readings.
double largest_difference(const CurveGroup& series, const Eigen::VectorXd& drawn,
                          const std::vector<Condition>& conditions, const Calibration& c) {
    double largest = 0;
    for (std::size_t m = 0; m < series.members.size(); ++m) {
        const std::size_t k = series.members[m];
        const Reading& reading = c.readings[k];
        // Compared as stress ratios, since the normal stresses of replicates differ a little.
        const Eigen::Vector2d unit(reading.condition.normal_stress, 1);
        Eigen::Vector2d off = drawn.segment<2>(2 * static_cast<Eigen::Index>(m));
        off(0) *= unit(0) / conditions[m].normal_stress;
        off -= c.prediction.value.segment<2>(2 * static_cast<Eigen::Index>(k));
        const Eigen::Array2d error = reading.covariance.diagonal().array().sqrt();
        largest = std::max(largest, (off.array().abs() / error).maxCoeff());
    }
    return largest;
}

/// Whether a curve along the path of the readings would show bends that only come from the order of
/// the readings: the normal stress goes up and down along it, as where readings at two speeds are
/// mixed, and the model depends on it.
bool bends(const CurveGroup& series, const Predictor& model, const Calibration& c,
           const Coordinate& along) {
    if (!series.path(c.readings, along).turns(stress_of)) return false;
    std::vector<Condition> at_mean;
    double mean = 0;
    for (const std::size_t k : series.members) {
        at_mean.push_back(c.readings[k].condition);
        mean += at_mean.back().normal_stress / static_cast<double>(series.members.size());
    }
    for (Condition& each : at_mean) {
        each.normal_stress = mean;
    }
    const Eigen::VectorXd predicted =
        model.predict(c.fit.parameters, at_mean, PredictionPart::values).value;
    return largest_difference(series, predicted, at_mean, c) > same_point;
}

bool passes(const CurveGroup& series, const Predictor& model, const Calibration& c,
            const Coordinate& along) {
    const ConditionPath path = series.path(c.readings, along);
    std::vector<Condition> conditions;
    for (const std::size_t k : series.members) {
        conditions.push_back(path.at(along.of(c.readings[k].condition)));
    }
    const Eigen::VectorXd drawn =
        model.predict(c.fit.parameters, conditions, PredictionPart::values).value;
    return largest_difference(series, drawn, conditions, c) <= same_point;
}

}  // namespace

ConditionPath CurveGroup::path(const std::vector<Reading>& readings,
                               const Coordinate& along) const {
    std::vector<Condition> conditions;
    for (const std::size_t k : members) {
        conditions.push_back(readings[k].condition);
    }
    return {std::move(conditions), along};
}

namespace {

/// Groups of readings that are all in steady shear, or all points of failure (`curve_groups`).
std::vector<CurveGroup> groups_of_state(const std::vector<std::size_t>& members,
                                        const Predictor& model, const Calibration& c,
                                        const Coordinate& along, const std::vector<Apart>& apart) {
    const auto judge = [&](std::vector<CurveGroup>& all) {
        bool straight = true;
        for (CurveGroup& series : all) {
            series.curve = passes(series, model, c, along);
            straight = straight && series.curve && !bends(series, model, c, along);
        }
        return straight;
    };
    std::vector<CurveGroup> best = {{.members = members}};
    bool told = judge(best);
    // First each quantity alone, then several quantities one after the other.
    for (auto by = apart.begin(); by != apart.end() && !told; ++by) {
        std::vector<CurveGroup> finer = divided(best.front(), *by, c);
        if (finer.size() > most_series || !judge(finer)) continue;
        return finer;
    }
    for (auto by = apart.begin(); by != apart.end() && !told; ++by) {
        std::vector<CurveGroup> finer;
        for (const CurveGroup& series : best) {
            std::ranges::move(divided(series, *by, c), std::back_inserter(finer));
        }
        if (finer.size() > most_series) break;
        told = judge(finer);
        best = std::move(finer);
    }
    return best;
}

}  // namespace

std::vector<CurveGroup> curve_groups(const std::vector<std::size_t>& members,
                                     const Predictor& model, const Calibration& c,
                                     const Coordinate& along, const std::vector<Apart>& apart) {
    std::vector<std::size_t> steady, failures;
    for (const std::size_t k : members) {
        (c.readings[k].condition.at_failure ? failures : steady).push_back(k);
    }
    if (steady.empty() || failures.empty()) {
        return groups_of_state(members, model, c, along, apart);
    }
    std::vector<CurveGroup> groups = groups_of_state(steady, model, c, along, apart);
    for (CurveGroup& group : groups_of_state(failures, model, c, along, apart)) {
        group.name = "points of failure" + (group.name.empty() ? "" : ", " + group.name);
        groups.push_back(std::move(group));
    }
    return groups;
}

ModelCurve::ModelCurve(std::vector<double> at, const Prediction& predicted,
                       const std::vector<Condition>& conditions)
    : x(std::move(at)) {
    for (std::size_t k = 0; k < conditions.size(); ++k) {
        y.push_back(shown(predicted, static_cast<Eigen::Index>(k), conditions[k].normal_stress));
    }
}

void ModelCurve::draw_in(Panel& panel, std::size_t o, const Curve& look,
                         const std::string& band_label) const {
    Curve line = look;
    line.style = Curve::Style::line;
    line.banded = true;
    line.in_table = look.label != band_label;  // the rows of the band say all
    line.x = x;
    Curve band = line;
    band.style = Curve::Style::band;
    band.label = band_label;
    band.in_key = false;
    band.in_table = true;
    for (const Shown& one : y) {
        line.y.push_back(one.value[o]);
        band.y.push_back(one.value[o]);
        band.y_error.push_back(one.error[o]);
    }
    panel.curves.push_back(band);
    panel.curves.push_back(line);
}

}  // namespace pendular
