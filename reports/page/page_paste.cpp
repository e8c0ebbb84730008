#include "reports/page/page_paste.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <vector>

#include "calib/fit/calibrate_study.h"
#include "data/files/csv.h"
#include "reports/failure_report.h"
#include "reports/page/page_data.h"
#include "reports/tables.h"
#include "reports/verdict_report.h"
#include "reports/with_error.h"
#include "reports/words.h"

namespace pendular {
namespace {

/// Row of the table.
struct PasteRow {
    std::string quantity;
    std::string value, error;  ///< numbers in the SI unit; empty: unknown
    std::string unit = "1";
    std::string text;  ///< value, error and unit as one reads them
    std::string remark = {};
};

/// Number with seven digits: more than any error has.
std::string seven_digits(double value) {
    return fmt::format("{:.7g}", value);
}

PasteRow row_of(const Fit& fit, std::size_t k, const Parameter& parameter) {
    const auto i = static_cast<Eigen::Index>(k);
    PasteRow row{.quantity = parameter_in_words(parameter.name),
                 .value = seven_digits(fit.parameters(i)),
                 .error = seven_digits(fit.standard_error(i)),
                 .unit = parameter.unit,
                 .text = with_error(fit.parameters(i), fit.standard_error(i), parameter.unit)};
    if (fit.at_bound[k]) row.remark = "at an end of its range: the error holds on one side";
    if (!fit.determines(i)) {
        row.value = row.error = "";
        row.text = row.remark = "not determined by the readings";
    }
    return row;
}

/// Rows of the cohesions from straight lines through measured and predicted wet readings.
std::vector<PasteRow> cohesion_rows(const SwitchedModel& model) {
    Calibration c = model.calibration;
    add_cohesion_lines(*model.predictor, c);
    std::vector<PasteRow> rows;
    for (const CohesionLine& line : c.cohesion_lines) {
        const std::string rate = line.inertial_number > 0
                                     ? fmt::format("inertial number {:.3g}", line.inertial_number)
                                     : "quasi-static limit";
        rows.push_back(
            {.quantity = fmt::format("cohesion, liquid content {:.3g}", line.liquid_content),
             .value = seven_digits(line.cohesion.value),
             .error = seven_digits(line.cohesion.standard_error),
             .unit = "Pa",
             .text = with_error(line.cohesion.value, line.cohesion.standard_error, "Pa"),
             .remark = fmt::format("line through the {} at P* of {:.2g} or more, {}",
                                   line.source == "measured" ? "readings" : "model's predictions",
                                   line.lowest_reduced_pressure, rate)});
    }
    return rows;
}

PasteRow plain_row(const std::string& quantity, double value, const char* format,
                   const std::string& unit) {
    const std::string text = fmt::format(fmt::runtime(format), value);
    return {.quantity = quantity,
            .value = text,
            .error = "",
            .unit = unit,
            .text = unit == "1" ? text : text + " " + unit};
}

std::vector<PasteRow> rows_of(const SwitchedModel& model) {
    const Calibration& c = model.calibration;
    std::vector<PasteRow> rows;
    for (std::size_t k = 0; k < c.parameters.size(); ++k) {
        rows.push_back(row_of(c.fit, k, c.parameters[k]));
    }
    std::ranges::move(cohesion_rows(model), std::back_inserter(rows));
    const Misfit& total = model.comparison.total;
    rows.push_back(plain_row("chi2", total.chi2, "{:.2f}", "1"));
    rows.push_back(plain_row("degrees of freedom", total.dof, "{:.0f}", "1"));
    const auto& rms = model.comparison.rms_percent;
    rows.push_back(plain_row("relative RMS error of shear stress", rms[0], "{:.2f}", "%"));
    rows.push_back(plain_row("relative RMS error of solid fraction", rms[1], "{:.2f}", "%"));
    return rows;
}

std::string csv_of(const std::vector<PasteRow>& rows) {
    std::string text = "quantity,value,standard error,unit,remark\n";
    for (const PasteRow& row : rows) {
        text += fmt::format("{},{},{},{},{}\n", csv_cell(row.quantity), row.value, row.error,
                            csv_cell(row.unit), csv_cell(row.remark));
    }
    return text;
}

void replace_all(std::string& text, const std::string& from, const std::string& to) {
    for (std::size_t at = 0; (at = text.find(from, at)) != std::string::npos; at += to.size()) {
        text.replace(at, from.size(), to);
    }
}

/// Text with the characters that LaTeX reads as commands escaped.
std::string for_latex(const std::string& text) {
    std::string safe;
    for (const char c : text) {
        if (std::string_view("&%$#_{}").find(c) != std::string_view::npos) safe += '\\';
        if (c == '\\' || c == '~' || c == '^') {
            safe += fmt::format("\\char{} ", static_cast<int>(c));
        } else {
            safe += c;
        }
    }
    return safe;
}

/// Value with error and unit for LaTeX: "$(1.03 \pm 0.12)\times 10^{-6}$", "$92\,\mu$N m".
std::string value_for_latex(const PasteRow& row) {
    std::string text = for_latex(row.text);
    replace_all(text, "+-", "$\\pm$");
    if (const auto power = text.find(")e"); power != std::string::npos) {
        const auto end = std::min(text.find(' ', power), text.size());
        const std::string exponent = text.substr(power + 2, end - power - 2);
        text.replace(power + 1, end - power - 1, "$\\times 10^{" + exponent + "}$");
    }
    for (const char* unit : {"N", "Pa", "m"}) {
        replace_all(text, std::string(" u") + unit, std::string(" $\\mu$") + unit);
    }
    if (row.unit == "1" && text.starts_with('-')) text = "$-$" + text.substr(1);
    return text;
}

std::string latex_of(const std::vector<PasteRow>& rows) {
    std::string text = "\\begin{tabular}{lrl}\n\\hline\nquantity & value & remark \\\\\n\\hline\n";
    for (const PasteRow& row : rows) {
        text += fmt::format("{} & {} & {} \\\\\n", for_latex(row.quantity), value_for_latex(row),
                            row.remark == row.text ? "" : for_latex(row.remark));
    }
    return text + "\\hline\n\\end{tabular}\n";
}

/// Sentence on the misfit, and on how effects of the study reduced it.
std::string result_sentence(const PageContent& content, const SwitchedModel& model) {
    const auto& bare = content.switched.models.front();
    const Misfit& total = model.comparison.total;
    const std::string friction = estimate_text(model.calibration.fit, 0, "1");
    std::vector<std::string> effects;
    for (const ListedEffect& effect : model.calibration.model.effects) {
        effects.push_back(effect.name);
    }
    const std::string value = fmt::format(
        "the {} is {}", parameter_in_words(model.calibration.parameters.front().name), friction);
    if (effects.empty() || !bare || content.switched.current == 0 ||
        !content.switched.always.empty()) {
        return fmt::format("For all readings, {}; {}.", misfit_text(total), value);
    }
    return fmt::format(
        "With {} in the model, chi2 {} from {:.1f} for {} to {:.1f} for {}, and the relative "
        "RMS error of the shear stress from {:.2f} % to {:.2f} %; {} ({} without).",
        joined(effects, "and"), total.chi2 < bare->comparison.total.chi2 ? "falls" : "rises",
        bare->comparison.total.chi2, freedom_text(bare->comparison.total.dof), total.chi2,
        freedom_text(total.dof), bare->comparison.rms_percent[0], model.comparison.rms_percent[0],
        value, estimate_text(bare->calibration.fit, 0, "1"));
}

std::string method_sentences(const PageContent& content, const SwitchedModel& model) {
    const Calibration& c = model.calibration;
    const auto dry = static_cast<std::size_t>(
        std::ranges::count_if(c.readings, [](const Reading& r) { return r.condition.dry(); }));
    std::vector<std::string> names;
    for (const Parameter& parameter : c.parameters) {
        names.push_back(parameter_in_words(parameter.name));
    }
    const Fidelity& fidelity = content.options.fidelity;
    return fmt::format(
        "The {} {} fitted with Pendular {} to {} of {} readings ({} dry, {} wet) of shear stress "
        "and solid fraction, by generalised least squares with the covariance of the readings and "
        "of the emulator. The model is a discrete-element simulation of {} grains in simple shear "
        "at imposed normal stress (fidelity {}, stiffness number {:g}), which Gaussian processes "
        "interpolate; they were trained on {} simulations (hash {}).",
        joined(names, "and"), names.size() == 1 ? "was" : "were", content.version, c.fitted,
        c.readings.size(), dry, c.readings.size() - dry, fidelity.grains, fidelity.name,
        fidelity.stiffness_number, content.runs, content.runs_hash);
}

/// Sources of the model and of the effects in it.
std::vector<std::string> references_of(const PageContent& content, const SwitchedModel& model) {
    std::vector<std::string> references = {
        "Badetti, Fall, Chevoir and Roux, Shear strength of wet granular materials: macroscopic "
        "cohesion and effective stress (2018)."};
    for (const ListedEffect& effect : model.calibration.model.effects) {
        for (const std::string& source :
             content.resolved.catalogue().find(effect.name).references) {
            references.push_back(fmt::format("{}: {}.", effect.name, source));
        }
    }
    return references;
}

}  // namespace

PasteTexts paste_texts(const PageContent& content) {
    const auto& current = content.switched.models[content.switched.current];
    if (!current) return {};
    const std::vector<PasteRow> rows = rows_of(*current);
    std::string caution;
    std::vector<std::string> reasons = content.diagnosis.belief.reasons;
    const Diagnosis& diagnosis = content.diagnosis.diagnosis;
    if (!is_of_fitting_model(diagnosis.verdict)) {
        reasons.insert(reasons.begin(),
                       verdict_headline(diagnosis, *content.diagnosis.models, content.checks));
    }
    if (!reasons.empty())
        caution = fmt::format("Not for a paper as it is: {}\n\n", fmt::join(reasons, " "));
    return {.csv = csv_of(rows),
            .latex = latex_of(rows),
            .methods = page_text(fmt::format("{}{} {}\n\nReferences:\n{}\n", caution,
                                             method_sentences(content, *current),
                                             result_sentence(content, *current),
                                             fmt::join(references_of(content, *current), "\n")))};
}

}  // namespace pendular
