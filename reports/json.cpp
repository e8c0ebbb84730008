#include "reports/json.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>

#include "data/form.h"
#include "data/input_error.h"
#include "data/text_file.h"
#include "reports/failure_report.h"

namespace pendular {
namespace {

using Json = nlohmann::ordered_json;

Json uncertain(double value, double error) {
    return {{"value", value}, {"stderr", error}};
}

Json pair_of(const Eigen::Vector2d& value, const Eigen::Matrix2d& covariance) {
    return {{"shear_stress", uncertain(value(0), std::sqrt(covariance(0, 0)))},
            {"solid_fraction", uncertain(value(1), std::sqrt(covariance(1, 1)))}};
}

Json misfit_json(const Misfit& misfit) {
    return {{"chi2", misfit.chi2}, {"dof", misfit.dof}, {"p", misfit.p()}};
}

Json prediction_json(const ReadingMisfit& misfit) {
    const Reading& reading = misfit.reading;
    return {{"file", reading.origin.file},
            {"step", reading.step},
            {"normal_stress", reading.condition.normal_stress},
            {"inertial_number", reading.condition.inertial_number},
            {"liquid_content", reading.condition.liquid_content},
            {"measured", pair_of(reading.value, reading.covariance)},
            {"predicted", pair_of(misfit.predicted, misfit.predicted_covariance)},
            {"chi2", misfit.chi2.sum()}};
}

Json grains_json(const Grains& g) {
    Json json = {{"diameter", g.diameter},
                 {"density", g.density},
                 {"youngs_modulus", nullptr},
                 {"poisson_ratio", g.poisson_ratio}};
    if (g.youngs_modulus) {
        json["youngs_modulus"] = *g.youngs_modulus;
    }
    return json;
}

Json liquid_json(const std::optional<Liquid>& l) {
    if (!l) {
        return nullptr;
    }
    return {{"surface_tension", l->surface_tension},
            {"contact_angle", l->contact_angle},
            {"viscosity", l->viscosity}};
}

Json model_json(const ModelChoice& m) {
    Json json = {{"base", m.base},
                 {"fit_to", m.fit_to},
                 {"bridge_force", to_string(m.bridge_force)},
                 {"effects", Json::array()}};
    for (const ListedEffect& effect : m.effects) {
        json["effects"].push_back(effect.name);
    }
    return json;
}

/// The formulas of the study's own effects.
Json formulas_json(const std::vector<WrittenEffect>& effects) {
    Json json = Json::object();
    for (const WrittenEffect& effect : effects) {
        Json& own = json[effect.name];
        own = {{"lower", effect.lower}, {"upper", effect.upper}, {"neutral", effect.neutral}};
        for (const Formula& formula : effect.formulas) {
            own[formula.target] = formula.text;
        }
    }
    return json;
}

/// What of a study, besides its readings, a calibration rests on.
Json basis_json(const Grains& grains, const std::optional<Liquid>& liquid, const ModelChoice& model,
                const std::vector<WrittenEffect>& written) {
    return {{"grains", grains_json(grains)},
            {"liquid", liquid_json(liquid)},
            {"model", model_json(model)},
            {"formulas", formulas_json(written)}};
}

Json fidelity_json(const Fidelity& f) {
    return {{"name", f.name},
            {"beads", f.beads},
            {"stiffness_number", f.stiffness_number},
            {"lowest_inertial_number", f.lowest_inertial_number},
            {"strain", f.strain}};
}

Json cohesion_lines_json(const std::vector<CohesionLine>& lines) {
    const auto estimate = [](const Estimate& e) { return uncertain(e.value, e.standard_error); };
    Json json = Json::array();
    for (const auto& line : lines) {
        Json below = Json::array();
        for (const auto& one : line.below) {
            below.push_back(
                {{"reduced_pressure", one.reduced_pressure}, {"relative", estimate(one.relative)}});
        }
        json.push_back({{"source", line.source},
                        {"liquid_content", line.liquid_content},
                        {"inertial_number", line.inertial_number},
                        {"stress_ratio_intercept", estimate(line.stress_ratio_intercept)},
                        {"reduced_cohesion", estimate(line.reduced_cohesion)},
                        {"correlation", line.correlation},
                        {"cohesion", estimate(line.cohesion)},
                        {"points", line.points},
                        {"lowest_reduced_pressure", line.lowest_reduced_pressure},
                        {"chi2", line.chi2},
                        {"dof", line.dof},
                        {"overestimate_below", below}});
    }
    return json;
}

}  // namespace

Json effects_json(const std::vector<ActiveEffect>& effects) {
    Json json = Json::object();
    for (const ActiveEffect& active : effects) {
        for (std::size_t k = 0; k < active.values.size(); ++k) {
            json[active.effect->name + "." + active.effect->parameters[k].name] = active.values[k];
        }
    }
    return json;
}

namespace {

/// Effects on grains, their values in the units of the run.
Json run_effects_json(const std::vector<EffectValues>& effects) {
    std::vector<ActiveEffect> active;
    for (const EffectValues& values : effects) {
        active.push_back({&built_in_effect(values.effect), values.values});
    }
    return effects_json(active);
}

/// The same back, by name as a run has them.
std::vector<EffectValues> read_run_effects(const Json& json) {
    std::vector<EffectValues> effects;
    for (const auto& [key, value] : json.items()) {
        const Effect& effect = built_in_effect(key.substr(0, key.find('.')));
        if (effects.empty() || effects.back().effect != effect.name) {
            effects.push_back({effect.name, effect.neutral()});
        }
        effects.back().values[effect.parameter(key.substr(key.find('.') + 1))] = value;
    }
    return effects;
}

}  // namespace

Json to_json(const dem::RunResult& run) {
    Json json;
    for (std::size_t k = 0; k < dem::observable_count; ++k) {
        json[std::string(dem::observable_names[k])] =
            uncertain(run.means[k].value, run.means[k].standard_error);
    }
    const auto& p = run.parameters;
    json["covariance_stress_ratio_solid_fraction"] = run.covariance;
    json["friction"] = p.friction;
    json["inertial_number"] = p.inertial_number;
    json["stiffness_number"] = p.stiffness_number;
    json["poisson_ratio"] = p.poisson_ratio;
    json["damping"] = p.damping;
    json["reduced_pressure"] = nullptr;
    if (p.wetting) {
        json["reduced_pressure"] = p.wetting->reduced_pressure;
        json["bridge_volume"] = p.wetting->bridge_volume;
        json["bridge_force"] = to_string(p.wetting->bridge_force);
    }
    if (!p.effects.empty()) {
        json["effects_in_run_units"] = run_effects_json(p.effects);
    }
    json["beads"] = p.beads;
    json["strain"] = p.strain;
    json["seed"] = p.seed;
    if (p.start != 0) {
        json["start"] = fmt::format("{:x}", p.start);
    }
    json["precision"] = Json::object();
    for (const dem::Precision& wanted : p.precision) {
        json["precision"]
            [std::string(dem::observable_names[static_cast<std::size_t>(wanted.which)])] =
                wanted.standard_error;
    }
    json["strain_averaged"] = run.strain_averaged;
    json["strain_transient"] = run.strain_transient;
    json["time_step"] = run.time_step;
    json["steps"] = run.steps;
    json["wall_seconds"] = run.wall_seconds;
    json["particle_steps_per_second"] = run.particle_steps_per_second();
    json["crystallised"] = run.crystallised;
    json["steady"] = run.steady;
    json["precise"] = run.precise;
    return json;
}

dem::RunResult run_from_json(const Json& json) {
    dem::RunResult run;
    for (std::size_t k = 0; k < dem::observable_count; ++k) {
        const Json& observable = json.at(std::string(dem::observable_names[k]));
        run.means[k].value = observable.at("value");
        run.means[k].standard_error = observable.at("stderr");
    }
    auto& p = run.parameters;
    run.covariance = json.at("covariance_stress_ratio_solid_fraction");
    p.friction = json.at("friction");
    p.inertial_number = json.at("inertial_number");
    p.stiffness_number = json.at("stiffness_number");
    p.poisson_ratio = json.at("poisson_ratio");
    p.damping = json.at("damping");
    if (!json.at("reduced_pressure").is_null()) {
        p.wetting = {json.at("reduced_pressure"), json.at("bridge_volume"),
                     form_named(json.at("bridge_force").get<std::string>())};
    }
    p.effects = read_run_effects(json.value("effects_in_run_units", Json::object()));
    p.beads = json.at("beads");
    p.strain = json.at("strain");
    p.seed = json.at("seed");
    p.start = std::stoull(json.value("start", "0"), nullptr, 16);
    for (const auto& [name, error] : json.at("precision").items()) {
        p.precision.push_back({dem::observable_named(name), error});
    }
    run.strain_averaged = json.at("strain_averaged");
    run.strain_transient = json.at("strain_transient");
    run.time_step = json.at("time_step");
    run.steps = json.at("steps");
    run.wall_seconds = json.at("wall_seconds");
    run.crystallised = json.at("crystallised");
    run.steady = json.at("steady");
    run.precise = json.at("precise");
    return run;
}

Json to_json(const Measurements& measurements) {
    Json json;
    json["readings"] = Json::array();
    for (const auto& r : measurements.readings) {
        Json entry = {{"file", r.origin.file},
                      {"line", r.origin.line},
                      {"step", r.step},
                      {"normal_stress", r.condition.normal_stress},
                      {"shear_rate", r.shear_rate},
                      {"inertial_number", r.condition.inertial_number},
                      {"liquid_content", r.condition.liquid_content},
                      {"height", nullptr},
                      {"replicates", r.replicates},
                      {"error_assumed", r.error_assumed}};
        if (r.condition.height) {
            entry["height"] = *r.condition.height;
        }
        entry.update(pair_of(r.value, r.covariance));
        entry["covariance"] = r.covariance(0, 1);
        json["readings"].push_back(entry);
    }
    json["excluded"] = Json::array();
    for (const auto& e : measurements.excluded) {
        json["excluded"].push_back({{"file", e.origin.file},
                                    {"first_line", e.origin.line},
                                    {"last_line", e.last_line},
                                    {"reason", e.reason}});
    }
    json["notes"] = measurements.notes;
    return json;
}

namespace {

/// Null for a calibration by direct simulation.
Json matrix_json(const Eigen::MatrixXd& matrix) {
    Json rows = Json::array();
    for (Eigen::Index r = 0; r < matrix.rows(); ++r) {
        rows.push_back(std::vector<double>());
        for (Eigen::Index k = 0; k < matrix.cols(); ++k) {
            rows.back().push_back(matrix(r, k));
        }
    }
    return rows;
}

Json emulator_json(const Calibration& c) {
    if (!c.scales) {
        return nullptr;
    }
    Json json = {{"runs_ordered", Json::array()}, {"scales", Json::object()}};
    for (const Order& order : c.orders) {
        json["runs_ordered"].push_back({{"runs", order.runs}, {"why", order.why}});
    }
    for (const auto& [which, scales] : *c.scales) {
        json["scales"][std::string(dem::observable_names[static_cast<std::size_t>(which)])] =
            scales.as_array();
    }
    return json;
}

void read_emulator(const Json& json, Calibration& c) {
    if (json.is_null()) {
        return;
    }
    for (const auto& order : json.at("runs_ordered")) {
        c.orders.push_back({order.at("runs"), order.at("why")});
    }
    c.scales.emplace();
    for (const auto& [name, scales] : json.at("scales").items()) {
        (*c.scales)[dem::observable_named(name)] =
            Scales::from_array(scales.get<std::array<double, Scales::count>>());
    }
}

}  // namespace

Json to_json(const Calibration& c, const Comparison& comparison) {
    Json json;
    for (std::size_t k = 0; k < c.parameters.size(); ++k) {
        const auto i = static_cast<Eigen::Index>(k);
        Json& parameter = json["parameters"][c.parameters[k].name];
        parameter = uncertain(c.fit.parameters(i), c.fit.standard_error(i));
        parameter["unit"] = c.parameters[k].unit;
        parameter["stderr_measurement"] = c.fit.measurement_error(i);
        parameter["stderr_simulation"] = c.fit.simulation_error(i);
        parameter["at_bound"] = static_cast<bool>(c.fit.at_bound[k]);
        if (c.profile && k == 0) {
            parameter["profile_68_percent"] = {c.profile->first, c.profile->second};
        }
    }
    json["parameter_covariance"] = matrix_json(c.fit.covariance);
    json["chi2"] = comparison.fitted.chi2;
    json["dof"] = comparison.fitted.dof;
    json["predicted_only"] = misfit_json(comparison.predicted);
    json["converged"] = c.fit.converged;
    json["covariance_scaled_by_chi2"] = false;
    json["cohesion_lines"] = cohesion_lines_json(c.cohesion_lines);
    json["cohesion_lines_from"] = c.cohesion.lowest_reduced_pressure;
    json["predictions"] = Json::array();
    for (std::size_t k = 0; k < comparison.readings.size(); ++k) {
        json["predictions"].push_back(prediction_json(comparison.readings[k]));
        json["predictions"].back()["fitted"] = k < c.fitted;
    }
    json.update(basis_json(c.grains, c.liquid, c.model, c.written_effects));
    json["fidelity"] = fidelity_json(c.fidelity);
    json["seed"] = c.seed;
    json["rounds"] = c.rounds;
    json["surface_centre"] = c.surface_centre;
    json["emulator"] = emulator_json(c);
    json["notes"] = c.notes;
    json["runs"] = Json::array();
    for (const auto& run : c.runs) {
        json["runs"].push_back(to_json(run));
    }
    return json;
}

namespace {

/// Whether a prediction entry was made from this reading, up to rounding in the file.
bool made_from(const Json& entry, const Reading& reading) {
    const auto same = [](double a, double b) {
        return std::abs(a - b) <= 1e-9 * std::max(std::abs(a), std::abs(b));
    };
    const Json& measured = entry.at("measured");
    return same(entry.at("normal_stress"), reading.condition.normal_stress) &&
           same(entry.at("inertial_number"), reading.condition.inertial_number) &&
           same(entry.at("liquid_content"), reading.condition.liquid_content) &&
           same(measured.at("shear_stress").at("value"), reading.value(0)) &&
           same(measured.at("solid_fraction").at("value"), reading.value(1)) &&
           same(measured.at("shear_stress").at("stderr"), std::sqrt(reading.covariance(0, 0))) &&
           same(measured.at("solid_fraction").at("stderr"), std::sqrt(reading.covariance(1, 1)));
}

Eigen::MatrixXd matrix_from(const Json& rows, Eigen::Index n) {
    Eigen::MatrixXd matrix(n, n);
    for (Eigen::Index r = 0; r < n; ++r) {
        for (Eigen::Index k = 0; k < n; ++k) {
            matrix(r, k) = rows.at(static_cast<std::size_t>(r)).at(static_cast<std::size_t>(k));
        }
    }
    return matrix;
}

/// The fitted parameters with their errors, in their order.
void read_parameters(const Json& json, Calibration& c) {
    const auto n = static_cast<Eigen::Index>(json.at("parameters").size());
    c.fit.parameters.resize(n);
    c.fit.measurement_part = Eigen::MatrixXd::Zero(n, n);
    for (const auto& [name, parameter] : json.at("parameters").items()) {
        const auto k = static_cast<Eigen::Index>(c.parameters.size());
        const double measurement = parameter.at("stderr_measurement");
        c.parameters.push_back({.name = name, .unit = parameter.at("unit")});
        c.fit.parameters(k) = parameter.at("value");
        c.fit.measurement_part(k, k) = measurement * measurement;
        c.fit.at_bound.push_back(parameter.at("at_bound"));
    }
    c.fit.covariance = matrix_from(json.at("parameter_covariance"), n);
}

Calibration parse_calibration(const Json& json, const Study& study,
                              const std::vector<Reading>& readings, const Position& where) {
    const Json& entries = json.at("predictions");
    const bool same_readings =
        entries.size() == readings.size() &&
        std::ranges::equal(entries, readings,
                           [](const Json& e, const Reading& r) { return made_from(e, r); });
    const Json basis = basis_json(study.grains, study.liquid, study.model, study.written_effects);
    const bool same_basis = std::ranges::all_of(
        basis.items(), [&](const auto& item) { return json.at(item.key()) == item.value(); });
    if (!same_readings || !same_basis) {
        throw InputError(
            where,
            "this fit was made from other readings, grains, liquid or model than the study holds "
            "now; run 'pendular calibrate' again");
    }
    Calibration c;
    c.grains = study.grains;
    c.liquid = study.liquid;
    c.model = study.model;
    c.written_effects = study.written_effects;
    c.fitted = fitted_count(study, readings);
    c.readings = readings;
    const Json& f = json.at("fidelity");
    c.fidelity = {f.at("name"), f.at("beads"), f.at("stiffness_number"),
                  f.at("lowest_inertial_number"), f.at("strain")};
    c.seed = json.at("seed");
    c.rounds = json.at("rounds");
    c.cohesion.lowest_reduced_pressure = json.at("cohesion_lines_from");
    c.surface_centre = json.at("surface_centre");
    read_emulator(json.at("emulator"), c);
    c.notes = json.at("notes").get<std::vector<std::string>>();
    read_parameters(json, c);
    c.fit.chi2 = json.at("chi2");
    c.fit.dof = json.at("dof");
    c.fit.converged = json.at("converged");
    for (const auto& run : json.at("runs")) {
        c.runs.push_back(run_from_json(run));
    }
    if (c.runs.size() < 3) {
        throw InputError(where, "the runs of this fit are missing; run 'pendular calibrate' again");
    }
    return c;
}

}  // namespace

Calibration read_calibration(const std::filesystem::path& file, const Study& study,
                             const std::vector<Reading>& readings) {
    std::ifstream stream(file);
    if (!stream) {
        throw InputError({file.string()},
                         "there is no calibration yet; run 'pendular calibrate' first");
    }
    try {
        return parse_calibration(Json::parse(stream), study, readings, {file.string()});
    } catch (const InputError&) {
        throw;
    } catch (const std::exception& error) {
        throw InputError(
            {file.string()},
            fmt::format("not a calibration of this version ({}); run 'pendular calibrate' again",
                        error.what()));
    }
}

Json to_json(const Comparison& comparison, const std::vector<CohesionLine>& lines,
             const WhereItFails& where) {
    Json json;
    json.update(misfit_json(comparison.total));
    json["fitted"] = misfit_json(comparison.fitted);
    json["predicted_only"] = misfit_json(comparison.predicted);
    json["rms_percent"] = {{"shear_stress", comparison.rms_percent[0]},
                           {"solid_fraction", comparison.rms_percent[1]}};
    json["by_observable"] = {{"shear_stress", comparison.by_observable[0]},
                             {"solid_fraction", comparison.by_observable[1]}};
    json["by_condition"] = Json::array();
    for (const auto& group : comparison.by_condition) {
        Json entry = {
            {"normal_stress", group.condition.normal_stress},
            {"inertial_number", group.condition.inertial_number},
            {"liquid_content", group.condition.liquid_content},
            {"readings", Json::array()},
            {"chi2", group.chi2},
            {"normalised",
             {{"shear_stress", group.normalised(0)}, {"solid_fraction", group.normalised(1)}}}};
        for (const std::size_t k : group.readings) {
            entry["readings"].push_back(prediction_json(comparison.readings[k]));
        }
        json["by_condition"].push_back(entry);
    }
    json["by_file"] = Json::array();
    for (const auto& file : comparison.by_file) {
        json["by_file"].push_back({{"file", std::filesystem::path(file.file).filename().string()},
                                   {"readings", file.readings},
                                   {"chi2", file.chi2}});
    }
    json["cohesion_lines"] = cohesion_lines_json(lines);
    json["where"] = to_json(where);
    return json;
}

void write_json(const std::filesystem::path& file, const Json& json) {
    write_whole(file, json.dump(2) + "\n");
}

}  // namespace pendular
