#include "reports/diagnosis_report.h"

#include <fmt/format.h>

#include <utility>

#include "reports/failure_report.h"
#include "reports/fit_report.h"
#include "reports/tables.h"
#include "reports/words.h"

namespace pendular {

std::string granted_line(const StudyDiagnosis& study, const Study& stated) {
    if (study.discrepancy == stated.model.discrepancy) return "";
    std::string line =
        "The best explanation leaves differences between conditions: the model counts as inexact "
        "by " +
        discrepancy_text(study.discrepancy);
    const Misfit& expected = study.belief.fitted.misfit;
    if (expected.dof == 0) return line + ".";
    return line +
           fmt::format(
               ", and every chi2 of this diagnosis contains this error. With the {} that 'pendular "
               "calibrate', 'compare', the ladder and the page's switches count, chi2/dof of the "
               "same fit is {:.2f}.",
               discrepancy_text(stated.model.discrepancy), expected.chi2 / expected.dof);
}

std::string inexactness_line(const StudyDiagnosis& study, const Study& stated) {
    const Diagnosis& d = study.diagnosis;
    const double ratio = study.discrepancy[0];
    std::string line = granted_line(study, stated);
    const bool named = d.verdict == Verdict::missing || d.verdict == Verdict::indistinguishable ||
                       d.verdict == Verdict::unknown;
    if (named && d.holds_up_to > 0 && ratio > 0)
        line +=
            fmt::format("{}That something is missing holds {} {:.2g} % of the stress ratio.",
                        line.empty() ? "" : " ",
                        d.holds_up_to == most_inexact ? "even for a model that errs by"
                                                      : "for a model that errs by up to",
                        100 * ratio * d.holds_up_to,
                        d.holds_up_to == most_inexact ? ", the largest error that is tested" : "");
    return line;
}

std::string discrepancy_line(double size, double of_fraction) {
    if (size == 0) return "";
    return fmt::format(
        "If the model stays as it is, an error of about {:.1f} % of its shear stress would explain "
        "the "
        "misfit. Look for the cause before you accept this error. To accept it, write discrepancy "
        "= "
        "[{:.2g}, {:.2g}] into section [model] of study.toml; this enlarges the standard errors "
        "but "
        "corrects no value.",
        100 * size, size, of_fraction);
}

std::string suspects_line(const Diagnosis& d, const Evidence& evidence) {
    std::vector<std::pair<std::string, double>> measurements;
    for (std::size_t k = 0; k < d.suspect_p.size(); ++k) {
        if (d.suspect_p[k] < significant_p) {
            measurements.emplace_back(evidence.suspects[k].name, d.suspect_p[k]);
        }
    }
    return deviating_line(std::move(measurements));
}

std::string fit_line(const Diagnosis& d) {
    return fmt::format(
        "Fitted to all readings: chi2 = {:.1f} for {}. Test for lack of fit: p "
        "{}. "
        "Test for an improvement by a known effect: p {}. (A small p speaks against the model.)",
        d.base.fit.chi2, freedom_text(d.dof), p_text(d.base.lack_of_fit_p),
        p_text(d.base.further_p));
}

}  // namespace pendular
