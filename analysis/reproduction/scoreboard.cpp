#include "analysis/reproduction/scoreboard.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace pendular {
namespace {

std::string text_of(double value) {
    return fmt::format("{:.4g}", value);
}

std::string text_of(const Mean& mean) {
    return mean.standard_error > 0
               ? fmt::format("{:.4g} +- {:.2g}", mean.value, mean.standard_error)
               : text_of(mean.value);
}

}  // namespace

void Scoreboard::value(const std::string& what, const std::string& published, const Mean& expected,
                       const Mean& ours) {
    const double apart = std::abs(ours.value - expected.value),
                 error = std::hypot(expected.standard_error, ours.standard_error);
    const double distance = error > 0 ? apart / error : apart == 0 ? 0.0 : INFINITY;
    rows_.push_back({.section = section_,
                     .what = what,
                     .published = published,
                     .ours = text_of(ours),
                     .lower = expected.value - expected.standard_error,
                     .upper = expected.value + expected.standard_error,
                     .least = ours.value,
                     .greatest = ours.value,
                     .distance = distance,
                     .values = 1,
                     .outside = distance > allowed_distance,
                     .where = {},
                     .agrees = distance <= allowed_distance});
}

void Scoreboard::range(const std::string& what, const std::string& published, double lower,
                       double upper, const std::vector<StateValue>& ours) {
    if (ours.empty()) return;
    ScoreboardRow row{.section = section_,
                      .what = what,
                      .published = published,
                      .ours = {},
                      .lower = lower,
                      .upper = upper,
                      .least = ours.front().mean.value,
                      .greatest = ours.front().mean.value,
                      .values = static_cast<int>(ours.size()),
                      .where = {}};
    double worst = -1;
    for (const StateValue& one : ours) {
        row.least = std::min(row.least, one.mean.value);
        row.greatest = std::max(row.greatest, one.mean.value);
        const double beyond = std::max({0.0, lower - one.mean.value, one.mean.value - upper});
        const double distance = beyond > 0 ? beyond / std::max(1e-12, one.mean.standard_error) : 0;
        if (distance > allowed_distance) {
            ++row.outside;
            if (distance > worst) {
                worst = distance;
                row.where = one.where.empty() ? ""
                                              : fmt::format("furthest: {} at {}",
                                                            text_of(one.mean.value), one.where);
            }
        }
        row.distance = std::max(row.distance, distance);
    }
    row.agrees = row.outside == 0;
    row.ours = ours.size() == 1
                   ? text_of(ours.front().mean)
                   : fmt::format("{} to {}", text_of(row.least), text_of(row.greatest));
    rows_.push_back(std::move(row));
}

std::vector<StateValue> Scoreboard::values(const Quantity& quantity, const Condition& which) const {
    std::vector<StateValue> result;
    for (const PaperState& state : *states_) {
        if (which(state)) result.push_back({quantity(state), state.name()});
    }
    return result;
}

void Scoreboard::each_friction(const std::string& what, const std::string& published, double lower,
                               double upper, const Quantity& quantity, const Condition& which) {
    for (const double friction : paper_frictions) {
        range(fmt::format("{}, friction {:g}", what, friction), published, lower, upper,
              values(quantity, [&](const PaperState& s) {
                  return same_setting(s.friction(), friction) && which(s);
              }));
    }
}

}  // namespace pendular
