#include "reports/figure_style.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace pendular {

bool spans_decade(const std::vector<double>& values) {
    const auto [least, greatest] = std::ranges::minmax(values);
    return least > 0 && greatest > 10 * least;
}

Shown shown(const Reading& r) {
    const double s = r.condition.normal_stress;
    return {{r.value(0) / s, r.value(1)},
            {std::sqrt(r.covariance(0, 0)) / s, std::sqrt(r.covariance(1, 1))}};
}

Shown shown(const Prediction& predicted, Eigen::Index place, double normal_stress) {
    const auto error = [&](Eigen::Index k) { return std::sqrt(predicted.covariance(k, k)); };
    return {{predicted.value(2 * place) / normal_stress, predicted.value(2 * place + 1)},
            {error(2 * place) / normal_stress, error(2 * place + 1)}};
}

namespace {

/// Weights 1/standard error^2 of the values of observable `o`, normalised to the sum 1.
Eigen::VectorXd weights_of(const std::vector<Shown>& all, std::size_t o) {
    Eigen::VectorXd weights(std::ssize(all));
    for (std::size_t k = 0; k < all.size(); ++k) {
        weights(static_cast<Eigen::Index>(k)) = std::pow(all[k].error[o], -2);
    }
    return weights / weights.sum();
}

}  // namespace

Shown mean_of(const std::vector<Shown>& all) {
    Shown mean{};
    for (std::size_t o = 0; o < 2; ++o) {
        const Eigen::VectorXd weights = weights_of(all, o);
        double variance = 0;
        for (std::size_t k = 0; k < all.size(); ++k) {
            const double weight = weights(static_cast<Eigen::Index>(k));
            mean.value[o] += weight * all[k].value[o];
            variance += std::pow(weight * all[k].error[o], 2);
        }
        mean.error[o] = std::sqrt(variance);
    }
    return mean;
}

MeasuredAndModel means_of(const std::vector<std::size_t>& places, const Calibration& c,
                          const Eigen::MatrixXd& covariance) {
    std::vector<Shown> measured;
    for (const std::size_t k : places) {
        measured.push_back(shown(c.readings[k]));
    }
    MeasuredAndModel means{mean_of(measured), {}};
    for (std::size_t o = 0; o < 2; ++o) {
        const Eigen::VectorXd weights = weights_of(measured, o);
        Eigen::VectorXd share = Eigen::VectorXd::Zero(c.prediction.value.size());
        for (std::size_t m = 0; m < places.size(); ++m) {
            const double unit = o == 0 ? c.readings[places[m]].condition.normal_stress : 1;
            share(static_cast<Eigen::Index>(2 * places[m] + o)) =
                weights(static_cast<Eigen::Index>(m)) / unit;
        }
        means.measured.error[o] = std::sqrt(share.dot(covariance * share));
        means.model.value[o] = share.dot(c.prediction.value);
        means.model.error[o] = std::sqrt(share.dot(c.prediction.covariance * share));
    }
    return means;
}

bool mean_suffices(const std::vector<std::size_t>& places, const Calibration& c) {
    const Shown mean = means_of(places, c, stack(c.readings).covariance).model;
    return std::ranges::all_of(places, [&](std::size_t k) {
        const Shown reading = shown(c.readings[k]),
                    model = shown(c.prediction, static_cast<Eigen::Index>(k),
                                  c.readings[k].condition.normal_stress);
        return std::abs(model.value[0] - mean.value[0]) <= same_point * reading.error[0] &&
               std::abs(model.value[1] - mean.value[1]) <= same_point * reading.error[1];
    });
}

void add_point(Curve& curve, double x, const Shown& shown, std::size_t o) {
    curve.x.push_back(x);
    curve.y.push_back(shown.value[o]);
    curve.y_error.push_back(shown.error[o]);
}

