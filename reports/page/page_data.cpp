#include "reports/page/page_data.h"

#include <fmt/format.h>

#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <boost/archive/iterators/base64_from_binary.hpp>
#include <boost/archive/iterators/transform_width.hpp>
#include <cctype>
#include <cmath>
#include <cstddef>
#include <cstring>
#include <filesystem>
#include <functional>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>

#include "reports/with_error.h"

namespace pendular {

void Bytes::add_floats(const Eigen::VectorXd& values) {
    for (const double value : values) {
        add(static_cast<float>(value));
    }
}

std::string Bytes::base64() const {
    using namespace boost::archive::iterators;
    using Encoder = base64_from_binary<transform_width<std::string::const_iterator, 6, 8>>;
    std::string text(Encoder(bytes_.begin()), Encoder(bytes_.end()));
    text.append((3 - bytes_.size() % 3) % 3, '=');
    return text;
}

void Bytes::append(const void* value, std::size_t size) {
    const std::size_t at = bytes_.size();
    bytes_.resize(at + size);
    std::memcpy(bytes_.data() + at, value, size);
}

namespace {

bool is_digit(char c) {
    return c >= '0' && c <= '9';
}

/// Replaces `before` by `after` wherever `there` holds for the position.
void replace_where(std::string& text, std::string_view before, std::string_view after,
                   const std::function<bool(std::size_t)>& there) {
    for (std::size_t at = 0; (at = text.find(before, at)) != std::string::npos; ++at) {
        if (there(at)) text.replace(at, before.size(), after);
    }
}

}  // namespace

std::string page_text(std::string text) {
    const auto at = [&](std::size_t k) { return k < text.size() ? text[k] : '\0'; };
    replace_where(text, "+-", "±", [](std::size_t) { return true; });
    // A sign stands before a digit, at the beginning or after a blank or a bracket; any other
    // hyphen belongs to a word, a date or an exponent.
    replace_where(text, "-", "−", [&](std::size_t k) {
        return is_digit(at(k + 1)) && (k == 0 || at(k - 1) == ' ' || at(k - 1) == '(');
    });
    // The prefix micro of a unit after a number: "61 um".
    replace_where(text, " u", " µ", [&](std::size_t k) {
        const bool letter = std::isalpha(static_cast<unsigned char>(at(k + 3))) != 0;
        const bool unit = at(k + 2) == 'P' ? at(k + 3) == 'a'
                                           : std::string_view("mNs").find(at(k + 2)) < 3 && !letter;
        return k > 0 && is_digit(at(k - 1)) && unit;
    });
    return text;
}

namespace {

using Json = nlohmann::ordered_json;

/// Number of a page, with six significant digits; null where it is not finite.
Json shortened(double value) {
    if (!std::isfinite(value)) return nullptr;
    return std::stod(fmt::format("{:.6g}", value));
}

Json all_shortened(const auto& values) {
    Json array = Json::array();
    for (const double value : values) {
        array.push_back(shortened(value));
    }
    return array;
}

/// Entries of one observable (0: shear stress, 1: solid fraction) at n points; stresses over the
/// normal stress of the point.
Eigen::VectorXd observable(const Eigen::VectorXd& entries, Eigen::Index from, std::size_t which,
                           const std::vector<Condition>& conditions) {
    Eigen::VectorXd result(static_cast<Eigen::Index>(conditions.size()));
    for (Eigen::Index k = 0; k < result.size(); ++k) {
        const double entry = entries(from + 2 * k + static_cast<Eigen::Index>(which));
        result(k) =
            which == 0 ? entry / conditions[static_cast<std::size_t>(k)].normal_stress : entry;
    }
    return result;
}

/// Entries of one observable at all readings, then at all points of curves.
Eigen::VectorXd at_all_points(const Eigen::VectorXd& at_readings, const Eigen::VectorXd& along,
                              std::size_t which, const std::vector<Condition>& readings,
                              const std::vector<Condition>& points) {
    Eigen::VectorXd both(static_cast<Eigen::Index>(readings.size() + points.size()));
    both << observable(at_readings, 0, which, readings), observable(along, 0, which, points);
    return both;
}

std::string response_of(const SwitchedModel& model, const std::vector<Condition>& points) {
    const std::vector<Condition> readings = conditions_of(model.calibration.readings);
    const Fit& fit = model.calibration.fit;
    const Eigen::Index p = fit.parameters.size();
    const Eigen::VectorXd errors = fit.standard_errors();
    const Eigen::VectorXd squares = products(errors);
    const auto part = [&](const Eigen::VectorXd& a, const Eigen::VectorXd& b, std::size_t which) {
        return at_all_points(a, b, which, readings, points);
    };
    Bytes bytes;
    for (const std::size_t which : {0u, 1u}) {
        bytes.add_floats(part(model.response.value, model.along.value, which));
    }
    for (Eigen::Index k = 0; k < p + squares.size(); ++k) {
        for (const std::size_t which : {0u, 1u}) {
            const bool first = k < p;
            const Eigen::VectorXd coefficients =
                first
                    ? part(model.response.first.col(k), model.along.first.col(k), which)
                    : part(model.response.second.col(k - p), model.along.second.col(k - p), which);
            if (first) {
                bytes.add_scaled<std::int16_t>(coefficients * errors(k));
            } else {
                bytes.add_scaled<std::int8_t>(coefficients * squares(k - p));
            }
        }
    }
    return bytes.base64();
}

/// Standard errors of the differences of measured and predicted (stress ratio, solid fraction).
std::string errors_of(const SwitchedModel& model) {
    Bytes bytes;
    for (const std::size_t which : {0u, 1u}) {
        for (const ReadingMisfit& misfit : model.comparison.readings) {
            const auto o = static_cast<Eigen::Index>(which);
            const double variance =
                misfit.reading.estimated_covariance()(o, o) + misfit.predicted_covariance(o, o);
            const double scale = which == 0 ? misfit.reading.condition.normal_stress : 1;
            bytes.add(static_cast<float>(std::sqrt(variance) / scale));
        }
    }
    return bytes.base64();
}

/// Upper triangle of chi2 as a form of the parameters in units of their standard errors.
std::string form_of(const SwitchedModel& model) {
    const Eigen::VectorXd errors = model.calibration.fit.standard_errors();
    Eigen::VectorXd scale(model.chi2_form.rows());
    scale << 1, errors, products(errors);
    Bytes bytes;
    for (Eigen::Index i = 0; i < scale.size(); ++i) {
        for (Eigen::Index j = i; j < scale.size(); ++j) {
            bytes.add(static_cast<float>(model.chi2_form(i, j) * scale(i) * scale(j)));
        }
    }
    return bytes.base64();
}

Json parameters_of(const SwitchedModel& model) {
    const Calibration& c = model.calibration;
    Json array = Json::array();
    for (std::size_t k = 0; k < c.parameters.size(); ++k) {
        const auto i = static_cast<Eigen::Index>(k);
        const Parameter& p = c.parameters[k];
        const double value = c.fit.parameters(i), error = c.fit.standard_error(i);
        array.push_back(
            {{"name", p.name},
             {"unit", p.unit},
             {"value", shortened(value)},
             {"error", shortened(error)},
             {"determined", c.fit.determines(i)},
             {"text", page_text(estimate_text(c.fit, i, p.unit))},
             {"lower", shortened(p.lower)},
             {"upper", shortened(p.upper)},
             {"at_bound", static_cast<bool>(c.fit.at_bound[k])},
             {"trusted", {shortened(model.trusted.lower(i)), shortened(model.trusted.upper(i))}}});
    }
    return array;
}

/// Correlations of the fitted parameters, row by row.
Json correlations_of(const Fit& fit) {
    const Eigen::MatrixXd covariance = fit.total_covariance();
    const Eigen::VectorXd errors = covariance.diagonal().cwiseSqrt();
    Json rows = Json::array();
    for (Eigen::Index i = 0; i < errors.size(); ++i) {
        Json row = Json::array();
        for (Eigen::Index j = 0; j < errors.size(); ++j) {
            row.push_back(shortened(covariance(i, j) / (errors(i) * errors(j))));
        }
        rows.push_back(row);
    }
    return rows;
}

/// Fall of chi2 and shifts of the parameters without each fitted reading: one column after the
/// other.
std::string without_of(const SwitchedModel& model) {
    Bytes bytes;
    for (Eigen::Index k = 0; k < model.without_each.cols(); ++k) {
        bytes.add_scaled<std::int16_t>(model.without_each.col(k));
    }
    return bytes.base64();
}

Json model_json(const SwitchedModel& model, const std::vector<Condition>& points) {
    const Comparison& comparison = model.comparison;
    Json effects = Json::array();
    for (const ListedEffect& effect : model.calibration.model.effects) {
        effects.push_back(effect.name);
    }
    return {{"effects", effects},
            {"parameters", parameters_of(model)},
            {"correlations", correlations_of(model.calibration.fit)},
            {"chi2", shortened(comparison.total.chi2)},
            {"dof", comparison.total.dof},
            {"p", shortened(comparison.total.p())},
            {"rms", all_shortened(comparison.rms_percent)},
            {"fitted", model.calibration.fitted},
            {"converged", model.calibration.fit.converged},
            {"form", form_of(model)},
            {"without", without_of(model)},
            {"errors", errors_of(model)},
            {"response", response_of(model, points)}};
}

Json reading_json(const Reading& reading) {
    const Condition& c = reading.condition;
    const Eigen::Vector2d errors = reading.covariance.diagonal().cwiseSqrt();
    return {{"file", std::filesystem::path(reading.origin.file).filename().string()},
            {"line", reading.origin.line},
            {"step", reading.step},
            {"normal_stress", shortened(c.normal_stress)},
            {"inertial_number", shortened(c.inertial_number)},
            {"liquid_content", shortened(c.liquid_content)},
            {"height", c.height ? shortened(*c.height) : Json(nullptr)},
            {"time", shortened(c.time)},
            {"values", {shortened(reading.stress_ratio()), shortened(reading.value(1))}},
            {"errors", {shortened(errors(0) / c.normal_stress), shortened(errors(1))}}};
}

Json panels_json(const std::vector<PagePanel>& panels) {
    Json result = Json::array();
    std::size_t first = 0;
    for (const PagePanel& panel : panels) {
        Json series = Json::array();
        for (const PageSeries& each : panel.series) {
            series.push_back({{"label", each.label},
                              {"group", each.group},
                              {"value", shortened(each.value)},
                              {"members", each.members},
                              {"x", all_shortened(each.x)},
                              {"first", first}});
            first += each.along.size();
        }
        result.push_back({{"title", panel.title},
                          {"x_label", panel.x_label},
                          {"log_x", panel.log_x},
                          {"quantity", panel.quantity},
                          {"x", all_shortened(panel.x)},
                          {"series", series}});
    }
    return result;
}

/// Steps of the ladder for the first picture, each with its name on the axis.
Json ladder_json(const Ladder& ladder) {
    Json steps = Json::array();
    for (const LadderStep& step : ladder) {
        steps.push_back({{"name", step_name(step)},
                         {"effects", step.effects},
                         {"when", step.when},
                         {"rms", all_shortened(step.rms_percent)}});
    }
    return steps;
}

Json corrected_json(const std::optional<CorrectedModel>& corrected) {
    if (!corrected) return nullptr;
    Json deviations = Json::array();
    for (const std::vector<double>& each : corrected->deviations)
        deviations.push_back(all_shortened(each));
    return {
        {"of", corrected->of}, {"deviations", deviations}, {"rms", all_shortened(corrected->rms)}};
}

}  // namespace

nlohmann::ordered_json page_data(const SwitchedModels& all, const std::vector<PagePanel>& panels,
                                 const std::vector<PageRecording>& recordings,
                                 const PageStory& story) {
    const std::vector<Condition> points = points_of_curves(panels);
    Json switches = Json::array(), models = Json::array(), readings = Json::array();
    for (const std::string& name : all.switches) {
        switches.push_back({{"name", name}, {"summary", all.study.catalogue().find(name).summary}});
    }
    for (std::size_t index = 0; index < all.models.size(); ++index) {
        models.push_back(all.models[index] ? model_json(*all.models[index], points)
                                           : Json{{"why_not", all.why_not[index]}});
    }
    const auto fitted =
        std::ranges::find_if(all.models, [](const auto& m) { return m.has_value(); });
    const std::vector<Reading> none;
    const auto& shown = fitted != all.models.end() ? (*fitted)->calibration.readings : none;
    for (const Reading& reading : shown) {
        readings.push_back(reading_json(reading));
    }
    return {{"switches", switches},
            {"always", all.always},
            {"current", all.current},
            {"ladder", ladder_json(story.ladder)},
            {"proposed", story.proposed ? Json(*story.proposed) : Json(nullptr)},
            {"proposed_name", story.proposed_name},
            {"proposed_as", story.proposed_as},
            {"corrected", corrected_json(story.corrected)},
            {"readings", readings},
            {"points", points.size()},
            {"panels", panels_json(panels)},
            {"recordings", recordings_json(recordings, shown)},
            {"models", models}};
}

}  // namespace pendular
