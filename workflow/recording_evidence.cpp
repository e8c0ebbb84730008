#include "workflow/recording_evidence.h"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <nlohmann/json.hpp>

#include "workflow/json_parts.h"

namespace pendular {
namespace {

/// Quantile of chi2 with one degree of freedom at p = 0.01 [1].
constexpr double significant_reduction = 6.63;
constexpr std::size_t most_sentences = 2;

bool concerns(const RecordingFinding& finding, const Reading& reading) {
    return std::ranges::find(finding.files, reading.origin.file) != finding.files.end() &&
           (finding.step == 0 || finding.step == reading.step);
}

/// Reduction of chi2 by a common factor on the shear stresses (or, for the gap, solid fractions) of
/// the readings that a finding concerns; 0 if no reading is concerned.
double reduction_by(const RecordingFinding& finding, const StudyDiagnosis& d,
                    const WeightedResiduals& residuals) {
    Eigen::VectorXd change = Eigen::VectorXd::Zero(residuals.size());
    const Eigen::Index observable = finding.quantity == "height" ? 1 : 0;
    for (std::size_t k = 0; k < d.readings.size(); ++k) {
        const Eigen::Index entry = 2 * static_cast<Eigen::Index>(k) + observable;
        if (concerns(finding, d.readings[k])) change(entry) = residuals.measured()(entry);
    }
    const Eigen::VectorXd whitened = residuals.project(residuals.whiten(change));
    const double length = whitened.squaredNorm();
    const double product = whitened.dot(residuals.residuals());
    return length > 0 ? product * product / length : 0;
}

}  // namespace

std::vector<RecordingEvidence> recording_evidence(const StudyDiagnosis& d,
                                                  const std::vector<RecordingFinding>& findings) {
    std::vector<RecordingEvidence> result;
    if (findings.empty()) return result;
    const WeightedResiduals residuals = d.diagnosis.residuals(d.evidence);
    const double excess = d.diagnosis.chi2 - d.diagnosis.dof;
    const bool misfit = d.diagnosis.verdict != Verdict::nothing_missing &&
                        d.diagnosis.verdict != Verdict::inconclusive && excess > 0;
    double best_effect = significant_reduction;
    for (const Finding& effect : d.diagnosis.scan)
        best_effect = std::max(best_effect, effect.test.predicted_reduction);
    for (const RecordingFinding& finding : findings) {
        const double reduction = reduction_by(finding, d, residuals);
        const bool always = finding.kind == RecordingFinding::Kind::saturation ||
                            finding.kind == RecordingFinding::Kind::level_change;
        if (!always && reduction < significant_reduction) continue;
        const double share = reduction > 0 && misfit ? std::min(1.0, reduction / excess) : -1;
        result.push_back({finding, share, reduction > best_effect});
    }
    std::ranges::stable_sort(result, std::greater{}, &RecordingEvidence::explains);
    return result;
}

std::string recordings_line(const std::vector<RecordingEvidence>& evidence) {
    if (evidence.empty()) return "";
    std::vector<RecordingFinding> findings;
    for (const RecordingEvidence& each : evidence)
        findings.push_back(each.finding);
    const std::vector<std::string> all = sentences(findings);
    std::string line = "The recordings themselves show:";
    for (std::size_t k = 0; k < std::min(all.size(), most_sentences); ++k)
        line += " " + all[k];
    if (all.size() > most_sentences)
        line += fmt::format(" {} more; 'pendular import' lists them.", all.size() - most_sentences);
    if (evidence.front().explains_most())
        line += fmt::format(
            " This explains {:.0f} % of the misfit: correct it before you add an effect.",
            100 * evidence.front().explains);
    return line;
}

nlohmann::ordered_json to_json(const std::vector<RecordingEvidence>& evidence) {
    nlohmann::ordered_json json = nlohmann::ordered_json::array();
    for (const RecordingEvidence& each : evidence) {
        nlohmann::ordered_json one = findings_json({each.finding}).front();
        one["explains"] =
            each.explains < 0 ? nlohmann::ordered_json() : nlohmann::ordered_json(each.explains);
        json.push_back(std::move(one));
    }
    return json;
}

}  // namespace pendular
