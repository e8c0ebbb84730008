#include "reports/effect_pages.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>

#include "calib/model/study_model_space.h"
#include "calib/model/study_state.h"
#include "data/effect_parameter.h"
#include "reports/figure.h"
#include "reports/figure_style.h"
#include "reports/layout.h"
#include "sim/lab/lab_plan.h"

namespace pendular {
namespace {

/// State about which effects are drawn [SI units]: chosen, within the ranges of `drawn_columns`.
constexpr double usual_friction = 0.1, usual_stress = 1000, usual_inertial_number = 3e-3,
                 usual_content = 0.03, time_of_readings = 600;
constexpr int points_of_curve = 41;  ///< of a curve: straight pieces too short to be seen

Condition usual(bool dry, const Study& study) {
    return {.normal_stress = usual_stress,
            .inertial_number = usual_inertial_number,
            .liquid_content = dry ? 0 : usual_content,
            .bead_volume = study.cell.value().bead_volume,
            .time = time_of_readings};
}

/// Reduced pressure P* of the study's wet beads at a normal stress of 1 Pa [1/Pa].
double reduced_pressure_per_pascal(const Study& study) {
    const Condition wet{.normal_stress = 1, .liquid_content = usual_content};
    return 1 / inverse_pressure_of(wet, study);
}

/// Quantity that varies along the x axis of a column of panels.
struct Column {
    const char* label;
    double from, to;
    bool log, dry;  ///< logarithmic axis; whether dry readings have the quantity too
    void (*set)(Condition&, double, const Study&);
    bool shows_height = false;  ///< the x axis shows the height [mm] instead of the quantity
};

// Dry readings have no P*. They are drawn at the P* of wet readings with the same normal stress.
constexpr std::array<Column, 4> drawn_columns = {
    {{"reduced pressure P*", 0.5, 20, true, true,
      [](Condition& c, double value, const Study& study) {
          c.normal_stress = value / reduced_pressure_per_pascal(study);
      }},
     {"liquid content Φ_L/Φ_S", 0.004, 0.06, true, false,
      [](Condition& c, double value, const Study&) { c.liquid_content = value; }},
     {"inertial number I", 0.001, 0.03, true, true,
      [](Condition& c, double value, const Study&) { c.inertial_number = value; }},
     {"height of the sample [mm]", 20e-3, 100e-3, false, true,
      [](Condition& c, double mass, const Study& study) {
          c.bead_volume = mass / study.grains.density;
      },
      true}}};

Eigen::VectorXd plain_parameters() {
    return Eigen::VectorXd::Constant(1, usual_friction);
}

/// Conditions along the x axis of a column of panels, with their x values.
struct Along {
    std::vector<double> at;
    std::vector<Condition> conditions;
};

/// Conditions, dry or wet, along the x axis of a column. The height of the sample follows from the
/// solid fraction without the effect.
Along along(const Column& column, bool dry, bool at_failure, const Study& study,
            const Predictor& plain) {
    Along all;
    for (int k = 0; k < points_of_curve; ++k) {
        const double part = static_cast<double>(k) / (points_of_curve - 1);
        all.at.push_back(column.log ? column.from * std::pow(column.to / column.from, part)
                                    : column.from + (column.to - column.from) * part);
        all.conditions.push_back(usual(dry, study));
        column.set(all.conditions.back(), all.at.back(), study);
        all.conditions.back().at_failure = at_failure;
    }
    const Eigen::VectorXd flow =
        plain.predict(plain_parameters(), all.conditions, PredictionPart::slopes).value;
    for (std::size_t k = 0; k < all.at.size(); ++k) {
        AnnularCell cell = study.cell.value();
        cell.bead_volume = all.conditions[k].bead_volume.value();
        all.conditions[k].height = height(flow(2 * static_cast<Eigen::Index>(k) + 1), cell);
        if (column.shows_height) all.at[k] = 1e3 * all.conditions[k].height.value();
    }
    return all;
}

/// Value of an effect's parameter at which its signature is drawn: the smallest size of interest
/// away from neutral, or from the liquid's value where the parameter is a property of the liquid.
double shown_size(const Effect& effect, const EffectParameter& p, const Study& study) {
    if (!p.is_fitted()) return p.value_if_not_fitted();
    const double from = effect.given_by_liquid ? effect.unlisted_value(study.liquid) : p.neutral;
    return std::clamp(from + p.smallest_of_interest, p.lower, p.upper);
}

std::vector<double> shown_sizes(const Effect& effect, const Study& study) {
    std::vector<double> values;
    for (const EffectParameter& p : effect.parameters) {
        values.push_back(shown_size(effect, p, study));
    }
    return values;
}

/// Changes of the readings by an effect, with standard errors (empty: none): for each condition the
/// change of shear stress [%], then 1000 times the change of solid fraction [1].
struct Changes {
    Eigen::VectorXd value, error;
};

Changes changes_between(const Eigen::VectorXd& without, const Eigen::VectorXd& with) {
    Changes changes{with - without, {}};
    for (Eigen::Index k = 0; k < changes.value.size(); ++k) {
        changes.value(k) *= k % 2 == 0 ? 100 / without(k) : 1000;
    }
    return changes;
}

/// Changes by an effect on grains, with the emulator's errors, most of which cancel in the change.
Changes changes_of_grains(const ActiveEffect& active, const Study& study,
                          const EmulatedSimulation& simulation,
                          const std::vector<Condition>& conditions) {
    std::vector<EffectiveCondition> both = without_effects(conditions);
    for (const Condition& condition : conditions) {
        both.push_back(changed_condition(condition, {active}, study.liquid));
    }
    const Prediction said =
        simulation.predict_flow(plain_parameters(), both, PredictionPart::covariance);
    const Eigen::Index n = said.value.size() / 2;
    const Eigen::VectorXd without = said.value.head(n), with = said.value.tail(n);
    Eigen::VectorXd error(n);
    for (Eigen::Index k = 0; k < n; ++k) {
        const bool stress = k % 2 == 0;
        const double by_with = stress ? 100 / without(k) : 1000,
                     by_without = stress ? -by_with * with(k) / without(k) : -1000;
        const double variance = by_with * by_with * said.covariance(n + k, n + k) +
                                by_without * by_without * said.covariance(k, k) +
                                2 * by_with * by_without * said.covariance(k, n + k);
        error(k) = std::sqrt(std::max(0.0, variance));
    }
    return {changes_between(without, with).value, error};
}

/// The effect on the level below on the ladder of closures; empty for the lowest level and for
/// effects on no ladder.
std::vector<const Effect*> levels_below(const Effect& effect) {
    const Effect* below = nullptr;
    for (const Effect& other : built_in_effects()) {
        if (effect.of_closure() && other.of_closure() && other.level() < effect.level() &&
            (!below || below->level() < other.level())) {
            below = &other;
        }
    }
    return below ? std::vector{below} : std::vector<const Effect*>{};
}

/// Simulated strengths of wet grains where base "mohr-coulomb" fits its cohesions, at many liquid
/// contents.
std::vector<MeasuredStrength> simulated_strengths(const EmulatedSimulation& simulation,
                                                  const Study& study) {
    std::vector<Condition> conditions;
    constexpr int contents = 40;  // so dense that the curve over the content shows no corners
    for (int k = 0; k <= contents; ++k) {
        for (const double pressure : {2.3, 3.5, 5.0, 10.0}) {
            Condition condition = usual(false, study);
            condition.liquid_content = 0.003 * std::pow(20.0, k / double{contents});
            condition.normal_stress *=
                pressure / reduced_pressure(condition.normal_stress, study.grains, *study.liquid);
            conditions.push_back(condition);
        }
    }
    const Eigen::VectorXd values =
        simulation.predict(plain_parameters(), conditions, PredictionPart::values).value;
    std::vector<MeasuredStrength> strengths;
    for (const Condition& condition : conditions) {
        const auto at = 2 * std::ssize(strengths);
        const double ratio = values(at) / condition.normal_stress;
        strengths.push_back({condition, ratio, 0.01 * ratio});
    }
    return strengths;
}

/// Model without and with one effect; for a level of the ladder of closures, the model on the level
/// below and on this level.
class Models {
  public:
    Models(const Effect& effect, Study study, std::shared_ptr<const EmulatedSimulation> simulation)
        : effect_(effect), study_(std::move(study)), simulation_(std::move(simulation)) {
        const std::vector<const Effect*> below = levels_below(effect);
        if (effect.of_closure()) {
            study_.model.base = "mohr-coulomb";
            if (below.empty()) study_.model.strengths = simulated_strengths(*simulation_, study_);
        }
        without_ = assemble_model(study_, simulation_, below);
        model_ = assemble_model(study_, simulation_, {&effect});
    }

