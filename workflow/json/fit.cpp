#include "workflow/json/fit.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <nlohmann/json.hpp>
#include <utility>

#include "calib/fit/calibrate_study.h"
#include "data/files/file_access.h"
#include "data/files/json_text.h"
#include "data/formula_variant.h"
#include "data/input_error.h"
#include "workflow/json/parts.h"
#include "workflow/json/training_runs.h"

namespace pendular {
namespace {

Json grains_json(const GrainProperties& g) {
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

Json model_json(const ModelSettings& m) {
    Json json = {{"base", m.base},
                 {"fit_to", m.fit_to},
                 {"bridge_force", to_string(m.bridge_force)},
                 {"effects", Json::array()}};
    for (const ListedEffect& effect : m.effects) {
        json["effects"].push_back(effect.name);
    }
    if (m.discrepancy != std::array{0.0, 0.0}) json["discrepancy"] = m.discrepancy;
    if (m.discrepancy_stated) json["discrepancy_stated"] = true;
    return json;
}

/// JSON of the effects that the study defines itself, with bounds and formulas.
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

Json direct_json(const std::vector<DirectMeasurement>& direct) {
    Json json = Json::array();
    for (const DirectMeasurement& each : direct) {
        json.push_back(direct_json(each));
    }
    return json;
}

/// JSON of the parts of a study, besides its readings, that a calibration rests on.
Json basis_json(const GrainProperties& grains, const std::optional<Liquid>& liquid,
                const ModelSettings& model, const std::vector<WrittenEffect>& written,
                const std::vector<DirectMeasurement>& direct) {
    return {{"grains", grains_json(grains)},
            {"liquid", liquid_json(liquid)},
            {"model", model_json(model)},
            {"formulas", formulas_json(written)},
            {"direct_measurements", direct_json(direct)}};
}

Json fidelity_json(const Fidelity& f) {
    return {{"name", f.name},
            {"beads", f.grains},
            {"stiffness_number", f.stiffness_number},
            {"lowest_inertial_number", f.lowest_inertial_number},
            {"strain", f.strain}};
}

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
    Json json = {{"runs_ordered", Json::array()}, {"hyperparameters", Json::object()}};
    for (const SimulatedRuns& each : c.simulated) {
        json["runs_ordered"].push_back({{"runs", each.runs}, {"why", each.why}});
    }
    for (const auto& [which, hyperparameters] : c.hyperparameters) {
        json["hyperparameters"]
            [std::string(dem::observable_names[static_cast<std::size_t>(which)])] =
                hyperparameters.as_array();
    }
    return json;
}

void read_emulator(const Json& json, Calibration& c) {
    for (const auto& each : json.at("runs_ordered")) {
        c.simulated.push_back({each.at("runs"), each.at("why")});
    }
    for (const auto& [name, hyperparameters] :
         json.at(json.contains("scales") ? "scales" : "hyperparameters").items()) {
        c.hyperparameters[dem::observable_named(name)] = Hyperparameters::from_array(
            hyperparameters.get<std::array<double, Hyperparameters::count>>());
    }
}

Json instrument_json(const Calibration& c) {
    Json json = Json::array();
    for (const InstrumentError& each : c.fit.instrument) {
        Json shifts = Json::object();
        for (std::size_t k = 0; k < c.parameters.size(); ++k)
            shifts[c.parameters[k].name] = each.shift(static_cast<Eigen::Index>(k));
        json.push_back({{"name", each.name},
                        {"standard_uncertainty", each.standard},
                        {"unit", each.unit},
                        {"assumed", each.assumed},
                        {"counts", each.counts},
                        {"shift", shifts},
                        {"needed", each.needed},
                        {"alike", each.alike}});
    }
    return json;
}

double number_or_nan(const Json& json) {
    return json.is_number() ? json.get<double>() : std::numeric_limits<double>::quiet_NaN();
}

/// Reads the contributions of shared errors, which earlier versions did not write.
void read_instrument(const Json& json, Calibration& c) {
    for (const Json& each : json.value("instrument", Json::array())) {
        InstrumentError& error = c.fit.instrument.emplace_back();
        error = {.name = each.at("name"),
                 .standard = each.at("standard_uncertainty"),
                 .unit = each.at("unit"),
                 .assumed = each.at("assumed"),
                 .counts = each.at("counts"),
                 .shift = Eigen::VectorXd(std::ssize(c.parameters)),
                 .needed = number_or_nan(each.at("needed")),
                 .alike = each.value("alike", std::vector<std::string>{})};
        for (std::size_t k = 0; k < c.parameters.size(); ++k)
            error.shift(static_cast<Eigen::Index>(k)) =
                number_or_nan(each.at("shift").at(c.parameters[k].name));
    }
}

}  // namespace

Json to_json(const Calibration& c, const Comparison& comparison, const Belief& belief) {
    Json json;
    for (std::size_t k = 0; k < c.parameters.size(); ++k) {
        const auto i = static_cast<Eigen::Index>(k);
        Json& parameter = json["parameters"][c.parameters[k].name];
        parameter = uncertain(c.fit.parameters(i), c.fit.standard_error(i));
        parameter["unit"] = c.parameters[k].unit;
        parameter["stderr_measurement"] = c.fit.measurement_error(i);
        parameter["stderr_simulation"] = c.fit.simulation_error(i);
        parameter["stderr_instrument"] = c.fit.instrument_error(i);
        parameter["stderr_typical_instrument"] = c.fit.instrument_error(i, false);
        parameter["stderr_discrepancy"] = c.fit.discrepancy_error(i);
        parameter["at_bound"] = static_cast<bool>(c.fit.at_bound[k]);
        parameter["determined"] = c.fit.determines(i);
        if (i < c.fit.range.upper.size())
            parameter["range"] = {c.fit.range.lower(i), c.fit.range.upper(i)};
        if (!c.profile.empty()) {
            parameter["profile_68_percent"] = {c.profile[k].first, c.profile[k].second};
        }
    }
    const auto or_zero = [&](const Eigen::MatrixXd& part) {
        return matrix_json(part.size() > 0 ? part
                                           : Eigen::MatrixXd::Zero(c.fit.covariance.rows(),
                                                                   c.fit.covariance.cols()));
    };
    json["parameter_covariance"] = matrix_json(c.fit.total_covariance());
    json["parameter_covariance_by_few_replicates"] = or_zero(c.fit.widening);
    json["parameter_covariance_by_discrepancy"] = or_zero(c.fit.discrepancy_part);
    json["inexactness"] = c.fit.inexactness;
    json["instrument"] = instrument_json(c);
    json["chi2"] = comparison.fitted.chi2;
    json["dof"] = comparison.fitted.dof;
    json["predicted_only"] = misfit_json(comparison.predicted);
    json["converged"] = c.fit.converged;
    json["covariance_scaled_by_chi2"] = false;
    json["cohesion_lines"] = cohesion_lines_json(c.cohesion_lines);
    json["cohesion_lines_from"] = c.cohesion.lowest_reduced_pressure;
    if (c.cohesion.inertial_number) json["cohesion_lines_at"] = *c.cohesion.inertial_number;
    json["predictions"] = Json::array();
    for (std::size_t k = 0; k < comparison.readings.size(); ++k) {
        json["predictions"].push_back(prediction_json(comparison.readings[k]));
        json["predictions"].back()["fitted"] = k < c.fitted;
    }
    json.update(basis_json(c.grains, c.liquid, c.model, c.written_effects, c.direct));
    json["fidelity"] = fidelity_json(c.fidelity);
    json["seed"] = c.seed;
    json["rounds"] = c.rounds;
    json["cold"] = c.cold;
    json["emulator"] = emulator_json(c);
    json["notes"] = c.notes;
    json["runs"] = runs_json(c.runs, c.known);
    add_belief(json, belief);
    return json;
}

void write_calibration(const std::filesystem::path& folder, const Calibration& calibration,
                       const Comparison& comparison, const Belief& belief) {
    // The runs are written first, since a fit file without its runs cannot be read.
    write_own_runs(folder, calibration.runs);
    write_json(folder / "fit.json", to_json(calibration, comparison, belief));
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

/// Reads the ranges within which the parameters were fitted, which earlier versions did not write.
void read_ranges(const Json& json, Fit& fit) {
    const auto n = static_cast<Eigen::Index>(json.at("parameters").size());
    ParameterBounds range{Eigen::VectorXd(n), Eigen::VectorXd(n)};
    Eigen::Index k = 0;
    for (const auto& [name, parameter] : json.at("parameters").items()) {
        if (!parameter.contains("range")) return;
        range.lower(k) = parameter.at("range").at(0), range.upper(k) = parameter.at("range").at(1);
        ++k;
    }
    fit.range = std::move(range);
}

/// Reads the fitted parameters with their errors, in the order of the file.
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
    read_ranges(json, c.fit);
    read_instrument(json, c);
    c.fit.widening = matrix_from(json.at("parameter_covariance_by_few_replicates"), n);
    c.fit.covariance = matrix_from(json.at("parameter_covariance"), n) - c.fit.widening;
    c.fit.inexactness = json.at("inexactness");
    c.fit.discrepancy_part = matrix_from(json.at("parameter_covariance_by_discrepancy"), n);
    c.fit.covariance -= (std::pow(c.fit.inexactness, 2) - 1) * c.fit.discrepancy_part;
    c.fit.measurement_part.diagonal() -= c.fit.widening.diagonal();
}

/// Whether a fit took exactly the shared errors into account that count in the study.
bool has_uncertainties(const Json& json, const ResolvedStudy& study) {
    std::map<std::string, double> fitted, counting;
    for (const Json& each : json.value("instrument", Json::array()))
        if (each.at("counts")) fitted[each.at("name")] = each.at("standard_uncertainty");
    for (const SharedUncertainty& each : study.uncertainties()) {
        const bool is_fitted = std::ranges::any_of(
            study.effects(), [&](const Effect* effect) { return each.is_fitted_by(*effect); });
        if (each.counts && !is_fitted) counting[each.name] = each.standard;
    }
    return fitted == counting;
}

Calibration parse_calibration(const Json& json, const ResolvedStudy& resolved,
                              const std::vector<Reading>& readings, const Position& where) {
    const Study& study = resolved;
    const Json& entries = json.at("predictions");
    const bool same_readings =
        entries.size() == readings.size() &&
        std::ranges::equal(entries, readings,
                           [](const Json& e, const Reading& r) { return made_from(e, r); });
    const Json basis = basis_json(study.grains, study.liquid, study.model, study.written_effects,
                                  resolved.direct());
    const bool same_basis = std::ranges::all_of(basis.items(), [&](const auto& item) {
        return json.value(item.key(), Json::array()) ==
               item.value();  // a missing key is an empty list
    });
    // Fits of earlier versions had no discrepancy, or another one of the same size.
    const bool knows_discrepancy = json.contains("inexactness");
    if (!same_readings || !same_basis || !knows_discrepancy || !has_uncertainties(json, resolved)) {
        throw InputError(
            where,
            "the readings, direct measurements, grains, liquid, model or [instrument] of the study "
            "have changed since this fit; run 'pendular calibrate' again");
    }
    Calibration c;
    c.grains = study.grains;
    c.liquid = study.liquid;
    c.model = study.model;
    c.written_effects = study.written_effects;
    c.direct = resolved.direct();
    c.fitted = fitted_count(resolved, readings);
    c.readings = readings;
    const Json& f = json.at("fidelity");
    c.fidelity = {f.at("name"), f.at("beads"), f.at("stiffness_number"),
                  f.at("lowest_inertial_number"), f.at("strain")};
    c.seed = json.at("seed");
    c.rounds = json.at("rounds");
    c.cohesion.lowest_reduced_pressure = json.at("cohesion_lines_from");
    if (json.contains("cohesion_lines_at")) c.cohesion.inertial_number = json["cohesion_lines_at"];
    if (json.at("emulator").is_null()) {
        throw InputError(where,
                         "an earlier version made this fit without an emulator; run 'pendular "
                         "calibrate' again");
    }
    c.cold = json.value("cold", false);  // not written by earlier versions
    read_emulator(json.at("emulator"), c);
    c.notes = json.at("notes").get<std::vector<std::string>>();
    read_parameters(json, c);
    c.fit.chi2 = json.at("chi2");
    c.fit.dof = json.at("dof");
    c.fit.converged = json.at("converged");
    TrainingRuns training = named_runs(json.at("runs"), where.file);
    c.runs = std::move(training.runs);
    c.known = training.began_with;
    if (c.runs.size() < 3) {
        throw InputError(where,
                         "the simulations of this fit are missing; run 'pendular calibrate' again");
    }
    return c;
}

}  // namespace

Calibration read_calibration(const std::filesystem::path& file, const ResolvedStudy& study,
                             const std::vector<Reading>& readings) {
    std::error_code ignored;
    if (!std::filesystem::exists(file, ignored)) {
        throw InputError({file.string()},
                         "there is no calibration yet; run 'pendular calibrate' first");
    }
    try {
        const Json json = Json::parse(read_bytes(file, largest_table));
        check_json_format(json, file, "run 'pendular calibrate' again");
        return parse_calibration(json, study, readings, {file.string()});
    } catch (const InputError&) {
        throw;
    } catch (const std::exception& error) {
        throw InputError(
            {file.string()},
            fmt::format("not a calibration of this version ({}); run 'pendular calibrate' again",
                        error.what()));
    }
}

}  // namespace pendular
