#include "reports/proposal_report.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <map>
#include <numeric>

#include "data/annular_cell.h"
#include "reports/figure_style.h"
#include "reports/with_error.h"

namespace pendular {
namespace {

/// Name of a quantity that changes, for a sentence.
const char* subject_for(const std::string& target) {
    static const std::map<std::string, const char*, std::less<>> subjects = {
        {"torque", "the shown torque"},
        {"normal_force", "the shown normal force"},
        {"height", "the shown height"},
        {"stress_ratio", "the stress ratio of the beads"},
        {"solid_fraction", "the solid fraction of the beads"},
        {"friction_difference", "the friction of the beads"},
        {"surface_tension", "the pull of the liquid bridges"}};
    return subjects.at(target);
}

const char* words_for(const std::string& variable) {
    static const std::map<std::string, const char*, std::less<>> words = {
        {"normal_stress", "the normal stress"},
        {"inertial_number", "the inertial number"},
        {"angular_velocity", "the angular velocity"},
        {"liquid_content", "the liquid content"},
        {"time", "the time since the first recording began"}};
    return words.at(variable);
}

/// How a change follows a power of a coordinate: "in proportion to the square of the time".
std::string proportion(double power, const std::string& coordinate) {
    const std::string inverse = power < 0 ? "in inverse proportion to " : "in proportion to ";
    const double size = std::abs(power);
    return inverse +
           (size == 1   ? ""
            : size == 2 ? "the square of "
                        : "the square root of ") +
           coordinate;
}

/// Where a change acts and how it varies, as an end of a sentence.
std::string course_of(const Profile& p) {
    if (p.dependence == Dependence::none) return "at all readings";
    const std::string x = words_for(p.variable);
    const auto at = [&](double value) { return with_unit(value, p.unit); };
    const std::string where_full = fmt::format("where {} is {}", x, at(p.full_at));
    switch (p.dependence) {
        case Dependence::power:
            return fmt::format("{}; the difference is {}", where_full, proportion(p.constant, x));
        case Dependence::logarithm:
            return fmt::format("{}; the difference falls with the logarithm to 0 at {}", where_full,
                               at(p.constant));
        case Dependence::above:
            return fmt::format("where {} is above {}, and agrees elsewhere", x, at(p.constant));
        case Dependence::below:
            return fmt::format("where {} is below {}, and agrees elsewhere", x, at(p.constant));
        case Dependence::beyond:
            return fmt::format("{}; the difference falls linearly to 0 at {} and below", where_full,
                               at(p.constant));
        case Dependence::short_of:
            return fmt::format("{}; the difference falls linearly to 0 at {} and above", where_full,
                               at(p.constant));
        case Dependence::decay:
            return fmt::format(
                "when the first recording begins, decaying with the time constant {}",
                at(p.constant));
        default:
            return fmt::format("at most, oscillating in time with the period {}", at(p.constant));
    }
}

std::string capitalised(std::string text) {
    text.front() = static_cast<char>(std::toupper(static_cast<unsigned char>(text.front())));
    return text;
}

}  // namespace

std::string phrase_on(const FittedShape& fitted, const std::string& reference) {
    const ChangedQuantity& quantity = fitted.shape.quantity;
    const double size = std::abs(fitted.change);
    const std::string amount = quantity.relative
                                   ? with_error(100 * size, 100 * fitted.standard_error) + " %"
                                   : with_error(size, fitted.standard_error, quantity.unit);
    return fmt::format("{} is {} {} than {} {}", subject_for(quantity.target), amount,
                       fitted.change < 0 ? "smaller" : "larger", reference,
                       course_of(fitted.shape.profile));
}

std::string sentence_on(const FittedShape& shape) {
    return capitalised(phrase_on(shape));
}

std::vector<std::string> sentences_on(const std::vector<Proposal>& proposals) {
    std::vector<std::string> sentences;
    for (const Proposal& proposal : proposals) {
        sentences.push_back(sentence_on(proposal));
    }
    return sentences;
}

std::string sentence_on(const Proposal& proposal) {
    std::string text;
    for (const FittedShape& shape : proposal.shapes) {
        text += (text.empty() ? "" : ". Besides, ") + phrase_on(shape);
    }
    return capitalised(text);
}

namespace {

/// Names of the effects of a proposal in proposed.toml.
std::string name_of(const Proposal& proposal) {
    std::string names;
    for (const FittedShape& each : proposal.shapes) {
        names += (names.empty() ? "" : " + ") + each.effect.name;
    }
    return names;
}

}  // namespace

std::vector<std::string> proposal_lines(const std::vector<Proposal>& proposals, double chi2,
                                        int dof) {
    std::vector<std::string> lines;
    if (proposals.empty()) return lines;
    const Proposal& best = proposals.front();
    const Fit& fit = best.model.fit;
    lines.push_back(fmt::format(
        "{} {}. This brings chi2/dof from {:.3g} to {:.3g}.",
        fmt::format("Proposal 1 ({}), a change of unknown cause, would explain {}:", name_of(best),
                    best.fits() ? "the readings" : "most of the misfit, not all"),
        sentence_on(best), chi2 / dof, best.model.fit.chi2 / fit.dof));
    if (!best.alike.empty()) {
        std::vector<std::string> phrases;
        for (const FittedShape& each : best.alike) {
            phrases.push_back(fmt::format("{} ({})", phrase_on(each), each.shape.name()));
        }
        lines.push_back(fmt::format("These readings can hardly tell this cause from another: {}.",
                                    fmt::join(phrases, "; or ")));
    }
    for (std::size_t k = 1; k < proposals.size(); ++k) {
        lines.push_back(fmt::format("Proposal {} ({}) would explain the readings as well: {}.",
                                    k + 1, name_of(proposals[k]), sentence_on(proposals[k])));
    }
    return lines;
}

namespace {

struct ShapeAxis {
    std::string label;
    std::vector<double> at;  ///< value of each reading
};

/// Horizontal axis: the quantity with which the first varying change of the proposal varies.
ShapeAxis axis_of(const Proposal& proposal, const std::vector<Reading>& readings) {
    static const std::map<std::string, const char*, std::less<>> labels = {
        {"normal_stress", "normal stress σ_{22} [Pa]"},
        {"inertial_number", "inertial number I"},
        {"angular_velocity", "angular velocity [rad/s]"},
        {"liquid_content", "liquid content Φ_L/Φ_S"},
        {"time", "time since the first recording began [s]"}};
    for (const FittedShape& fitted : proposal.shapes) {
        const Profile& profile = fitted.shape.profile;
        if (!profile.variable.empty()) {
            return {labels.at(profile.variable), {profile.along.begin(), profile.along.end()}};
        }
    }
    ShapeAxis axis{labels.at("normal_stress"), {}};
    for (const Reading& reading : readings) {
        axis.at.push_back(reading.condition.normal_stress);
    }
    return axis;
}

}  // namespace

Figure proposal_figure(const Proposal& proposal, const std::vector<Reading>& readings,
                       const Prediction& model) {
    const ShapeAxis axis = axis_of(proposal, readings);
    std::vector<double> contents;
    for (const Reading& reading : readings)
        contents.push_back(reading.condition.liquid_content);
    std::ranges::sort(contents);
    const auto repeated = std::ranges::unique(contents);
    contents.erase(repeated.begin(), repeated.end());
    Figure figure{.name = "proposal",
                  .title = "A change of unknown cause that would explain the readings",
                  .panels = {},
                  .stacked = true};
    for (const Eigen::Index observable : {0, 1}) {
        Panel panel{.x_label = axis.label,
                    .y_label = observable == 0 ? "shear stress, off the model [%]"
                                               : "solid fraction, off the model [%]",
                    .log_x = spans_decade(axis.at),
                    .zero_line = true,
                    .key = observable == 0};
        std::vector<std::string> names;
        for (std::size_t n = 0; n < contents.size(); ++n) {
            names.push_back(contents[n] == 0 ? "dry"
                                             : fmt::format("Φ_L/Φ_S = {:.3g}", contents[n]));
            const SeriesLook look = look_of_series(n, contents.size());
            Curve measured = measured_points("measured, " + names.back(), look),
                  changed = model_points("model with the change, " + names.back(), look);
            measured.in_key = changed.in_key = false;
            for (std::size_t k = 0; k < readings.size(); ++k) {
                if (readings[k].condition.liquid_content != contents[n]) continue;
                const Eigen::Index at = 2 * static_cast<Eigen::Index>(k) + observable;
                const double whole = model.value(at) / 100;
                measured.x.push_back(axis.at[k]);
                measured.y.push_back(readings[k].value(observable) / whole - 100);
                measured.y_error.push_back(
                    std::sqrt(readings[k].covariance(observable, observable)) / whole);
                changed.x.push_back(axis.at[k]);
                changed.y.push_back(proposal.model.fit.prediction.value(at) / whole - 100);
            }
            panel.curves.push_back(measured);
            panel.curves.push_back(changed);
        }
        for (Curve entry : series_entries(names)) {
            if (entry.style == Curve::Style::line) entry.style = Curve::Style::points;
            panel.curves.push_back(std::move(entry));
        }
        panel.curves.push_back(kind_entry(measured_text, Curve::Style::points));
        panel.curves.push_back(
            kind_entry("model with the change", Curve::Style::points, Filling::hollow));
        figure.panels.push_back(std::move(panel));
    }
    return figure;
}

namespace {

/// Smallest and largest of the values that an instrument shows at the readings.
struct Range {
    double least = INFINITY, most = -INFINITY;

