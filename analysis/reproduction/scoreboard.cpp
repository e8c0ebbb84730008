#include "analysis/reproduction/scoreboard.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "sim/closures/strength.h"

namespace pendular {
namespace {

using dem::Observable;

/// A value of ours with the state that it belongs to, as text.
struct Value {
    Mean mean;
    std::string where;
};

std::string name_of(const PaperState& s) {
    return fmt::format("friction {:g}, V0/a^3 {:g}, P* {:g}", s.friction(), s.bridge_volume(),
                       s.reduced_pressure());
}

std::string text_of(double value) {
    return fmt::format("{:.4g}", value);
}

std::string text_of(const Mean& mean) {
    return mean.standard_error > 0
               ? fmt::format("{:.4g} +- {:.2g}", mean.value, mean.standard_error)
               : text_of(mean.value);
}

Mean ratio_of(const Mean& a, const Mean& b) {
    const double ratio = a.value / b.value;
    return {ratio,
            std::abs(ratio) * std::hypot(a.standard_error / a.value, b.standard_error / b.value)};
}

Mean scaled(const Mean& mean, double factor) {
    return {mean.value * factor, mean.standard_error * std::abs(factor)};
}

bool same(double a, double b) {
    return std::abs(a - b) <= 1e-6 * std::abs(b);
}

/// Quantity of a state.
using Of = std::function<Mean(const PaperState&)>;
using Which = std::function<bool(const PaperState&)>;

class Scoreboard {
  public:
    explicit Scoreboard(const PaperStudy& study) : study_(study) {}

    std::vector<ScoreboardRow> rows() {
        dry_grains();
        liquid_contents();
        cohesion();
        solid_fraction();
        effective_stress();
        predicted_strength();
        predicted_cohesion();
        capillary_stresses();
        structure();
        return std::move(rows_);
    }

  private:
    void section(std::string name) { section_ = std::move(name); }
    /// Adds a row of a published value with its standard error or rounding.
    void value(const std::string& what, const std::string& published, double expected, double error,
               const Mean& ours);
    /// Adds a row of values of ours that a published range should contain.
    void range(const std::string& what, const std::string& published, double lower, double upper,
               const std::vector<Value>& ours);
    /// Adds such a row for the states of each friction.
    void each_friction(const std::string& what, const std::string& published, double lower,
                       double upper, const Of& quantity, const Which& which);
    std::vector<Value> values(const Of& quantity, const Which& which) const;

    void dry_grains();
    void liquid_contents();
    void cohesion();
    void solid_fraction();
    void effective_stress();
    void predicted_strength();
    void predicted_cohesion();
    void capillary_stresses();
    void structure();
    /// Condition that a state fulfils another one and was simulated at half the paper's stiffness
    /// number or more, on which structure depends; where no state was, only the other one.
    Which as_stiff(const Which& which) const;
    /// Growth of the reduced cohesion between two lines [%].
    void growth(const std::string& what, double friction_from, double volume_from,
                double friction_to, double volume_to);