std::string names_of(const std::vector<const Effect*>& effects) {
    return effects.empty()       ? ""
           : effects.size() == 1 ? effects[0]->name
           : effects.size() == 2 ? effects[0]->name + " and " + effects[1]->name
                                 : fmt::format("{} effects", effects.size());
}

std::string inertial_text(double inertial_number) {
    // Rates of shear are held to 1 or 2 %: a third digit would only repeat their scatter.
    return inertial_number == 0 ? "I → 0" : fmt::format("I = {:.2g}", inertial_number);
}

namespace {

/// Dark enough on white paper, and told apart by colour-blind readers with the shapes and dashes.
const std::array<SeriesLook, most_named_series> named_looks = {
    {{"#0b62a4", Shape::circle, "solid"},
     {"#c0392b", Shape::square, "(8,3)"},
     {"#1e8449", Shape::triangle, "(8,3,2,3)"},
     {"#6c3483", Shape::downward_triangle, "(3,3)"}}};
/// Colours from dark to light, with evenly rising lightness. Source: viridis of matplotlib, without
/// its lightest fifth.
constexpr std::array<std::array<double, 3>, 5> scale_colours = {
    {{68, 1, 84}, {62, 74, 137}, {38, 130, 142}, {53, 183, 121}, {122, 209, 81}}};

std::string colour_on_scale(double share) {
    const double at = share * static_cast<double>(scale_colours.size() - 1);
    const auto below = std::min(static_cast<std::size_t>(at), scale_colours.size() - 2);
    const double part = at - static_cast<double>(below);
    std::array<int, 3> mixed{};
    for (std::size_t k = 0; k < mixed.size(); ++k) {
        mixed[k] = static_cast<int>(
            std::lround(scale_colours[below][k] +
                        part * (scale_colours[below + 1][k] - scale_colours[below][k])));
    }
    return fmt::format("#{:02x}{:02x}{:02x}", mixed[0], mixed[1], mixed[2]);
}

}  // namespace

SeriesLook look_of_series(std::size_t k, std::size_t count) {
    if (count <= most_named_series) return named_looks[k];
    return {colour_on_scale(static_cast<double>(k) / static_cast<double>(count - 1))};
}

Curve measured_points(const std::string& label, const SeriesLook& look) {
    return {.label = label, .colour = look.colour, .symbol = {look.shape, Filling::filled}};
}

Curve model_points(const std::string& label, const SeriesLook& look) {
    return {.label = label, .colour = look.colour, .symbol = {look.shape, Filling::hollow}};
}

Curve model_line(const std::string& label, const SeriesLook& look) {
    return {.label = label,
            .style = Curve::Style::line,
            .colour = look.colour,
            .symbol = {look.shape, Filling::filled},
            .dash = look.dash};
}

namespace {

/// Text of a range of series: "content 0.003 to 0.063", or both names where they differ before the
/// last blank.
std::string range_text(const std::string& first, const std::string& last) {
    const auto words = first.rfind(' ');
    const bool alike = words != std::string::npos && last.starts_with(first.substr(0, words + 1));
    return first + " to " + (alike ? last.substr(words + 1) : last);
}

}  // namespace

std::vector<Curve> series_entries(const std::vector<std::string>& names) {
    std::vector<Curve> entries;
    if (names.size() > most_named_series) {
        Curve all{.label = range_text(names.front(), names.back()), .style = Curve::Style::scale};
        for (std::size_t k = 0; k < names.size(); ++k) {
            all.colours.push_back(look_of_series(k, names.size()).colour);
        }
        return {all};
    }
    for (std::size_t k = 0; k < names.size(); ++k) {
        entries.push_back(model_line(names[k], look_of_series(k, names.size())));
        entries.back().marked = true;
    }
    return entries;
}

Curve kind_entry(const std::string& label, Curve::Style style, Filling filling) {
    return {.label = label,
            .style = style,
            .colour = explaining_colour,
            .symbol = {Shape::circle, filling},
            .banded = style == Curve::Style::line};
}

}  // namespace pendular