    const Predictor& without() const { return *without_; }

    Changes changes(const std::vector<Condition>& conditions) const {
        const std::vector<double> sizes = shown_sizes(effect_, study_);
        if (effect_.of_grains()) {
            return changes_of_grains({&effect_, sizes}, study_, *simulation_, conditions);
        }
        std::vector<double> parameters = {usual_friction};
        for (std::size_t k = 0; k < sizes.size(); ++k) {
            if (effect_.parameters[k].is_fitted()) parameters.push_back(sizes[k]);
        }
        const Eigen::VectorXd at = Eigen::Map<const Eigen::VectorXd>(
            parameters.data(), static_cast<Eigen::Index>(parameters.size()));
        return changes_between(
            without().predict(plain_parameters(), conditions, PredictionPart::slopes).value,
            model_->predict(at, conditions, PredictionPart::slopes).value);
    }

    /// Whether the effect changes points of failure only.
    bool at_failure() const { return effect_.touches == Touches::failure; }

  private:
    const Effect& effect_;
    Study study_;  ///< study with base `mohr-coulomb` for an effect on closures
    std::shared_ptr<const EmulatedSimulation> simulation_;
    std::shared_ptr<const Predictor> without_, model_;
};

/// Two panels of a column: shear stress above, solid fraction below.
using Pair = std::array<Panel, 2>;

void add_curves(Pair& panels, const Column& column, bool dry, const Study& study,
                const Models& models) {
    const Along readings = along(column, dry, models.at_failure(), study, models.without());
    const Changes changes = models.changes(readings.conditions);
    for (std::size_t row = 0; row < panels.size(); ++row) {
        Curve line{.label = dry ? "dry" : "wet",
                   .style = dry ? Curve::Style::dashed_line : Curve::Style::line,
                   .x = readings.at,
                   .colour = dry ? calibrated_colour : model_colour,
                   .weight = dry ? 1.9 : 1};
        for (std::size_t k = 0; k < readings.at.size(); ++k) {
            const auto at = static_cast<Eigen::Index>(2 * k + row);
            line.y.push_back(changes.value(at));
            if (changes.error.size() > 0) line.y_error.push_back(changes.error(at));
        }
        if (!line.y_error.empty()) {
            Curve band = line;
            band.style = Curve::Style::band;
            band.label = "± 1 standard error";
            band.in_key = false;
            line.y_error.clear();
            panels[row].curves.insert(panels[row].curves.begin(), band);
        }
        panels[row].curves.push_back(line);
    }
}

/// Range of y that includes all curves of the panels from `begin` to before `end` in one row, and
/// `least` to both sides of zero.
AxisRange common_range(const std::vector<Pair>& all, std::size_t row, std::size_t begin,
                       std::size_t end, double least) {
    AxisRange range{-least, least};
    for (std::size_t p = begin; p < end; ++p) {
        for (const Curve& curve : all[p][row].curves) {
            for (std::size_t k = 0; k < curve.y.size(); ++k) {
                const double error = curve.y_error.empty() ? 0 : curve.y_error[k];
                range.first = std::min(range.first, curve.y[k] - error);
                range.second = std::max(range.second, curve.y[k] + error);
            }
        }
    }
    const double margin = 0.08 * (range.second - range.first);
    return {range.first - margin, range.second + margin};
}

/// Sets the ranges of y. The panels at one normal stress share one range. The first column, along
/// which the normal stress varies, has its own, since changes are often far larger there.
void set_ranges(std::vector<Pair>& all) {
    constexpr std::array least = {0.1, 0.5};  // changes that instruments cannot resolve
    for (std::size_t row = 0; row < least.size(); ++row) {
        const AxisRange of_pressure = common_range(all, row, 0, 1, least[row]),
                        of_others = common_range(all, row, 1, all.size(), least[row]);
        for (std::size_t p = 0; p < all.size(); ++p) {
            all[p][row].y_range = p == 0 ? of_pressure : of_others;
        }
    }
}

/// Adds the key that serves all panels, to the first panel.
void add_key(Panel& panel) {
    const auto band = std::ranges::find(panel.curves, Curve::Style::band, &Curve::style);
    if (band != panel.curves.end()) {
        Curve sample{
            .label = band->label, .style = Curve::Style::band, .colour = explaining_colour};
        panel.curves.push_back(sample);
    }
    panel.key = true;
}

/// Size of an effect in a figure: "torque 0.1 mN m", or "on" for a switch.
std::string size_text(const Effect& effect, const Study& study) {
    std::vector<std::string> sizes;
    for (const EffectParameter& p : effect.parameters) {
        if (p.only_simulated) continue;
        std::string name = p.name;
        std::ranges::replace(name, '_', ' ');
        sizes.push_back(
            p.is_switch() ? "on" : name + " " + printed_value(shown_size(effect, p, study), p));
    }
    return fmt::format("{}", fmt::join(sizes, ", "));
}

/// Comparison that the figure of an effect shows, as the end of a sentence: "when torque-offset is
/// present (torque 0.1 mN m)".
std::string comparison_text(const Effect& effect, const Study& study) {
    const std::string size = size_text(effect, study);
    if (effect.given_by_liquid) {
        const EffectParameter& p = effect.parameters.front();
        return fmt::format("when {} instead of {}", size,
                           printed_value(effect.unlisted_value(study.liquid), p));
    }
    if (!effect.is_switch()) return fmt::format("when {} is present ({})", effect.name, size);
    std::string text = fmt::format("when {} is switched on", effect.name);
    if (const auto below = levels_below(effect); !below.empty()) {
        text += fmt::format(", relative to a model with {}", below.front()->name);
    } else if (effect.of_closure()) {
        text += ", relative to base `mohr-coulomb` with cohesions fitted to the simulation";
    }
    return text;
}

}  // namespace

Study signature_study(const std::vector<Effect>& effects) {
    const LabPlan plan;
    Study study;
    study.grains = plan.grains;
    study.liquid = plan.liquid;
    study.cell = plan.cell;
    for (const Effect& effect : effects) {
        study.model.effects.push_back({effect.name, {}});
    }
    return study;
}

Figure signature_figure(const Effect& effect, const Study& study,
                        const std::shared_ptr<const EmulatedSimulation>& simulation) {
    const Models models(effect, study, simulation);
    std::vector<Pair> all;
    for (const Column& column : drawn_columns) {
        Pair panels;
        for (std::size_t row = 0; row < panels.size(); ++row) {
            panels[row].x_label = column.label;
            panels[row].log_x = column.log;
            panels[row].zero_line = true;
            if (column.log) panels[row].x_range = {column.from / 1.1, column.to * 1.1};
        }
        if (effect.touches != Touches::dry) {
            add_curves(panels, column, false, study, models);
        }
        if (column.dry && effect.touches != Touches::wet) {
            add_curves(panels, column, true, study, models);
        }
        all.push_back(panels);
    }
    set_ranges(all);
    add_key(all.front().front());
    all.front()[0].y_label = "shear stress, change [%]";
    all.front()[1].y_label = "10^3 × change of Φ_S";
    Figure figure{.name = effect.name,
                  .title = plain_text(fmt::format("{}, {}", effect.name, size_text(effect, study))),
                  .columns = all.size()};
    for (std::size_t row = 0; row < 2; ++row) {
        for (const Pair& panels : all) {
            figure.panels.push_back(panels[row]);
        }
    }
    return figure;
}

std::string signature_caption(const Effect& effect, const Study& study) {
    const AnnularCell cell = study.cell.value();
    std::string text = fmt::format(
        "The figure shows how the predicted readings change {}: shear stress in the upper row, "
        "solid fraction in the lower row. The grains have a diameter of {:g} µm, a density of {:g} "
        "kg/m³ and a friction of {:g}; the radii of the cell are {:g} and {:g} mm. A quantity that "
        "is not on the horizontal axis has one value: normal stress {:g} kPa, inertial number "
        "{:g}, liquid content {:g} (wet readings), bead mass {:g} g, time since the first "
        "recording began {:g} s, surface tension {:g} mN/m. In the first column, dry readings are "
        "drawn at the normal stress of the wet readings. The other columns share one vertical "
        "scale.",
        comparison_text(effect, study), 1e6 * study.grains.diameter, study.grains.density,
        usual_friction, 1e3 * cell.inner_radius, 1e3 * cell.outer_radius, usual_stress / 1000,
        usual_inertial_number, usual_content, 1e3 * cell.bead_volume * study.grains.density,
        time_of_readings, 1e3 * study.liquid.value().surface_tension);
    if (effect.of_grains()) text += " A band is one standard error of the change.";
    return text;
}

}  // namespace pendular