    const PaperStudy& study_;
    std::string section_;
    std::vector<ScoreboardRow> rows_;
};

const Which all_states = [](const PaperState&) { return true; };

Which Scoreboard::as_stiff(const Which& which) const {
    const Which stiff = [](const PaperState& s) {
        return s.run().parameters.stiffness_number >= paper_stiffness / 2;
    };
    if (study_.where(stiff).empty()) return which;
    return [=](const PaperState& s) { return stiff(s) && which(s); };
}

Which above(double pressure) {
    return [pressure](const PaperState& s) { return s.reduced_pressure() >= pressure; };
}

void Scoreboard::value(const std::string& what, const std::string& published, double expected,
                       double error, const Mean& ours) {
    const double distance =
        std::abs(ours.value - expected) / std::hypot(error, ours.standard_error);
    rows_.push_back({.section = section_,
                     .what = what,
                     .published = published,
                     .ours = text_of(ours),
                     .lower = expected - error,
                     .upper = expected + error,
                     .least = ours.value,
                     .greatest = ours.value,
                     .distance = distance,
                     .values = 1,
                     .outside = distance > allowed_distance,
                     .where = {},
                     .agrees = distance <= allowed_distance});
}

void Scoreboard::range(const std::string& what, const std::string& published, double lower,
                       double upper, const std::vector<Value>& ours) {
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
    for (const Value& one : ours) {
        row.least = std::min(row.least, one.mean.value);
        row.greatest = std::max(row.greatest, one.mean.value);
        const double beyond = std::max({0.0, lower - one.mean.value, one.mean.value - upper});
        const double distance = beyond > 0 ? beyond / std::max(1e-12, one.mean.standard_error) : 0;
        if (distance > allowed_distance) {
            ++row.outside;
            if (distance > worst) {
                worst = distance;
                row.where = fmt::format("furthest: {} at {}", text_of(one.mean.value), one.where);
            }
        }
        row.distance = std::max(row.distance, distance);
    }
    row.agrees = row.outside == 0;
    row.ours = ours.size() == 1
                   ? fmt::format("{:.4g} +- {:.2g}", ours.front().mean.value,
                                 ours.front().mean.standard_error)
                   : fmt::format("{} to {}", text_of(row.least), text_of(row.greatest));
    rows_.push_back(std::move(row));
}

std::vector<Value> Scoreboard::values(const Of& quantity, const Which& which) const {
    std::vector<Value> result;
    for (const PaperState* state : study_.where(which)) {
        result.push_back({quantity(*state), name_of(*state)});
    }
    return result;
}

void Scoreboard::each_friction(const std::string& what, const std::string& published, double lower,
                               double upper, const Of& quantity, const Which& which) {
    for (const double friction : paper_frictions) {
        range(fmt::format("{}, friction {:g}", what, friction), published, lower, upper,
              values(quantity, [&](const PaperState& s) {
                  return same(s.friction(), friction) && which(s);
              }));
    }
}

void Scoreboard::dry_grains() {
    section("Dry grains");
    value("stress ratio, friction 0.09, I -> 0 [1]", "0.257 +- 0.002", 0.257, 0.002,
          study_.dry_stress_ratio(0.09));
    value("solid fraction, friction 0.09, I -> 0 [1]", "0.6150 +- 0.0003", 0.6150, 0.0003,
          study_.dry_solid_fraction(0.09));
    value("stress ratio, friction 0, I -> 0 [1]", "about 0.1", 0.1, 0.01,
          study_.dry_stress_ratio(0));
    value("solid fraction, friction 0, I -> 0 [1]", "near 0.64", 0.64, 0.005,
          study_.dry_solid_fraction(0));
    value("stress ratio, friction 0.05, I -> 0 [1]", "about 0.2", 0.2, 0.02,
          study_.dry_stress_ratio(0.05));
    value("stress ratio at the fitted friction 0.09 against the measured one [1]",
          "0.25 +- 0.02, measured", 0.25, 0.02, study_.dry_stress_ratio(0.09));
    value("solid fraction at the fitted friction 0.09 against the measured one [1]",
          "0.615 +- 0.002, measured", 0.615, 0.002, study_.dry_solid_fraction(0.09));
    std::vector<Value> growth, fall;
    const double frictions[] = {0, 0.05, 0.09, 0.15, 0.20, 0.25};
    for (std::size_t k = 1; k < std::size(frictions); ++k) {
        const auto step = [&](const Mean& from, const Mean& to) {
            return Value{
                {to.value - from.value, std::hypot(from.standard_error, to.standard_error)},
                fmt::format("friction {:g} to {:g}", frictions[k - 1], frictions[k])};
        };
        growth.push_back(
            step(study_.dry_stress_ratio(frictions[k - 1]), study_.dry_stress_ratio(frictions[k])));
        fall.push_back(step(study_.dry_solid_fraction(frictions[k - 1]),
                            study_.dry_solid_fraction(frictions[k])));
    }
    range("change of the stress ratio from one friction to the next [1]", "grows with friction", 0,
          INFINITY, growth);
    range("change of the solid fraction from one friction to the next [1]", "falls with friction",
          -INFINITY, 0, fall);
    constexpr double tension = 20.6e-3, diameter = 500e-6;
    value("normal stress at P* = 1 [Pa]", "129", 129, 0.5,
          {std::numbers::pi * tension / diameter, 0});
    value("P* at a normal stress of 0.3 kPa [1]", "2.3", 2.3, 0.05,
          {300 / (std::numbers::pi * tension / diameter), 0});
}

void Scoreboard::liquid_contents() {
    section("Liquid content");
    for (const PaperContent& content : paper_contents) {
        const PaperState* state = study_.at(0.09, content.bridge_volume, 3);
        if (state == nullptr) continue;
        value(fmt::format("liquid content, V0/a^3 {:g}, P* = 3, friction 0.09 [1]",
                          content.bridge_volume),
              fmt::format("{:.3f}", content.liquid_content), content.liquid_content, 0.0005,
              (*state)[Observable::liquid_content]);
    }
    std::vector<Value> changes;
    for (const PaperState& state : study_.states()) {
        const PaperState* middle = study_.at(state.friction(), state.bridge_volume(), 3);
        if (middle != nullptr) {
            Mean ratio =
                ratio_of(state[Observable::liquid_content], (*middle)[Observable::liquid_content]);
            changes.push_back({ratio, name_of(state)});
        }
    }
    range("liquid content over that at P* = 3, P* 0.5 to 10 [1]", "little change (within 15 %)",
          0.85, 1.15, changes);
}

void Scoreboard::growth(const std::string& what, double friction_from, double volume_from,
                        double friction_to, double volume_to) {
    const StrengthLine *from = study_.line(friction_from, volume_from),
                       *to = study_.line(friction_to, volume_to);
    if (from == nullptr || to == nullptr) return;
    Mean ratio = ratio_of(to->cohesion, from->cohesion);
    range(what, "30 to 50 %", 30, 50,
          {{{100 * (ratio.value - 1), 100 * ratio.standard_error}, "both ends"}});
}

void Scoreboard::cohesion() {
    section("Cohesion");
    for (const double friction : paper_frictions) {
        std::vector<Value> cohesions, intercepts;
        for (const StrengthLine& line : study_.lines()) {
            if (!same(line.friction, friction)) continue;
            const std::string where = fmt::format("V0/a^3 {:g}", line.bridge_volume);
            cohesions.push_back({line.cohesion, where});
            const Mean dry = study_.dry(Observable::stress_ratio, friction, 0.003);
            intercepts.push_back(
                {{line.intercept.value / dry.value, ratio_of(line.intercept, dry).standard_error},
                 where});
        }
        range(fmt::format("reduced cohesion c*, friction {:g} [1]", friction), "0.2 to 0.4", 0.2,
              0.4, cohesions);
        range(fmt::format("intercept of the line over the dry stress ratio, friction {:g} [1]",
                          friction),
              "equal", 0.99, 1.01, intercepts);
    }
    for (const PaperContent& content : paper_contents) {
        growth(fmt::format("growth of c* from friction 0.05 to 0.25, V0/a^3 {:g} [%]",
                           content.bridge_volume),
               paper_frictions.front(), content.bridge_volume, paper_frictions.back(),
               content.bridge_volume);
    }
    for (const double friction : paper_frictions) {
        growth(fmt::format("growth of c* from V0/a^3 5e-4 to 8e-3, friction {:g} [%]", friction),
               friction, paper_contents.front().bridge_volume, friction,
               paper_contents.back().bridge_volume);
    }
    for (const double pressure : {1.0, 0.5}) {
        std::vector<Value> over;
        for (const StrengthLine& line : study_.lines()) {
            const PaperState* state = study_.at(line.friction, line.bridge_volume, pressure);
            if (state == nullptr || !same(line.friction, 0.09)) continue;
            over.push_back(
                {ratio_of(line.at(pressure), (*state)[Observable::stress_ratio]), name_of(*state)});
        }
        range(fmt::format("line fitted above P* = 2.3 over the stress ratio at P* = {:g}, friction "
                          "0.09 [1]",
                          pressure),
              "overestimates", 1, INFINITY, over);
    }
}

void Scoreboard::solid_fraction() {
    section("Solid fraction of wet grains");
    const std::vector<Value> fractions =
        values([](const PaperState& s) { return s.rigid_solid_fraction(); },
               [](const PaperState& s) {
                   return same(s.friction(), 0.09) && same(s.reduced_pressure(), 1);
               });
    range("solid fraction, P* = 1, friction 0.09, all liquid contents [1]", "about 0.594", 0.5935,
          0.5945, fractions);
    std::vector<Value> changes;
    for (const Value& one : fractions) {
        const Mean &a = one.mean, &b = fractions.front().mean;
        changes.push_back(
            {{a.value - b.value, std::hypot(a.standard_error, b.standard_error)}, one.where});
    }
    range("solid fraction less that of the smallest liquid content, P* = 1, friction 0.09 [1]",
          "not influenced", -0.001, 0.001, changes);
    for (const double friction : paper_frictions) {
        std::vector<Value> falls;
        for (const PaperContent& content : paper_contents) {
            if (const PaperState* state = study_.at(friction, content.bridge_volume, 0.5)) {
                const Mean dry = study_.dry(Observable::solid_fraction, friction, 0.003),
                           wet = state->rigid_solid_fraction();
                falls.push_back(
                    {{dry.value - wet.value, std::hypot(dry.standard_error, wet.standard_error)},
                     fmt::format("V0/a^3 {:g}", content.bridge_volume)});
            }
        }
        range(fmt::format("fall of the solid fraction from dry to P* = 0.5, friction {:g} [1]",
                          friction),
              "0.03 to 0.04", 0.025, 0.045, falls);
    }
}

void Scoreboard::effective_stress() {
    section("Effective stress");
    const Of deviation = [](const PaperState& s) {
        const Mean ratio = ratio_of(s.contact_stress_ratio(), s.dry_stress_ratio());
        return Mean{100 * std::abs(ratio.value - 1), 100 * ratio.standard_error};
    };
    each_friction("contact stress ratio off the dry stress ratio, P* 0.5 to 1 [%]",
                  "up to 5 to 10 %", 0, 10, deviation,
                  [](const PaperState& s) { return s.reduced_pressure() < 2; });
    each_friction("contact stress ratio off the dry stress ratio, P* >= 2 [%]", "less than 5 %", 0,
                  5, deviation, above(2));
    range("localization, time average, P* >= 0.5 [1]", "at most 0.05", 0, 0.05,
          values([](const PaperState& s) { return s[Observable::localization]; }, all_states));
}

void Scoreboard::predicted_strength() {
    section("Predicted strength");
    const auto excess = [](Mean (PaperState::*prediction)() const) -> Of {
        return [prediction](const PaperState& s) {
            const Mean ratio = ratio_of((s.*prediction)(), s[Observable::stress_ratio]);
            return Mean{100 * (ratio.value - 1), 100 * ratio.standard_error};
        };
    };
    each_friction("stress ratio from Z* and s12cap over the simulated one, less 1 [%]",
                  "very good (within 10 %)", -10, 10, excess(&PaperState::strength2), all_states);
    each_friction("stress ratio from s22cap and s12cap over the simulated one, less 1 [%]",
                  "very good (within 10 %)", -10, 10, excess(&PaperState::strength1), all_states);
    each_friction("stress ratio from Z* alone over the simulated one, less 1 [%]",
                  "too high by up to 20 to 30 %", -5, 30, excess(&PaperState::strength3),
                  all_states);
    if (const PaperState* state = study_.at(0.25, 8e-3, 0.5)) {
        value("stress ratio, friction 0.25, V0/a^3 0.008, P* = 0.5 [1]", "approaching one", 1, 0.05,
              (*state)[Observable::stress_ratio]);
    }
}

void Scoreboard::predicted_cohesion() {
    section("Predicted cohesion");
    for (const PaperContent& content : paper_contents) {
        const StrengthLine* line = study_.line(0.09, content.bridge_volume);
        if (line == nullptr) continue;
        // Mean over the states of the line, as in the figure of cohesion against liquid content.
        const auto ratio = [&](Mean (PaperState::*prediction)() const) {
            double sum = 0, count = 0;
            for (const PaperState* state : study_.where([&](const PaperState& s) {
                     return same(s.friction(), 0.09) &&
                            same(s.bridge_volume(), content.bridge_volume) &&
                            s.reduced_pressure() >= lowest_line_pressure;
                 })) {
                sum += (state->*prediction)().value, ++count;
            }
            return ratio_of({sum / count, 0.01 * sum / count}, line->cohesion);
        };
        const bool large = content.liquid_content >= 0.03;
        range(fmt::format("Rumpf's cohesion over c*, friction 0.09, V0/a^3 {:g} [1]",
                          content.bridge_volume),
              large ? "correct" : "too high", large ? 0.9 : 1, large ? 1.1 : INFINITY,
              {{ratio(&PaperState::rumpf_cohesion), "P* >= 2.3"}});
        if (content.liquid_content < 0.03) {
            range(fmt::format("generalised cohesion over c*, friction 0.09, V0/a^3 {:g} [1]",
                              content.bridge_volume),
                  "satisfactory (10 %)", 0.9, 1.1,
                  {{ratio(&PaperState::generalised_cohesion), "P* >= 2.3"}});
        }
    }
}

void Scoreboard::capillary_stresses() {
    section("Capillary stresses");
    each_friction(
        "a^2 s12cap/F0 [1]", "0 to 0.1", 0, 0.105,
        [](const PaperState& s) {
            return scaled(s[Observable::capillary_shear_stress], s.reduced_pressure());
        },
        all_states);
    each_friction(
        "s12cap of distant bridges over that of contacts [1]", "-1 to 0", -1, 0,
        [](const PaperState& s) {
            return ratio_of(s[Observable::capillary_shear_stress_distant],
                            s[Observable::capillary_shear_stress_contact]);
        },
        all_states);
    each_friction(
        "s22cap over the mean capillary stress, less 1 [%]", "within 3 %", -3, 3,
        [](const PaperState& s) {
            const Mean ratio =
                ratio_of(s[Observable::capillary_stress_22], s[Observable::capillary_pressure]);
            return Mean{100 * (ratio.value - 1), 100 * ratio.standard_error};
        },
        all_states);
    range("a^2 s12cap/F0 from coordination and anisotropies less the simulated one [1]",
          "very good (within 0.01)", -0.01, 0.01,
          values(
              [](const PaperState& s) {
                  return Mean{
                      closures::capillary_shear_stress(s.network()) - s.capillary().shear,
                      s.reduced_pressure() * s[Observable::capillary_shear_stress].standard_error};
              },
              all_states));
    range("s12cap of distant bridges from their anisotropies over the simulated one [1]",
          "quite accurate (10 %)", 0.9, 1.1,
          values(
              [](const PaperState& s) {
                  const Mean simulated =
                      scaled(s[Observable::capillary_shear_stress_distant], s.reduced_pressure());
                  return Mean{
                      closures::distant_capillary_shear_stress(s.network()) / simulated.value,
                      simulated.standard_error / std::abs(simulated.value)};
              },
              all_states));
    range("length anisotropy over the sum of the anisotropies [1]", "of order 0.01", 0, 0.03,
          values(
              [](const PaperState& s) {
                  const closures::State& n = s.network();
                  return Mean{n.length_anisotropy_12_distant /
                                  (n.fabric_12_distant + n.force_anisotropy_12_distant +
                                   n.length_anisotropy_12_distant),
                              0.001};
              },
              all_states));
}

void Scoreboard::structure() {
    section("Structure");
    const auto of = [](Observable which) -> Of {
        return [which](const PaperState& s) { return s[which]; };
    };
    const Which dense = as_stiff([](const PaperState&s) { return s.reduced_pressure() >= 2; }),
                loose = as_stiff([](const PaperState&s) { return s.reduced_pressure() < 2; }),
                any = as_stiff(all_states);
    each_friction("Z_d [1]", "1 to 3.2", 0.95, 3.25, of(Observable::distant_coordination), any);
    each_friction("F_d/F0, P* >= 2 [1]", "0.48 to 0.60", 0.475, 0.605,
                  of(Observable::distant_force), dense);
    std::vector<Value> low =
        values(of(Observable::distant_force),
               as_stiff([](const auto& s) { return same(s.reduced_pressure(), 0.5); }));
    std::ranges::sort(low, std::greater<>(), [](const Value& v) { return v.mean.value; });
    low.resize(std::min<std::size_t>(1, low.size()));
    range("F_d/F0, lowest P*, largest value [1]", "near 0.7", 0.65, 0.75, low);
    each_friction("F12c, P* >= 2 [1]", "-0.047 to -0.036", -0.0475, -0.0355,
                  of(Observable::fabric_12_contact), dense);
    each_friction("F12c, P* 0.5 to 1 [1]", "-0.047 to -0.036", -0.0475, -0.0355,
                  of(Observable::fabric_12_contact), loose);
    each_friction("F12d, P* >= 2 [1]", "0.07 to 0.14", 0.065, 0.145,
                  of(Observable::fabric_12_distant), dense);
    each_friction("F12d, P* 0.5 to 1 [1]", "0.07 to 0.14", 0.065, 0.145,
                  of(Observable::fabric_12_distant), loose);
    each_friction("force anisotropy of distant bridges [1]", "-0.04 to -0.02 (typical)", -0.045,
                  -0.015, of(Observable::force_anisotropy_12_distant), any);
    each_friction("l0/a, V0/a^3 5e-4 [1]", "1.025", 1.0235, 1.0265, of(Observable::distant_length),
                  as_stiff([](const PaperState& s) { return same(s.bridge_volume(), 5e-4); }));
    each_friction("l0/a, V0/a^3 8e-3 [1]", "nearly 1.06", 1.055, 1.0605,
                  of(Observable::distant_length),
                  as_stiff([](const PaperState& s) { return same(s.bridge_volume(), 8e-3); }));
}

}  // namespace

std::vector<ScoreboardRow> scoreboard(const PaperStudy& study) {
    return Scoreboard(study).rows();
}

}  // namespace pendular