    void add(double value) {
        least = std::min(least, value);
        most = std::max(most, value);
    }
    bool known() const { return least <= most; }
    /// Text of the range: ", between 2.1 mN m and 80 mN m", or " of about 12 mm".
    std::string after_noun(const std::string& unit) const {
        constexpr double narrow = 1.1;  // one check weight serves the whole range: chosen
        return most < narrow * least ? " of about " + with_unit(std::midpoint(least, most), unit)
                                     : ", " + text(unit);
    }
    std::string text(const std::string& unit) const {
        return fmt::format("between {} and {}", with_unit(least, unit), with_unit(most, unit));
    }
};

Range range_of(const std::string& target, const std::vector<Reading>& readings,
               const Study& study) {
    Range range;
    for (const Reading& each : readings) {
        if (target == "height") {
            if (each.condition.height) range.add(*each.condition.height);
        } else if (study.cell) {
            range.add(target == "torque" ? torque(each.value(0), *study.cell)
                                         : normal_force(each.condition.normal_stress, *study.cell));
        }
    }
    return range;
}

/// Sensor with what is known to check it.
struct SensorCheck {
    const char *sensor, *standard, *unit;
};

SensorCheck check_for(const std::string& target) {
    if (target == "torque") {
        return {"torque transducer", "known torques, such as weights on a lever", "N m"};
    }
    if (target == "normal_force") return {"load cell", "known weights", "N"};
    return {"gap sensor", "gauge blocks", "m"};
}

/// Circumstance of the readings with which a change varies and that a check has to repeat; empty
/// for none.
std::string circumstance(const FittedShape* change, const std::string& target,
                         const std::vector<Reading>& readings, const Study& study) {
    const std::string variable = change ? change->shape.profile.variable : "";
    if (variable == "normal_stress" && target == "torque") {
        const Range range = range_of("normal_force", readings, study);
        return range.known() ? ", at normal forces " + range.text("N") : "";
    }
    if (variable == "angular_velocity") return ", at rest and at the speeds of the readings";
    if (variable == "time") return ", at the beginning and at the end of a day";
    return "";
}

/// Sentence on the error to expect of the sensor; empty where nothing is known of it.
std::string expected(const SensorCheck& check, const FittedShape* change, double too_large) {
    if (change) {
        return fmt::format(" If the {} is the cause, {}.", check.sensor,
                           phrase_on(*change, "the true value"));
    }
    if (too_large == 0) return "";
    return fmt::format(" If the {} is the cause, it shows {:.2g} % too {}.", check.sensor,
                       100 * std::abs(too_large), too_large < 0 ? "little" : "much");
}

}  // namespace

std::string sensor_check(const std::string& target, const std::vector<Reading>& readings,
                         const Study& study, const FittedShape* change, double too_large) {
    const SensorCheck check = check_for(target);
    const Range range = range_of(target, readings, study);
    return fmt::format(
        "Check the {} with {}{}{}.{} If it shows wrong values, correct {}.", check.sensor,
        check.standard, range.known() ? range.after_noun(check.unit) + " (as in the readings)" : "",
        circumstance(change, target, readings, study), expected(check, change, too_large),
        too_large == 0 ? "the recordings that were taken with it"
                       : "the suspect recordings, and others only if it was wrong then already");
}

}  // namespace pendular
